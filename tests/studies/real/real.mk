# SPDX-License-Identifier: MIT
#
# Coins with losses over whole lives: included by the Makefile.

REAL_OUT = $(O)/real
LAUNCHES ?= 10000

.PHONY: real-study
real-study: $(REAL_OUT)/study ## coins to rest: launches, and the time by calls and tolerances
	$< launches $(LAUNCHES)
	$< calls

$(REAL_OUT)/%: $(SRC)/tests/studies/real/%.c $(SRC)/tests/studies/real/laws.h \
               $(SRC)/tests/studies/bench/textbook.c $(SRC)/tests/support/losses.c \
               $(LIB_A) | $(REAL_OUT)
	$(CC_TEST) $(CMOCKA) -I$(SRC)/tests $(LDFLAGS) -o $@ \
	    $(filter %.c,$^) $(filter-out $(O)/tests/support/losses.o,\
	    $(TEST_EXTRA)) $(LIB_A) $(CMOCKA_LIBS) -lm

$(REAL_OUT)/study: $(TEST_EXTRA)

.PHONY: move-study
move-study: $(REAL_OUT)/moves ## coins that slip: how launches end
	$< $(LAUNCHES)
	$< $(LAUNCHES) 1

$(REAL_OUT)/moves: $(SRC)/tests/studies/real/moves.c $(TEST_EXTRA) $(LIB_A) | $(REAL_OUT)
	$(CC_TEST) $(CMOCKA) -D_POSIX_C_SOURCE=200809L -I$(SRC)/tests $(LDFLAGS) -o $@ $(filter %.c,$^) \
	    $(TEST_EXTRA) $(LIB_A) $(CMOCKA_LIBS) -lm

# The functions that tuning counts.
TUNED = coin_priv_try_step coin_priv_within coin_priv_rates \
        coin_priv_extrapolate

.PHONY: tuning
tuning: $(REAL_OUT)/tuning ## what the tuned numbers of lib/ trade: calls and errors (5 minutes)
	$< 500

$(REAL_OUT)/tuning: $(SRC)/tests/studies/real/tuning.c $(TEST_EXTRA) $(LIB_A) | $(REAL_OUT)
	$(CC_TEST) $(CMOCKA) -I$(SRC)/tests -I$(SRC)/lib $(LDFLAGS) \
	    $(TUNED:%=-Wl,--wrap=%) -o $@ $(filter %.c,$^) $(TEST_EXTRA) $(LIB_A) \
	    $(CMOCKA_LIBS) -lm

$(REAL_OUT):
	mkdir -p $@

# A chart of docs/pictures.md.  pictures-check computes its errors again; its
# costs need valgrind.
.PHONY: real-fixed
real-fixed: $(REAL_OUT)/fixed $(REAL_OUT)/study need-gnuplot ## errors and costs to rest, beside fixed steps
	FIXED=$< STUDY=$(REAL_OUT)/study sh $(SRC)/tests/studies/real/fixed.sh \
	    >$(REAL_OUT)/settle.csv
	cp $(REAL_OUT)/settle.csv $(SRC)/docs/figures/data
	gnuplot -e "from='$(REAL_OUT)'" -e "to='$(SRC)/docs/figures'" \
	    -e "style='$(SRC)/tests/studies/bench/style.gpi'" $(SRC)/tests/studies/real/settle.gp
	$(SLIM)

$(REAL_OUT)/fixed: $(SRC)/tests/studies/real/fixed.c $(SRC)/tests/studies/bench/textbook.c \
                   $(LIB_A) | $(REAL_OUT)
	$(CC_TEST) -I$(SRC)/tests $(LDFLAGS) -o $@ $(filter %.c,$^) $(LIB_A) -lm

$(O)/pictures/fixed.csv: $(REAL_OUT)/fixed
	mkdir -p $(@D)
	$< >$@
