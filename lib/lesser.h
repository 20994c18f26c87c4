/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_LESSER_H
#define ROLLCOIN_LESSER_H

#include "pinned.h"

/* The lesser of two, b where one is NaN. */
COIN_PRIV_INLINE double coin_priv_lesser(double a, double b)
{
    return a < b ? a : b;
}

#endif
