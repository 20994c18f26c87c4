# SPDX-License-Identifier: MIT
#
# A directed search for the largest unwarned error: included by the Makefile.
#
#   make adversary                      the gate: four minutes on two cores, the
#                                       same work each time
#   make adversary EVALUATIONS=1000000  ten times as long, by hand
#   make adversary-update               renews tests/studies/bench/results and the table
#                                       of tests/studies/tables.md from the last search;
#                                       the cases stay in build/adversary
#   make adversary-replay               the cases found before, in seconds

ADV_SRC  := $(SRC)/tests/adversary
ADV_OUT   = $(O)/adversary
ADV_OBJ   = $(patsubst $(ADV_SRC)/%.cpp,$(ADV_OUT)/%.o,\
                       $(wildcard $(ADV_SRC)/*.cpp))
ADV_CASES = $(ADV_SRC)/cases.txt

# Of the cheapest functions; the others have a share.  FUNCTION searches those
# whose names contain it.
EVALUATIONS ?= 100000
ADV_SEED    ?= 11
FUNCTION    ?=

$(ADV_OUT):
	mkdir -p $@

$(ADV_OUT)/%.o: $(ADV_SRC)/%.cpp $(O)/flags | $(ADV_OUT)
	echo "CXX $(@F)"
	$(CXX) -std=c++17 -O2 -ffp-contract=off -Wall -Wextra -Wshadow \
	    -I$(SRC)/include $(DEPENDS) -c -o $@ $<

$(ADV_OUT)/adversary: $(ADV_OBJ) $(LIB_A)
	$(CXX) -o $@ $^

.PHONY: adversary adversary-replay adversary-update
adversary: $(ADV_OUT)/adversary ## climb towards the largest unwarned error (EVALUATIONS=1000000: longer)
	half() { $< search $(EVALUATIONS) $(ADV_SEED) $$1 2 $(FUNCTION) \
	    >$(ADV_OUT)/$$1.csv || test $$? = 1; }; \
	half 0 & half 1 && wait $$!
	{ $(BITS); echo '# $(EVALUATIONS) evaluations, seed $(ADV_SEED)'; \
	    echo 'function,evaluations,ratio,law,case'; \
	    cat $(ADV_OUT)/[01].csv; } >$(ADV_OUT)/adversary.csv
	awk -F, '/^coin/ { printf "%-32s %8d  %-9s %s\n", $$1, $$2, $$3, $$4; \
	    if (!($$3 <= 1)) { print "  " $$1 " " $$5; bad = 1 } } \
	    END { exit bad }' $(ADV_OUT)/adversary.csv; found=$$?; \
	$< replay $(ADV_CASES) && exit $$found

adversary-replay: $(ADV_OUT)/adversary ## the cases that searches found, each within its bound
	$< replay $(ADV_CASES)

adversary-update:
	cut -d, -f1-4 $(ADV_OUT)/adversary.csv >$(RESULTS)/adversary.csv
	$(PYTHON) $(BENCH_SRC)/summary.py $(RESULTS) $(SRC)/tests/studies/tables.md
