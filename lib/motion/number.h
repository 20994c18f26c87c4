/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_NUMBER_H
#define ROLLCOIN_NUMBER_H

#include "precision.h"

#include "number.t.h"

/* The lesser of two, b where one is NaN. */
COIN_PRIV_INLINE number coin_priv_lesser(number a, number b)
{
    return a < b ? a : b;
}

/* The larger of two, b where one is NaN. */
COIN_PRIV_INLINE number coin_priv_larger(number a, number b)
{
    return a > b ? a : b;
}

#endif
