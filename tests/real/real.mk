# SPDX-License-Identifier: MIT
#
# Coins with losses over whole lives: included by the Makefile.

REAL_OUT = $(O)/real
LAUNCHES ?= 10000

.PHONY: real-study real-cost
real-study: $(REAL_OUT)/study ## coins to rest: launches, exponents, error laws
	$< launches $(LAUNCHES)
	$< exponents
	$< nutation
	$< calls
	$< quasi

real-cost: $(REAL_OUT)/study ## instructions to rest, in textbook steps
	STUDY=$(abspath $<) OUT=$(abspath $(REAL_OUT)) \
	    sh $(SRC)/tests/real/cost.sh

$(REAL_OUT)/study: $(SRC)/tests/real/study.c $(SRC)/tests/bench/textbook.c \
                   $(SRC)/tests/support/losses.c $(LIB_A) | $(REAL_OUT)
	$(CC_TEST) $(CMOCKA) -I$(SRC)/tests $(LDFLAGS) -o $@ \
	    $(filter %.c,$^) $(filter-out $(O)/tests/support/losses.o,\
	    $(TEST_EXTRA)) $(LIB_A) $(CMOCKA_LIBS) -lm

$(REAL_OUT)/study: $(TEST_EXTRA)

.PHONY: slide-study
slide-study: $(REAL_OUT)/slides ## coins that slip: launches, cost, and other methods
	$< launches $(LAUNCHES)
	$< cost
	$< rivals

$(REAL_OUT)/slides: $(SRC)/tests/real/slides.c $(TEST_EXTRA) $(LIB_A) | $(REAL_OUT)
	$(CC_TEST) $(CMOCKA) -I$(SRC)/tests $(LDFLAGS) -o $@ $(filter %.c,$^) \
	    $(TEST_EXTRA) $(LIB_A) $(CMOCKA_LIBS) -lm

$(REAL_OUT):
	mkdir -p $@
