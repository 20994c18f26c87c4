# SPDX-License-Identifier: MIT
#
# The pages of docs/: included by the Makefile.

.PHONY: first-hour
first-hour: ## what docs/first-hour.md says, from a clean copy to a plot
	+env -u MAKEFLAGS $(PYTHON) $(SRC)/tests/pages/first_hour.py $(SRC) \
	    $(abspath $(O))/first-hour
