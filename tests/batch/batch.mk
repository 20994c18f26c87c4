# SPDX-License-Identifier: MIT
#
# Many coins at once: included by the Makefile.
#
#   make lanes      the tests of batches by vectors of every width
#   make sweep      a million coins, drawn for docs/pictures.md  (20 seconds)
#
# `make examples` also runs these, small.  `make batch` measures: bench.mk.

BATCH_SRC := $(SRC)/tests/batch

# lib/motion/vector.h takes the widest vectors that the compiler's flags allow: 16 bytes
# without any flag, as in `make check`.  A processor without the others cannot
# run their tests: the gate then says so, and passes.
LANES       := avx2 avx512f
PROCESSOR    = grep -m1 '^flags' /proc/cpuinfo
LANES_TESTS := $(addprefix tests/test_,$(addsuffix .c,batch range))

.PHONY: lanes $(LANES:%=lanes-%)
lanes: $(LANES:%=lanes-%) ## the tests of batches by vectors of 32 and 64 bytes
$(LANES:%=lanes-%): lanes-%:
	+if $(PROCESSOR) | grep -qw $*; then \
	    $(AGAIN) O=$(O)/lanes-$* check TESTS='$(LANES_TESTS)' \
	        CFLAGS='-O2 -m$*' && echo "lanes: $* passed"; \
	else echo "lanes: *** NOT TESTED: this processor has no $* ***"; fi

.PHONY: run-batches sweep
examples: run-batches

run-batches: $(O)/two_threads $(O)/sweep
	$(O)/two_threads
	$(O)/sweep 200 $(O)/sweep.ppm

sweep: $(O)/sweep need-gnuplot ## a million coins: which fall, and which roll on
	mkdir -p $(O)/sweep-picture
	$(O)/sweep 1000 $(O)/sweep-picture/sweep.ppm
	gnuplot -e "from='$(O)/sweep-picture'" -e "to='$(SRC)/docs/figures'" \
	    $(BATCH_SRC)/sweep.gp
	zopflipng -y --iterations=50 $(SRC)/docs/figures/sweep.png \
	    $(SRC)/docs/figures/sweep.png >/dev/null
