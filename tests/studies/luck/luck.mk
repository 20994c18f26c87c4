# SPDX-License-Identifier: MIT
#
# Many tosses, and which side ends up: the numbers and the maps of docs/luck.md.
# Included by the Makefile.  A study is a file of tests/studies/luck with a
# luck_study(); a further one needs nothing here.
#
#   make luck          the numbers, and all figures from them
#   make luck-maps     the maps, which are not kept, drawn anew
#   make luck-small    each study with small counts: what it claims holds
#   make luck-engines  the same tosses by ODE, Bullet and MuJoCo

LUCK_SRC := $(SRC)/tests/studies/luck
LUCK_OUT  = $(O)/luck
LUCK     := $(filter-out luck,$(patsubst $(LUCK_SRC)/%.c,%,\
              $(wildcard $(LUCK_SRC)/*.c)))
# Those that have a map.
LUCK_MAPS := $(shell grep -l luck_draw $(filter-out %/luck.c,\
               $(wildcard $(LUCK_SRC)/*.c)) | xargs -n 1 basename -s .c)

$(LUCK:%=$(LUCK_OUT)/%): $(LUCK_OUT)/%: $(LUCK_SRC)/%.c $(LUCK_SRC)/luck.c \
                         $(LUCK_SRC)/luck.h $(LIB_A) $(O)/flags
	mkdir -p $(@D)
	$(CC_TEST) $(LDFLAGS) -o $@ $(filter %.c,$^) $(LIB_A) -lm -lpthread

.PHONY: luck luck-maps luck-figures luck-small $(LUCK:%=luck-%)
luck: $(LUCK:%=luck-%) ## many tosses, and which side ends up: docs/luck.md (6 minutes)
	+$(AGAIN) luck-maps luck-figures

$(LUCK:%=luck-%): luck-%: $(LUCK_OUT)/% need-bits
	mkdir -p $(BENCH_OUT)
	$(call RESULT,luck_$*,$<)

luck-small: $(LUCK:%=$(LUCK_OUT)/%.small) ## the studies of docs/luck.md, with small counts

$(LUCK_OUT)/%.small: $(LUCK_OUT)/%
	$< small >$@

luck-figures: need-gnuplot ## the curves and tables of docs/luck.md, from the kept results
	$(PYTHON) $(BENCH_SRC)/summary.py $(RESULTS) $(SRC)/docs/luck.md
	gnuplot -e "results='$(RESULTS)'" -e "to='$(SRC)/docs/figures'" \
	    -e "style='$(BENCH_SRC)/style.gpi'" $(LUCK_SRC)/luck.gp
	$(SLIM)

figures: luck-figures

luck-maps: $(LUCK_MAPS:%=$(LUCK_OUT)/%.svg) ## the maps of docs/luck.md (2 minutes)
	cp $^ $(SRC)/docs/figures

$(LUCK_OUT)/%.svg: $(LUCK_OUT)/%.map $(LUCK_SRC)/maps.py
	$(PYTHON) $(LUCK_SRC)/maps.py $* <$< >$@

$(LUCK_OUT)/%.map: $(LUCK_OUT)/%
	$< map >$@

$(LUCK_OUT)/engines: $(LUCK_SRC)/engines.cpp $(LUCK_SRC)/luck.c \
                     $(LUCK_SRC)/luck.h $(BENCH_SRC)/peers/engines.h \
                     $(LIB_A) $(O)/flags | need-engines
	mkdir -p $(@D)
	$(CC_TEST) -c -o $@.o $(LUCK_SRC)/luck.c
	$(ENGINES_CXX) -I$(LUCK_SRC) -o $@ $< $@.o $(ENGINES_LIBS)

.PHONY: luck-engines
luck-engines: $(LUCK_OUT)/engines need-bits ## the same tosses by ODE, Bullet and MuJoCo (15 minutes)
	mkdir -p $(BENCH_OUT)
	$(call RESULT,luck_engines,$<)
