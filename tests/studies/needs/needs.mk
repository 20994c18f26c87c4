# SPDX-License-Identifier: MIT
#
# Cost and error of each need of docs/choosing.md: included by the Makefile.

NEEDS = $(O)/needs

.PHONY: needs
needs: $(NEEDS)/needs ## what each need costs and errs by, into docs/choosing.md (a minute)
	cd $(NEEDS) && rm -f counts.* && valgrind -q --tool=callgrind \
	    --callgrind-out-file=counts ./needs >rows
	cd $(NEEDS) && ./needs steps >steps
	$(PYTHON) $(SRC)/tests/studies/needs/needs.py $(NEEDS) $(SRC)/docs/choosing.md

$(NEEDS)/needs: $(SRC)/tests/studies/needs/needs.c $(TEST_EXTRA) $(LIB_A)
	mkdir -p $(@D)
	$(CC_TEST) $(CMOCKA) -I$(SRC)/tests $(LDFLAGS) -o $@ $^ $(CMOCKA_LIBS) -lm
