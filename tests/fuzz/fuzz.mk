# SPDX-License-Identifier: MIT
#
# Fuzzing: included by the Makefile, whose SRC, O, WARN, PINNED and SOURCES it
# uses.
#
#   make fuzz                       a minute, over all targets
#   make fuzz FUZZ_SECONDS=3600     an hour
#   make fuzz FUZZ_TARGETS=steps    one target
#   make fuzz-corpus                the least inputs that reach as much, anew
#
# fuzz_NAME.c is a target: a table of functions.  What it finds stays in
# build/fuzz; `build/fuzz/fuzz_steps FILE` runs one input again.  The kept
# inputs are in corpus.txt, and unpacked to build/fuzz/corpus.

FUZZ_SRC     := $(SRC)/tests/fuzz
FUZZ_OUT      = $(O)/fuzz
FUZZ_SECONDS ?= 60
FUZZ_TARGETS ?= $(patsubst $(FUZZ_SRC)/fuzz_%.c,%,\
                           $(wildcard $(FUZZ_SRC)/fuzz_*.c))

# Only the library tells the fuzzer where it has been; comparisons of doubles
# tell it little for a third of the time.
FUZZ_CC   = clang $(WARN) -Werror -std=c11 -O2 -g $(PINNED) \
            -ffp-exception-behavior=maytrap $(MAPS) -I$(SRC)/include \
            $(FUZZ_SANITIZE)
FUZZ_SANITIZE := -fsanitize=address,undefined,float-cast-overflow \
                 -fno-sanitize-recover=all
FUZZ_TOLD := -fsanitize=fuzzer-no-link -fno-sanitize-coverage=trace-cmp
FUZZ_LIB   = $(patsubst %.c,$(FUZZ_OUT)/lib/%.o,$(notdir $(SOURCES)))
FUZZ_BOTH := $(patsubst %,$(FUZZ_OUT)/%.o,bytes kinds examine)

$(FUZZ_OUT) $(FUZZ_OUT)/lib:
	mkdir -p $@

$(FUZZ_OUT)/lib/%.o: %.c | $(FUZZ_OUT)/lib need-fuzzer
	$(FUZZ_CC) $(FUZZ_TOLD) $(DEPENDS) -c -o $@ $<

$(FUZZ_OUT)/%.o: $(FUZZ_SRC)/%.c | $(FUZZ_OUT) need-fuzzer
	$(FUZZ_CC) $(DEPENDS) -c -o $@ $<

$(FUZZ_TARGETS:%=$(FUZZ_OUT)/fuzz_%): $(FUZZ_OUT)/fuzz_%: $(FUZZ_OUT)/fuzz_%.o \
    $(FUZZ_BOTH) $(FUZZ_LIB)
	$(FUZZ_CC) -fsanitize=fuzzer -o $@ $^ -lm

FUZZ_KEPT   = $(FUZZ_OUT)/corpus
FUZZ_CORPUS = $(PYTHON) $(FUZZ_SRC)/corpus.py

.PHONY: need-fuzzer build-fuzz fuzz fuzz-corpus fuzz-named
need-fuzzer:
	echo 'int LLVMFuzzerTestOneInput(void) {return 0;}' | \
	    clang -x c -fsanitize=fuzzer,address - -o /dev/null || \
	    { echo "fuzzing needs clang and its runtime: sudo apt-get install" \
	    "clang libclang-rt-14-dev"; exit 1; } >&2

build-fuzz: $(FUZZ_TARGETS:%=$(FUZZ_OUT)/fuzz_%)

fuzz-named: # every public function is in a target
	sh $(FUZZ_SRC)/named.sh $(SRC)

fuzz: fuzz-named build-fuzz ## call every function with any bytes (a minute)
	$(FUZZ_CORPUS) unpack $(FUZZ_SRC)/corpus.txt $(FUZZ_KEPT)
	sh $(FUZZ_SRC)/run.sh $(FUZZ_KEPT) $(FUZZ_OUT) \
	    $(FUZZ_SECONDS) $(FUZZ_TARGETS)

fuzz-corpus: build-fuzz
	$(FUZZ_CORPUS) unpack $(FUZZ_SRC)/corpus.txt $(FUZZ_KEPT)
	for t in $(FUZZ_TARGETS); do new=$(FUZZ_OUT)/least/$$t; \
	    kept=$(FUZZ_KEPT)/$$t; rm -rf $$new; \
	    mkdir -p $$new $$kept $(FUZZ_OUT)/found/$$t; \
	    $(FUZZ_OUT)/fuzz_$$t -set_cover_merge=1 -use_counters=0 $$new $$kept \
	        $(FUZZ_OUT)/found/$$t 2>$(FUZZ_OUT)/$$t.merge || exit 1; \
	    rm -rf $$kept; cp -r $$new $$kept; done
	$(FUZZ_CORPUS) pack $(FUZZ_SRC)/corpus.txt $(FUZZ_KEPT)
