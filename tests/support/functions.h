/* SPDX-License-Identifier: MIT */
/* Every public function of coin.h and coinf.h, by one signature: its pointers
 * are in an array, its numbers come from a structure. */
#ifndef ROLLCOIN_TESTS_FUNCTIONS_H
#define ROLLCOIN_TESTS_FUNCTIONS_H

#include <coinf.h>

#include <stddef.h>

enum { POINTERS = 5, MOST_FUNCTIONS = 100, BUFFER = 32768 };

/* What numbers a function is called with, and what its losses, table and body
 * are made for. */
struct numbers {
    size_t index; /* of this case, from 0 */
    coin_params p;
    coin_state s;
    double dt, t; /* a step, and a longer time */
    double mu;
};

/* What a pointer is; of a function of coinf.h, in single precision:
 *   p  parameters, read                P  parameters, written
 *   s  a state, read                   S  a state, moved
 *   c  the state, on the circle of its lean and roll if there is one
 *   q  its quaternion                  w  its angular velocity
 *   o  output, written                 n  output that may be null
 *   r  three doubles, read             b  an orbit, read
 *   l  losses, read                    L  losses, fitted
 *   t  a table, read
 *   g  a body, read                    G  a body, moved */
struct function {
    const char *name, *kinds;
    int32_t (*call)(void *const a[POINTERS], const struct numbers *c);
};

/* The status of a call that returns NaN. */
enum { NOT_A_NUMBER = -1000 };

extern struct function functions[MOST_FUNCTIONS];
extern size_t function_count;

/* Whether it is one of coinf.h. */
int function_is_single(const struct function *f);

/* What a pointer holds. */
union argument {
    unsigned char bytes[BUFFER];
    double aligned;
};

/* Writes what the pointers of a function point to, as far as it reads it. */
void function_arguments(union argument a[POINTERS], const struct function *f,
                        const coin_state *s, const coin_params *p,
                        const struct numbers *c);

#endif
