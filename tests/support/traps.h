/* SPDX-License-Identifier: MIT */
/* Calls functions with floating-point exceptions trapped: a division by zero,
 * an invalid operation or an overflow in a call that is not refused fails. */
#ifndef ROLLCOIN_TESTS_TRAPS_H
#define ROLLCOIN_TESTS_TRAPS_H

#include <coinf.h>

/* What a function is called with, and the nearest floats of it. */
struct trap_case {
    size_t index; /* of this case, from 0 */
    coin_params p;
    coin_state s;
    double dt, t; /* a step, and a longer time */
    double mu;
    coinf_params fp;
    coinf_state fs;
    float fdt, fmu;
};

struct trap_function {
    const char *name;
    int32_t (*call)(const struct trap_case *c); /* its status */
};

/* A function that calls another one by an expression of c, and its row. */
#define CALL(name, expression)                                                 \
    static int32_t call_##name(const struct trap_case *c)                      \
    {                                                                          \
        (void)c;                                                               \
        return expression;                                                     \
    }
#define ROW(name)                                                              \
    {                                                                          \
#name, call_##name                                                     \
    }

/* Calls all functions with ordinary, extreme and random arguments.  Fails if a
 * function never succeeds. */
void traps_run(const struct trap_function *functions, size_t count);

/* Fails unless each symbol of lib/about/rollcoin.map that begins with the
 * prefix has a row of its name, or rows whose names begin with it. */
void traps_are_complete(const char *prefix,
                        const struct trap_function *functions, size_t count);

#endif
