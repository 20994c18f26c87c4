/* SPDX-License-Identifier: MIT */
/* For make msan: what a load of a vector asks (lib/motion/vector.t.h).  The
 * sanitizer's own header includes others, before a test says what it wants of
 * them. */
#ifndef ROLLCOIN_TESTS_READS_H
#define ROLLCOIN_TESTS_READS_H

void __msan_check_mem_is_initialized(const volatile void *from,
                                     __SIZE_TYPE__ bytes);
#define COIN_PRIV_READS __msan_check_mem_is_initialized

#endif
