# SPDX-License-Identifier: MIT
#
# Many coins at once: included by the Makefile.
#
#   make sweep      a million coins, drawn for docs/pictures.md  (20 seconds)
#
# `make examples` also runs these, small.  `make batch` measures: bench.mk.

BATCH_SRC := $(SRC)/tests/batch

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
