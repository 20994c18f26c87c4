/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_NUMBER_H
#define ROLLCOIN_NUMBER_H

#include "precision.h"

#include "number.t.h"

/* 0 for infinity and for NaN: a comparison with NaN is false. */
COIN_PRIV_INLINE int PRIV(is_finite)(real x)
{
    return FABS(x) <= COIN_PRIV_LARGEST;
}

#endif
