# SPDX-License-Identifier: MIT
#
# Many coins at once: included by the Makefile.
#
#   make lanes      tests of what computes by vectors, of every width
#   make sweep      a million coins, drawn for docs/pictures.md  (20 seconds)
#
# `make examples` also runs these, small.  `make batch` measures: bench.mk.

BATCH_SRC := $(SRC)/tests/batch

# lib/motion/vector.h takes the widest vectors that the compiler's flags allow: 16 bytes
# without any flag, as in `make check`.  Those of 32 and 64 are in the libraries
# that HWCAPS=1 installs.  A processor that lacks them cannot run their tests:
# the gate then says so, and passes.
NEEDS_x86-64-v3 := avx2
NEEDS_x86-64-v4 := avx512vl
LANES_TESTS     := $(addprefix tests/test_,$(addsuffix .c,batch range traps \
                     traps_edges move settle_calls toss orbit_at))

LANES = lanes-x86-64-v3 lanes-x86-64-v4
.PHONY: lanes $(LANES)
lanes: $(LANES) ## tests of what computes by vectors, of 32 and 64 bytes
$(LANES): lanes-%:
	+if grep -m1 '^flags' /proc/cpuinfo | grep -qw $(NEEDS_$*); then \
	    $(AGAIN) O=$(O)/hwcaps/$* check TESTS='$(LANES_TESTS)' \
	        CFLAGS='$(CFLAGS) -march=$*' && echo "lanes: $* passed"; \
	else echo "lanes: *** NOT TESTED: this processor is no $* ***"; fi

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
