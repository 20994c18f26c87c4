# SPDX-License-Identifier: MIT
#
# The pages of docs/: included by the Makefile.

.PHONY: first-hour
first-hour: ## what docs/first-hour.md says, from a clean copy to a plot
	+env -u MAKEFLAGS $(PYTHON) $(SRC)/tests/pages/first_hour.py $(SRC) \
	    $(abspath $(O))/first-hour

.PHONY: proofs
proofs: ## sympy derives the equations of docs/physics.md anew (a minute)
	for proof in $(SRC)/docs/proofs/*.py; do \
	    $(DEBIAN_PYTHON) $$proof || exit 1; done

# What the pages link to, beside one another.
SITE        = $(abspath $(O))/site
SITE_EXTRAS = LICENSE docs/examples docs/figures docs/proofs \
              docs/page/index.html docs/page/preview.jpg

# The pages that README's table names.
IN_ORDER = sed '1,/^\#\# Where to go/d' README.md | \
           grep -o '](docs/[^)\#]*\.md' | cut -c3- | awk '!named[$$0]++'

.PHONY: site
site: ## coin.h and docs/ as a site in build/site, to browse without a network
	command -v doxygen >/dev/null || \
	    { echo "the site needs doxygen: sudo apt-get install doxygen" >&2; exit 1; }
	rm -rf $(SITE)
	mkdir -p $(SITE)
	cd $(SRC) && { cat tests/pages/Doxyfile; echo PROJECT_NUMBER = $(VERSION); \
	    echo INPUT = README.md $$($(IN_ORDER)) CHANGELOG.md include tests/studies; \
	    echo OUTPUT_DIRECTORY = $(SITE); echo HTML_OUTPUT = .; } | doxygen -
	cd $(SRC) && cp -r --parents $(SITE_EXTRAS) $(SITE)
	$(PYTHON) $(SRC)/tests/pages/links.py $(SITE)
