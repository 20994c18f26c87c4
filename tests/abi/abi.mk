# SPDX-License-Identifier: MIT
#
# What programs that are already compiled rest on: included by the Makefile.
# docs/contributing.md says what the baselines are.

# Debian's packages are seen by its own Python only.
DEBIAN_PYTHON ?= /usr/bin/python3
ABI = $(GATE) PYTHON=$(DEBIAN_PYTHON)

.PHONY: abi abi-update abi-seeds
abi: $(LIB_SO) ## nothing changed that compiled programs rest on
	+$(ABI) sh $(SRC)/tests/abi/abi.sh

abi-update: $(LIB_SO) ## accept the ABI of this library as the baseline
	+$(ABI) sh $(SRC)/tests/abi/abi.sh update

abi-seeds: $(LIB_SO) ## break the ABI in many ways: make abi must see each
	+$(ABI) sh $(SRC)/tests/abi/seeds.sh
