/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_ANGLES_H
#define ROLLCOIN_ANGLES_H

#include "number.h"

/* For one double, a vector of two evaluates the polynomials of sine and of
 * cosine together, if the compiler has such vectors. */
#if COIN_PRIV_WIDTH && !defined(COIN_PRIV_FLOAT)
#define COIN_PRIV_PAIR
#include "vector_names.h"

#include "number.t.h"

#include "angles.t.h"
#undef COIN_PRIV_PAIR
#define COIN_PRIV_BY_PAIRS
#endif

#include "angles.t.h"
#undef COIN_PRIV_BY_PAIRS

/* The most by which a step may turn lean or heading: a step that turns them
 * further has missed what happens on the way.  It is below pi/2, up to which
 * coin_priv_turned() is accurate. */
#define COIN_PRIV_TURN_MAX 1.5

/* sine_cosine() as a function, for sources that call it often. */
coin_priv_sc coin_priv_sincos(number x);

/* The angle in [-pi, pi] with this sine and cosine.  Pre: their norm is 1.
 * Accuracy: 2^-52 for angles up to pi/2 (test_sincos); NaN for NaN. */
number coin_priv_angle(coin_priv_sc pair);

/* sqrt(a^2 + b^2) without overflow or underflow on the way. */
static inline number coin_priv_hypot(number a, number b)
{
    const number x = FABS(a), y = FABS(b);
    const number large = x > y ? x : y, small = x > y ? y : x;
    const number ratio = large > 0 ? small / large : 0;
    return large * SQRT(1 + ratio * ratio);
}

#endif
