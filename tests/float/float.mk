# SPDX-License-Identifier: MIT
#
# Single precision on a processor that has nothing else: included by the
# Makefile.

ARM ?= arm-none-eabi-gcc

.PHONY: float-check
float-check: ## coinf.h does no double arithmetic, and fits a Cortex-M4F
	+$(GATE) ARM='$(ARM)' sh $(SRC)/tests/float/arm.sh
