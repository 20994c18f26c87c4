# SPDX-License-Identifier: MIT
#
# Coins with losses over whole lives: included by the Makefile.

REAL_OUT = $(O)/real
LAUNCHES ?= 10000

.PHONY: real-study real-quasi quasi-figures real-cost
real-study: $(REAL_OUT)/study ## coins to rest: launches, and the time by calls and tolerances
	$< launches $(LAUNCHES)
	$< calls

real-quasi: $(REAL_OUT)/quasi need-gnuplot need-bits ## errors of the quasi-steady model, and their chart
	$< laws
	{ $(BITS); $< csv; } >$(REAL_OUT)/quasi.csv
	cp $(REAL_OUT)/quasi.csv $(SRC)/tests/bench/results/models_quasi.csv
	+$(AGAIN) quasi-figures

quasi-figures: need-gnuplot
	gnuplot -e "style='$(SRC)/tests/bench/style.gpi'" \
	    -e "from='$(SRC)/tests/bench/results'" \
	    -e "to='$(SRC)/docs/figures'" $(SRC)/tests/real/quasi.gp
	$(SLIM)

figures: quasi-figures

real-cost: $(REAL_OUT)/study $(REAL_OUT)/quasi ## instructions to rest, in textbook steps
	STUDY=$(abspath $<) QUASI=$(abspath $(REAL_OUT)/quasi) OUT=$(abspath $(REAL_OUT)) \
	    sh $(SRC)/tests/real/cost.sh

$(REAL_OUT)/%: $(SRC)/tests/real/%.c $(SRC)/tests/real/laws.h \
               $(SRC)/tests/bench/textbook.c $(SRC)/tests/support/losses.c \
               $(LIB_A) | $(REAL_OUT)
	$(CC_TEST) $(CMOCKA) -I$(SRC)/tests $(LDFLAGS) -o $@ \
	    $(filter %.c,$^) $(filter-out $(O)/tests/support/losses.o,\
	    $(TEST_EXTRA)) $(LIB_A) $(CMOCKA_LIBS) -lm

$(REAL_OUT)/study $(REAL_OUT)/quasi: $(TEST_EXTRA)

.PHONY: slide-study
slide-study: $(REAL_OUT)/slides ## coins that slip: launches, and the cost while they roll
	$< launches $(LAUNCHES)
	$< launches $(LAUNCHES) 1
	$< cost

$(REAL_OUT)/slides: $(SRC)/tests/real/slides.c $(TEST_EXTRA) $(LIB_A) | $(REAL_OUT)
	$(CC_TEST) $(CMOCKA) -D_POSIX_C_SOURCE=200809L -I$(SRC)/tests $(LDFLAGS) -o $@ $(filter %.c,$^) \
	    $(TEST_EXTRA) $(LIB_A) $(CMOCKA_LIBS) -lm

# The functions that tuning counts.
TUNED = coin_priv_dopri8 coin_priv_lossy_try coin_priv_extrapolate_within \
        coin_priv_test_cone coin_priv_stretch_know coin_check \
        coinf_priv_finish_step

.PHONY: tuning
tuning: $(REAL_OUT)/tuning ## what the tuned numbers of lib/ trade: calls and errors (5 minutes)
	$< 500

$(REAL_OUT)/tuning: $(SRC)/tests/real/tuning.c $(SRC)/tests/real/tuning_float.c \
                    $(SRC)/tests/real/tuning.h $(TEST_EXTRA) $(LIB_A) | $(REAL_OUT)
	$(CC_TEST) $(CMOCKA) -I$(SRC)/tests -I$(SRC)/lib $(LDFLAGS) \
	    $(TUNED:%=-Wl,--wrap=%) -o $@ $(filter %.c,$^) $(TEST_EXTRA) $(LIB_A) \
	    $(CMOCKA_LIBS) -lm

$(REAL_OUT):
	mkdir -p $@

# A chart of docs/pictures.md.  pictures-check computes its errors again; its
# costs need valgrind.
.PHONY: real-fixed
real-fixed: $(REAL_OUT)/fixed $(REAL_OUT)/study need-gnuplot ## errors and costs to rest, beside fixed steps
	FIXED=$< STUDY=$(REAL_OUT)/study sh $(SRC)/tests/real/fixed.sh \
	    >$(REAL_OUT)/settle.csv
	cp $(REAL_OUT)/settle.csv $(SRC)/docs/figures/data
	gnuplot -e "from='$(REAL_OUT)'" -e "to='$(SRC)/docs/figures'" \
	    -e "style='$(SRC)/tests/bench/style.gpi'" $(SRC)/tests/real/settle.gp
	$(SLIM)

$(REAL_OUT)/fixed: $(SRC)/tests/real/fixed.c $(SRC)/tests/bench/textbook.c \
                   $(LIB_A) | $(REAL_OUT)
	$(CC_TEST) -I$(SRC)/tests $(LDFLAGS) -o $@ $(filter %.c,$^) $(LIB_A) -lm

$(O)/pictures/fixed.csv: $(REAL_OUT)/fixed
	mkdir -p $(@D)
	$< >$@
