# SPDX-License-Identifier: MIT
#
# A bound on what a step and any other call costs: included by the Makefile.
#
#   make bound           instructions over random states, held against the docs
#                        and against coin.h
#   make bound-update    write them there
#
# Counted by callgrind in the library as CC and CFLAGS make it; the table is
# gcc 12's at -O2.

BOUND_SRC := $(SRC)/tests/bound
BOUND_RUN = valgrind --tool=callgrind --collect-atstart=no \
            --combine-dumps=yes --compress-strings=no --dump-line=no \
            --callgrind-out-file=$(O)/bound.out $(O)/tests/bound

.PHONY: bound bound-update bound-measure
bound: bound-measure ## what steps cost, against the docs, and other calls, against coin.h
	$(PYTHON) $(BOUND_SRC)/bound.py $(O)/bound.out \
	    $(SRC)/tests/studies/tables.md $(SRC)/include

bound-update: bound-measure
	$(PYTHON) $(BOUND_SRC)/bound.py $(O)/bound.out \
	    $(SRC)/tests/studies/tables.md $(SRC)/include update

bound-measure: $(O)/tests/bound
	rm -f $(O)/bound.out
	$(BOUND_RUN) >$(O)/bound.log 2>&1 || { tail $(O)/bound.log; exit 1; }

$(O)/bound.o: $(BOUND_SRC)/bound.c $(O)/flags | $(O)/tests/support
	$(CC_TEST) $(CMOCKA) $(DEPENDS) -c -o $@ $<

$(O)/tests/bound: $(O)/bound.o $(TEST_EXTRA) $(LIB_A)
	$(CC_TEST) $(LDFLAGS) -o $@ $^ $(CMOCKA_LIBS) -lm
