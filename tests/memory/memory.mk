# SPDX-License-Identifier: MIT
#
# The memory and the thread sanitizer: included by the Makefile.
#
#   make msan     the tests; a read of memory that nothing wrote ends them
#   make tsan     threads that step coins of their own with one coin_params
#
# What the memory sanitizer did not compile it does not see write, and so it
# warns of nothing: the tests run on a cmocka of one page, compiled with them.
# To see where such memory came from, -fsanitize-memory-track-origins in MSAN.

MSAN := -O1 -g -Werror -fsanitize=memory -fno-omit-frame-pointer

.PHONY: msan tsan
msan: ## the tests under the memory sanitizer; clang warns of nothing
	+$(AGAIN) O=$(O)/msan check CC=clang CFLAGS='$(MSAN)' PKG_CONFIG=true \
	    CMOCKA=-I$(SRC)/tests/memory CMOCKA_LIBS=

TSAN := -O1 -g -fsanitize=thread -fno-omit-frame-pointer
tsan: ## threads with coins of their own, under the thread sanitizer
	+$(AGAIN) O=$(O)/tsan CC=clang CFLAGS='$(TSAN)' $(O)/tsan/threads
	$(O)/tsan/threads

$(O)/threads: $(SRC)/tests/memory/threads.c $(LIB_A) $(O)/flags
	$(CC_USER) -std=c11 $(MAPS) -I$(SRC)/include -pthread -o $@ $< \
	    $(LDFLAGS) $(LIB_A) -lm
