/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_NUMBER_H
#define ROLLCOIN_NUMBER_H

#include "precision.h"

#include "number.t.h"

/* 0 for infinity and for NaN: a comparison with NaN is false. */
COIN_PRIV_INLINE int coin_priv_is_finite(number x)
{
    return FABS(x) <= COIN_PRIV_LARGEST;
}

/* The larger of two, b where one is NaN. */
COIN_PRIV_INLINE number coin_priv_larger(number a, number b)
{
    return a > b ? a : b;
}

#endif
