/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_NUMBER_H
#define ROLLCOIN_NUMBER_H

#include "pinned.h"

#include <stddef.h>

/* A number that is the same for all coins, where lanes.c makes of each double
 * as many as there are coins side by side. */
typedef double coin_priv_shared;

/* Copies a struct of doubles, one by one.  The wider moves that an assignment
 * is made of wait until what was just written has left the processor's store
 * buffer: 10 ns each. */
COIN_PRIV_INLINE void coin_priv_copy(void *to, const void *from, size_t size)
{
    double *const numbers = (double *)to;
#pragma GCC unroll 17
    for (size_t i = 0; i < size / sizeof(double); ++i)
        numbers[i] = ((const double *)from)[i];
}

/* The lesser of two, b where one is NaN. */
COIN_PRIV_INLINE double coin_priv_lesser(double a, double b)
{
    return a < b ? a : b;
}

#endif
