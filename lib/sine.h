/* SPDX-License-Identifier: MIT */
/* Sine and cosine of any angle but for the quarter turns in it. */
#ifndef ROLLCOIN_SINE_H
#define ROLLCOIN_SINE_H

#include "precision.h"

typedef struct coin_priv_sc {
    double s, c;
} coin_priv_sc;

/* sin(x + y), |x + y| <= pi/4, |y| <= ulp(x). */
static inline double coin_priv_sine(double x, double y)
{
    const double z = x * x;
    const double p = COIN_PRIV_SINE(z);
    return x + (x * z * p + y * (1.0 - 0.5 * z));
}

/* cos(x + y), likewise; 1 - z/2 is summed with its rounding error. */
static inline double coin_priv_cosine(double x, double y)
{
    const double z = x * x;
    const double p = COIN_PRIV_COSINE(z);
    const double w = 1.0 - 0.5 * z;
    return w + (((1.0 - w) - 0.5 * z) + (z * z * p - x * y));
}

/* Those of x - *n pi/2, with *n whole: x = n pi/2 + (hi + lo), Cody and Waite;
 * t is exact. */
static inline coin_priv_sc coin_priv_sincos_rest(double *n, double x)
{
    *n =
        (x * (1.0 / COIN_PRIV_HALF_PI) + COIN_PRIV_ROUNDER) - COIN_PRIV_ROUNDER;
    const double t = (x - *n * COIN_PRIV_P1) - *n * COIN_PRIV_P2;
    const double r3 = t - *n * COIN_PRIV_P3;
    const double hi = r3 - *n * COIN_PRIV_P4;
    const double lo =
        ((r3 - hi) - *n * COIN_PRIV_P4) + ((t - r3) - *n * COIN_PRIV_P3);
    const coin_priv_sc rest = {
        coin_priv_sine(hi, lo),
        coin_priv_cosine(hi, lo),
    };
    return rest;
}

#endif
