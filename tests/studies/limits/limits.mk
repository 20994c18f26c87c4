# SPDX-License-Identifier: MIT
#
# Whether a wrong answer ever comes without a word: included by the Makefile.
#
#   make silent     1.05 million random runs and what became of them; renews
#                   the results and tables.md
#   make endurance  1e9 steps against closed forms
#
# The seeds by which claims and limits were set are not those that judge.

LIMITS_SRC := $(SRC)/tests/studies/limits
LIMITS_OUT  = $(O)/limits
STEPS_RUNS  = 3001 300000
JUDGE_RUNS  = 20261125 1050000

$(LIMITS_OUT):
	mkdir -p $@

LIMITS_PROGS = $(LIMITS_OUT)/silent $(LIMITS_OUT)/endurance
$(LIMITS_PROGS): $(LIMITS_OUT)/%: $(LIMITS_SRC)/%.c $(TEST_EXTRA) $(LIB_A) \
                 | $(LIMITS_OUT) need-cmocka
	$(CC_TEST) $(CMOCKA) $(DEPENDS) -o $@ $< $(LDFLAGS) $(TEST_EXTRA) \
	    $(LIB_A) $(CMOCKA_LIBS) -lm

-include $(LIMITS_PROGS:=.d)

.PHONY: silent endurance endurance-roll endurance-circle
endurance: endurance-roll endurance-circle ## 1e9 steps twice, against closed forms (40 s each)
endurance-roll endurance-circle: endurance-%: $(LIMITS_OUT)/endurance
	$< endurance $*

silent: $(LIMITS_OUT)/silent need-bits ## count silent wrong answers in 1.05 million runs (half an hour)
	{ $(BITS); echo '# seed and runs: $(STEPS_RUNS)'; \
	    $< steps $(STEPS_RUNS); } >$(LIMITS_OUT)/silent_steps.csv
	{ $(BITS); echo '# seed and runs: $(JUDGE_RUNS)'; \
	    $< judge $(JUDGE_RUNS); } >$(LIMITS_OUT)/silent.csv
	cp $(LIMITS_OUT)/silent*.csv $(RESULTS)
	$(PYTHON) $(BENCH_SRC)/summary.py $(RESULTS) $(STUDIED)
