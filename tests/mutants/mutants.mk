# SPDX-License-Identifier: MIT
#
# Broken libraries, which the tests must notice: included by the Makefile.
#
#   make mutants                        all of mutants.txt   (an hour)
#   make mutants MUTANTS='rk4.c run.c'  those of these files

.PHONY: mutants
mutants: ## break the library in many ways: the tests must notice each
	$(PYTHON) $(SRC)/tests/mutants/mutants.py $(SRC) $(O)/mutants $(MUTANTS)

# What mutants.py links all tests to once: a mutant changes this file alone,
# but for tests that see a changed header.
$(O)/mutant.so: $(OBJECTS)
	$(CC_LIB) -shared -o $@ $(OBJECTS) -lm
