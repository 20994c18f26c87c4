# SPDX-License-Identifier: MIT
#
# The library as one header: included by the Makefile.

.PHONY: single-check
single-check: dist build-tests ## all tests on the single header, as C++
	+$(GATE) SINGLE=$(abspath $(SINGLE)) RELEASE=$(abspath $(SINGLES)) \
	    TESTS='$(abspath $(TEST_NAMES:=.o) $(TEST_EXTRA))' \
	    CMOCKA_LIBS="$(CMOCKA_LIBS)" sh $(SRC)/tests/single/single.sh
