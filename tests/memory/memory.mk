# SPDX-License-Identifier: MIT
#
# The memory and the thread sanitizer: included by the Makefile.
#
#   make msan     the tests; a read of memory that nothing wrote ends them; also
#                 those of vectors of 32 bytes, each lane of which is checked
#   make tsan     threads that step coins of their own with one coin_params
#
# What the memory sanitizer did not compile it does not see write, and so it
# warns of nothing: the tests run on a cmocka of one page, compiled with them.
# To see where such memory came from, -fsanitize-memory-track-origins in MSAN.

MSAN := -O1 -g -Werror -fsanitize=memory -fno-omit-frame-pointer \
        -include $(SRC)/tests/memory/reads.h

.PHONY: msan tsan
msan: ## the tests under the memory sanitizer; clang warns of nothing
	+$(MSAN_CHECK) O=$(O)/msan CFLAGS='$(MSAN)'
	+if grep -m1 '^flags' /proc/cpuinfo | grep -qw avx2; then \
	    $(MSAN_CHECK) O=$(O)/msan-avx2 CFLAGS='$(MSAN) -mavx2' \
	        TESTS='$(LANES_TESTS)'; \
	else echo "msan: *** NO AVX2: vectors of 32 bytes are NOT TESTED ***"; fi
MSAN_CHECK = $(AGAIN) check CC=clang PKG_CONFIG=true \
             CMOCKA=-I$(SRC)/tests/memory CMOCKA_LIBS=

TSAN := -O1 -g -fsanitize=thread -fno-omit-frame-pointer
tsan: ## threads with coins of their own, under the thread sanitizer
	+$(AGAIN) O=$(O)/tsan CC=clang CFLAGS='$(TSAN)' $(O)/tsan/threads
	$(O)/tsan/threads

$(O)/threads: $(SRC)/tests/memory/threads.c $(LIB_A) $(O)/flags
	$(CC_USER) -std=c11 $(MAPS) -I$(SRC)/include -pthread -o $@ $< \
	    $(LDFLAGS) $(LIB_A) -lm
