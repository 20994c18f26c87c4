/* SPDX-License-Identifier: MIT */
/* Every public function with a status, behind one signature: its pointers in
 * an array, its scalars good ones. */
#ifndef ROLLCOIN_TESTS_FUNCTIONS_H
#define ROLLCOIN_TESTS_FUNCTIONS_H

#include <stddef.h>
#include <stdint.h>

enum { POINTERS = 5 };

/* What a pointer is:
 *   p  parameters, read                 P  parameters, written
 *   s  a state, read                    S  a state, moved
 *   o  output, written                  n  output that may be null
 *   d  four doubles, read              b  an orbit, read
 *   l  losses, read */
struct function {
    const char *name, *kinds;
    int32_t (*call)(void *const a[POINTERS]);
};

extern const struct function functions[];
extern const size_t function_count;

#endif
