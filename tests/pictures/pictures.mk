# SPDX-License-Identifier: MIT
#
# The pictures of docs/pictures.md: included by the Makefile.  Each comes from
# a program of docs/examples, which prints its numbers.

PICTURES     := rosettes potential bifurcation precession nearly_flat rest \
                rocking slides
# The numbers of paths are large, and their drawings show all of them.
KEPT         := $(filter-out rosettes slides,$(PICTURES))
# Drawn by their programs.
DRAWN         = $(patsubst %,$(PICTURES_OUT)/%.svg,animation ghosts \
                  slip_map toss_map lean_map)
PICTURES_SRC := $(SRC)/tests/pictures
PICTURES_OUT  = $(O)/pictures
SCHEMES       = $(PYTHON) $(PICTURES_SRC)/scheme.py $(SRC)

.PHONY: pictures pictures-check schemes need-gnuplot
$(PICTURES_OUT)/%.csv: $(O)/%
	mkdir -p $(@D)
	$< >$@

$(PICTURES_OUT)/%.svg: $(O)/%
	mkdir -p $(@D)
	$< >$@

pictures: $(PICTURES:%=$(PICTURES_OUT)/%.csv) $(DRAWN) need-gnuplot ## compute and draw what docs/pictures.md shows
	mkdir -p $(SRC)/docs/figures/data
	cp $(KEPT:%=$(PICTURES_OUT)/%.csv) $(SRC)/docs/figures/data
	cp $(DRAWN) $(SRC)/docs/figures
	for f in $(PICTURES); do gnuplot -e "from='$(PICTURES_OUT)'" \
	    -e "style='$(SRC)/tests/studies/bench/style.gpi'" \
	    -e "to='$(SRC)/docs/figures'" $(PICTURES_SRC)/$$f.gp || exit 1; done
	$(SLIM)

figures: pictures

schemes: ## titles and a dark scheme for every drawing of docs/figures
	$(SCHEMES)

# Small, since each pixel is worked out again.
$(PICTURES_OUT)/sweep.ppm: $(O)/sweep
	mkdir -p $(@D)
	$< 40 $@ >/dev/null

pictures-check: $(PICTURES:%=$(PICTURES_OUT)/%.csv) $(PICTURES_OUT)/sweep.ppm $(DRAWN) $(PICTURES_OUT)/fixed.csv ## the numbers behind the pictures against closed forms
	$(PYTHON) $(PICTURES_SRC)/check.py $(PICTURES_OUT) \
	    $(SRC)/docs/figures/data
	$(SCHEMES) --check

need-gnuplot:
	command -v gnuplot >/dev/null || { echo "the pictures need gnuplot:" \
	    "sudo apt-get install gnuplot-nox" >&2; exit 1; }
