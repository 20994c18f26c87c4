/* SPDX-License-Identifier: MIT */
/* Constants that depend on the width of a number. */
#ifndef ROLLCOIN_PRECISION_H
#define ROLLCOIN_PRECISION_H

#include "kind.h"

#include <coin.h>
#include <float.h>
#include <math.h>

#ifdef COIN_PRIV_FLOAT
#include <coinf.h>

/* ---------------------------------------------------------------- angles -- */

/* Beyond this the product of a number of quarter turns and a part of pi/2
 * would round; a state's own angles stay within half a turn. */
#define COIN_PRIV_ANGLE_MAX 4096.0f

/* The float nearest to pi/2, which lies 4.4e-8 above it, and the rest. */
#define COIN_PRIV_HALF_PI 1.57079637f
#define COIN_PRIV_HALF_PI_LOW -4.37113900e-8f

/* pi/2 = P1 + P2 + P3 + P4: three parts of 12 bits, so that n times a part is
 * exact for |n| < 2^12, and a rest. */
#define COIN_PRIV_P1 1.5703125f
#define COIN_PRIV_P2 4.83751297e-4f
#define COIN_PRIV_P3 7.54953362e-8f
#define COIN_PRIV_P4 2.56334407e-12f

/* Adding and subtracting 1.5 2^23 rounds to the nearest integer, which the last
 * bits of the sum hold. */
#define COIN_PRIV_ROUNDER 12582912.0f

/* The bit of the sign, and all others. */
#define COIN_PRIV_SIGN INT32_MIN
#define COIN_PRIV_ALL_BUT_SIGN INT32_MAX

#define COIN_PRIV_EPSILON FLT_EPSILON

/* (sin(x)/x - 1)/z with z = x^2 and |x| <= pi/4: the Taylor polynomial to
 * x^9, whose next term is 2e-9. */
#define COIN_PRIV_SINE(z)                                                      \
    (-1.0f / 6 + z * (1.0f / 120 + z * (-1.0f / 5040 + z * (1.0f / 362880))))

/* (cos(x) - 1 + z/2)/z^2, likewise to x^10. */
#define COIN_PRIV_COSINE(z)                                                    \
    (1.0f / 24 + z * (-1.0f / 720 + z * (1.0f / 40320 + z * (-1.0f / 3628800))))

/* ---------------------------------------------------------------- limits -- */

/* Mass, radius and gravity lie between these. */
#define COIN_PRIV_LEAST 1e-8f
#define COIN_PRIV_MOST 1e8f

/* The largest component of an angular velocity, in sqrt(g/a), and the largest x
 * and z, in radii. */
#define COIN_PRIV_RATE_MAX 1e3f
#define COIN_PRIV_PLACE_MAX 1e6f

/* The longest time of a call, in natural units. */
#define COIN_PRIV_TIME_MAX 1e6f

/* A shorter step counts as one of this length where 1/dt^2 is computed. */
#define COIN_PRIV_DT_LEAST 1e-18f

/* A thickness, if not 0, lies between these, in radii: in floats none. */
#define COIN_PRIV_LEAST_THICKNESS 1e-4f
#define COIN_PRIV_MOST_THICKNESS 0

/* I_Z may be this part larger than 2 I_X, for the rounding of both. */
#define COIN_PRIV_INERTIA_SLACK 1e-6f

/* Whether the remainders that a state keeps are in range.  The remainder of an
 * angle within half a turn is below 2^-22, so that three add up to less than
 * 2^-20.  Larger ones are refused, because stages use them to first order. */
#define COIN_PRIV_LOW_IN_RANGE(s) coinf_priv_low_in_range((s)->low)
static inline int coinf_priv_low_in_range(const float low[8])
{
    const float angles = fabsf(low[0]) + fabsf(low[1]) + fabsf(low[2]);
    const float others = fabsf(low[3]) + fabsf(low[4]) + fabsf(low[5]) +
                         fabsf(low[6]) + fabsf(low[7]);
    return angles <= 1.0f / 1048576 && others <= FLT_MAX;
}

/* The end of a state's initializer: remainders of 0. */
#define COIN_PRIV_NO_LOW                                                       \
    ,                                                                          \
    {                                                                          \
        0, 0, 0, 0, 0, 0, 0, 0                                                 \
    }

/* ---------------------------------------------------------------- series -- */

/* Terms below this part of their sum no longer change it. */
#define COIN_PRIV_NEGLIGIBLE 1e-9f

#else

/* ---------------------------------------------------------------- angles -- */

/* Beyond this an angle's own rounding (2^-22) is a visible turn. */
#define COIN_PRIV_ANGLE_MAX 2147483648.0

/* The double nearest to pi/2, which lies 6.1e-17 below it, and the rest. */
#define COIN_PRIV_HALF_PI 1.5707963267948966
#define COIN_PRIV_HALF_PI_LOW 6.123233995736766e-17

/* pi/2 = P1 + P2 + P3 + P4: three parts of 22 bits, so that n times a part is
 * exact for |n| < 2^31, and a rest. */
#define COIN_PRIV_P1 1.570796012878418
#define COIN_PRIV_P2 3.139164164167596e-07
#define COIN_PRIV_P3 6.223371969669989e-14
#define COIN_PRIV_P4 2.0222662487959506e-21

/* Adding and subtracting 1.5 2^52 rounds to the nearest integer, which the last
 * bits of the sum hold. */
#define COIN_PRIV_ROUNDER 6755399441055744.0

/* The bit of the sign, and all others. */
#define COIN_PRIV_SIGN INT64_MIN
#define COIN_PRIV_ALL_BUT_SIGN INT64_MAX

#define COIN_PRIV_EPSILON DBL_EPSILON

/* A polynomial of degree 7 in z whose terms are added in pairs, so that fewer
 * of them wait for each other. */
#define COIN_PRIV_POLYNOMIAL(z, c0, c1, c2, c3, c4, c5, c6, c7)                \
    (((c0 + z * c1) + (z * z) * (c2 + z * c3)) +                               \
     (z * z) * (z * z) * ((c4 + z * c5) + (z * z) * (c6 + z * c7)))

/* The coefficients of (sin(x)/x - 1)/z, z = x^2, and of (cos(x) - 1 + z/2)/z^2
 * for |x| <= pi/4: Taylor's to x^17 and x^16, whose next terms are 1e-19. */
#define COIN_PRIV_SINE_AND_COSINE(make)                                        \
    make(-1.0 / 6, 1.0 / 24), make(1.0 / 120, -1.0 / 720),                     \
        make(-1.0 / 5040, 1.0 / 40320), make(1.0 / 362880, -1.0 / 3628800),    \
        make(-1.0 / 39916800, 1.0 / 479001600),                                \
        make(1.0 / 6227020800.0, -1.0 / 87178291200.0),                        \
        make(-1.0 / 1307674368000.0, 1.0 / 20922789888000.0),                  \
        make(1.0 / 355687428096000.0, 0.0)
#define COIN_PRIV_FIRST(sine, cosine) (sine)
#define COIN_PRIV_SECOND(sine, cosine) (cosine)
#define COIN_PRIV_EVALUATE(z, ...) COIN_PRIV_POLYNOMIAL(z, __VA_ARGS__)
#define COIN_PRIV_SINE(z)                                                      \
    COIN_PRIV_EVALUATE(z, COIN_PRIV_SINE_AND_COSINE(COIN_PRIV_FIRST))
#define COIN_PRIV_COSINE(z)                                                    \
    COIN_PRIV_EVALUATE(z, COIN_PRIV_SINE_AND_COSINE(COIN_PRIV_SECOND))

/* For |d| up to this, d^7/5040 of sin d and d^6/720 of cos d are rounding. */
#define COIN_PRIV_LITTLE_TURN 0.006

/* ---------------------------------------------------------------- limits -- */

/* Mass, radius and gravity lie between these. */
#define COIN_PRIV_LEAST 1e-15
#define COIN_PRIV_MOST 1e15

/* The largest component of an angular velocity, in sqrt(g/a), and the largest x
 * and z, in radii. */
#define COIN_PRIV_RATE_MAX 1e6
#define COIN_PRIV_PLACE_MAX 1e9

/* The longest time of a call, in natural units.  The rounding of t is 0.1 unit
 * there, so that a step would hardly change it. */
#define COIN_PRIV_TIME_MAX 1e15

/* A shorter step counts as one of this length where 1/dt^2 is computed.  No W
 * is above 1e38, so that a step of this length is sound for any coin. */
#define COIN_PRIV_DT_LEAST 1e-100

/* A thickness, if not 0, lies between these, in radii. */
#define COIN_PRIV_LEAST_THICKNESS 1e-4
#define COIN_PRIV_MOST_THICKNESS 4

/* I_Z may be this part larger than 2 I_X, for the rounding of both. */
#define COIN_PRIV_INERTIA_SLACK 1e-12

/* Whether the remainders that a state keeps are in range: a state of doubles
 * keeps none. */
#define COIN_PRIV_LOW_IN_RANGE(s) 1

/* The end of a state's initializer: there are no remainders. */
#define COIN_PRIV_NO_LOW

/* ---------------------------------------------------------------- series -- */

/* Terms below this part of their sum no longer change it. */
#define COIN_PRIV_NEGLIGIBLE 1e-17

#endif

#endif
