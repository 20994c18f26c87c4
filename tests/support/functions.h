/* SPDX-License-Identifier: MIT */
/* Every public function that returns a status, by one signature: its pointers
 * are in an array, and its other arguments are valid. */
#ifndef ROLLCOIN_TESTS_FUNCTIONS_H
#define ROLLCOIN_TESTS_FUNCTIONS_H

#include <stddef.h>
#include <stdint.h>

enum { POINTERS = 5, MOST_FUNCTIONS = 64 };

/* What a pointer is:
 *   p  parameters, read                 P  parameters, written
 *   s  a state, read                    S  a state, moved
 *   o  output, written                  n  output that may be null
 *   d  four doubles, read              b  an orbit, read
 *   l  losses, read
 *   t  a table, read
 *   g  a body, read                    G  a body, moved */
struct function {
    const char *name, *kinds;
    int32_t (*call)(void *const a[POINTERS]);
};

extern struct function functions[MOST_FUNCTIONS];
extern size_t function_count;

#endif
