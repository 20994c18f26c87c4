# SPDX-License-Identifier: MIT
#
# Coins with losses over whole lives: included by the Makefile.

REAL_OUT = $(O)/real
LAUNCHES ?= 10000

.PHONY: real-study real-quasi real-cost
real-study: $(REAL_OUT)/study ## coins to rest: launches, and the time by calls and tolerances
	$< launches $(LAUNCHES)
	$< calls

real-quasi: $(REAL_OUT)/quasi need-gnuplot need-bits ## errors of the quasi-steady model, and their chart
	$< laws
	{ $(BITS); $< csv; } >$(REAL_OUT)/quasi.csv
	cp $(REAL_OUT)/quasi.csv $(SRC)/tests/bench/results/models_quasi.csv
	+$(AGAIN) models-figures

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

$(REAL_OUT):
	mkdir -p $@
