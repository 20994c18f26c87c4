# SPDX-License-Identifier: MIT
#
# The bindings of docs/examples: included by the Makefile.  CXX, RUSTC, CARGO
# and BINDGEN name the tools; Debian's do.

RUSTC   ?= rustc
CARGO   ?= cargo
BINDGEN ?= bindgen
FFI = $(GATE) CXX='$(CXX)' PYTHON=$(DEBIAN_PYTHON) RUSTC='$(RUSTC)' \
      CARGO='$(CARGO)' BINDGEN='$(BINDGEN)'

.PHONY: bindings bindings-update bindings-seeds bindings-cost sweeps
bindings: $(LIB_A) $(LIB_SO) $(O)/quarter $(O)/many_tosses ## C++, Python and Rust are as coin.h says, and roll the quarter
	+$(FFI) sh $(SRC)/tests/ffi/ffi.sh

bindings-update: ## write the declarations of Python, Rust, C# and JavaScript from coin.h
	+$(FFI) sh $(SRC)/tests/ffi/ffi.sh update

bindings-seeds: $(LIB_SO) ## let coin.h and the bindings drift apart: make bindings must see it
	+$(FFI) sh $(SRC)/tests/ffi/seeds.sh

sweeps: ## a map has one hash by one process, Dask and MPI, though workers are killed
	+$(FFI) sh $(SRC)/tests/ffi/sweeps.sh

bindings-cost: $(LIB_A) $(LIB_SO) ## what a call costs from C, C++, Rust and Python
	+$(FFI) sh $(SRC)/tests/ffi/cost.sh
