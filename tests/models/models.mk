# SPDX-License-Identifier: MIT
#
# The ladder of models, measured: included by the Makefile.

MODELS_SRC := $(SRC)/tests/models
MODELS_OUT  = $(O)/models

.PHONY: models models-figures
MODELS_BY   = $(MODELS_SRC)/*.c $(TEST_EXTRA) $(O)/bench/portable/textbook.o
$(MODELS_OUT)/study: $(wildcard $(MODELS_SRC)/*.[ch]) $(TEST_EXTRA) $(LIB_A) \
                     $(O)/bench/portable/textbook.o
	mkdir -p $(@D)
	$(CC_TEST) -I$(SRC)/tests -I$(MODELS_SRC) $(CMOCKA) $(LDFLAGS) -o $@ \
	    $(MODELS_BY) $(LIB_A) $(CMOCKA_LIBS) -lm

models: $(MODELS_OUT)/study need-gnuplot need-bits ## 30,000 scenes and their models, and the errors of each (5 minutes)
	{ $(BITS); $< choice 10000; } >$(MODELS_OUT)/models_choice.csv
	{ $(BITS); $< unstable 20000; } >$(MODELS_OUT)/models_unstable.csv
	{ $(BITS); $< errors; } >$(MODELS_OUT)/models_errors.csv
	{ $(BITS); $< costs; } >$(MODELS_OUT)/models_costs.csv
	mkdir -p $(SRC)/tests/bench/results
	cp $(MODELS_OUT)/*.csv $(SRC)/tests/bench/results
	+$(AGAIN) models-figures

models-figures: need-gnuplot
	gnuplot -e "style='$(SRC)/tests/bench/style.gpi'" \
	    -e "from='$(SRC)/tests/bench/results'" \
	    -e "to='$(SRC)/docs/figures'" $(MODELS_SRC)/models.gp
	$(SLIM)

figures: models-figures
