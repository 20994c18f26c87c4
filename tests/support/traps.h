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

/* Defines what calls a function, and adds it to those that are called: its
 * status, by c. */
#define CALLS(name)                                                            \
    static int32_t call_##name(const struct trap_case *c);                     \
    __attribute__((constructor)) static void add_##name(void)                  \
    {                                                                          \
        traps_add(#name, call_##name);                                         \
    }                                                                          \
    static int32_t call_##name(const struct trap_case *c)

/* The same by an expression of c. */
#define CALL(name, expression)                                                 \
    CALLS(name)                                                                \
    {                                                                          \
        (void)c;                                                               \
        return expression;                                                     \
    }

void traps_add(const char *name, int32_t (*call)(const struct trap_case *c));

/* Calls all functions with ordinary, extreme and random arguments.  Fails if a
 * function never succeeds. */
void traps_run(void);

/* Fails unless each symbol of lib/about/rollcoin.map is called, or some whose
 * names begin with it. */
void traps_are_complete(void);

#endif
