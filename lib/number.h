/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_NUMBER_H
#define ROLLCOIN_NUMBER_H

#include "pinned.h"

/* A number that is the same for all coins, where lanes.c makes of each double
 * as many as there are coins side by side. */
typedef double coin_priv_shared;

/* The lesser of two, b where one is NaN. */
COIN_PRIV_INLINE double coin_priv_lesser(double a, double b)
{
    return a < b ? a : b;
}

#endif
