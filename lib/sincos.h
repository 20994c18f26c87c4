/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_SINCOS_H
#define ROLLCOIN_SINCOS_H

#include "sine.h"

#include <math.h>

/* Sine and cosine of x, |x| <= COIN_PRIV_ANGLE_MAX; beyond, infinite or NaN:
 * both NaN.  Accuracy: 1 ulp for |x| <= 2^20, near multiples of pi/2 too
 * (test_sincos).  Unlike libm's, the same bits everywhere. */
coin_priv_sc coin_priv_sincos(double x);

/* The angle in [-pi, pi] whose sine and cosine are a pair of unit norm.
 * Accuracy: 2^-52 for angles up to pi/2 (test_sincos); NaN for NaN. */
double coin_priv_angle(coin_priv_sc of);

/* sqrt(a^2 + b^2) without overflow or underflow on the way. */
static inline double coin_priv_hypot(double a, double b)
{
    const double x = fabs(a), y = fabs(b);
    const double large = x > y ? x : y, small = x > y ? y : x;
    const double ratio = large > 0 ? small / large : 0;
    return large * sqrt(1 + ratio * ratio);
}

#endif
