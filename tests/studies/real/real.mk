# SPDX-License-Identifier: MIT
#
# Coins with losses over whole lives, and what tuned numbers trade: included by
# the Makefile.

REAL_SRC := $(SRC)/tests/studies/real
REAL_OUT  = $(O)/real

$(REAL_OUT):
	mkdir -p $@

# The functions that tuning counts.
TUNED = coin_priv_try_step coin_priv_within coin_priv_rates \
        coin_priv_contact_margin coin_priv_hold_margin \
        coin_priv_first_touch coin_priv_extrapolate

TUNING      = $(CC_TEST) $(LDFLAGS) $(TUNED:%=-Wl,--wrap=%)
TUNING_LIBS = $(TEST_EXTRA) $(LIB_A) $(CMOCKA_LIBS) -lm

.PHONY: tuning
tuning: export COMPILE   = $(CC_LIB)
tuning: export LINK      = $(TUNING) $(REAL_OUT)/tuning.o
tuning: export LIBRARIES = $(TUNING_LIBS)
tuning: $(REAL_OUT)/tuning ## what the tuned numbers of lib/ trade: calls and errors (20 minutes)
	$< 500
	$(PYTHON) $(REAL_SRC)/constants.py $(REAL_SRC)/constants.txt $(SRC)/lib \
	    $(REAL_OUT) 200 $(SRC)/tests/studies/tables.md $(NUMBERS)

$(REAL_OUT)/tuning.o: $(REAL_SRC)/tuning.c | $(REAL_OUT)
	$(CC_TEST) $(CMOCKA) -I$(SRC)/tests -I$(SRC)/lib -c -o $@ $<

$(REAL_OUT)/tuning: $(REAL_OUT)/tuning.o $(TEST_EXTRA) $(LIB_A)
	$(TUNING) -o $@ $< $(TUNING_LIBS)

# The chart of a life with losses.  pictures-check computes its errors again; its
# costs need valgrind.
.PHONY: real-fixed
real-fixed: $(REAL_OUT)/fixed need-gnuplot ## errors and costs to rest, beside fixed steps
	FIXED=$< sh $(REAL_SRC)/fixed.sh >$(REAL_OUT)/settle.csv
	cp $(REAL_OUT)/settle.csv $(SRC)/docs/figures/data
	gnuplot -e "from='$(REAL_OUT)'" -e "to='$(SRC)/docs/figures'" \
	    -e "style='$(BENCH_SRC)/style.gpi'" $(REAL_SRC)/settle.gp
	$(SLIM)

$(REAL_OUT)/fixed: $(REAL_SRC)/fixed.c $(SRC)/tests/studies/bench/textbook.c \
                   $(LIB_A) | $(REAL_OUT)
	$(CC_TEST) -I$(SRC)/tests $(LDFLAGS) -o $@ $(filter %.c,$^) $(LIB_A) -lm

$(O)/pictures/fixed.csv: $(REAL_OUT)/fixed
	mkdir -p $(@D)
	$< >$@
