/* SPDX-License-Identifier: MIT */
/* What depends on the width of a number: this is for floats, and
 * lib/precision.h for doubles. */
#ifndef ROLLCOIN_PRECISION_H
#define ROLLCOIN_PRECISION_H

#include <coinf.h>

#include <float.h>
#include <math.h>

/* ---------------------------------------------------------------- angles -- */

/* Beyond this the product of a number of quarter turns and a part of pi/2
 * would round; a state's own angles stay within half a turn. */
#define COINF_PRIV_ANGLE_MAX 4096.0f

/* The float nearest to pi/2, which lies 4.4e-8 above it, and the rest. */
#define COINF_PRIV_HALF_PI 1.57079637f
#define COINF_PRIV_HALF_PI_LOW -4.37113900e-8f

/* pi/2 = P1 + P2 + P3 + P4: three parts of 12 bits, so that n times a part is
 * exact for |n| < 2^12, and a rest. */
#define COINF_PRIV_P1 1.5703125f
#define COINF_PRIV_P2 4.83751297e-4f
#define COINF_PRIV_P3 7.54953362e-8f
#define COINF_PRIV_P4 2.56334407e-12f

/* Adding and subtracting 1.5 2^23 rounds to the nearest integer. */
#define COINF_PRIV_ROUNDER 12582912.0f

/* (sin(x)/x - 1)/z with z = x^2 and |x| <= pi/4: the Taylor polynomial to
 * x^9, whose next term is 2e-9. */
#define COINF_PRIV_SINE(z)                                                     \
    (-1.0f / 6 + z * (1.0f / 120 + z * (-1.0f / 5040 + z * (1.0f / 362880))))

/* (cos(x) - 1 + z/2)/z^2, likewise to x^10. */
#define COINF_PRIV_COSINE(z)                                                   \
    (1.0f / 24 + z * (-1.0f / 720 + z * (1.0f / 40320 + z * (-1.0f / 3628800))))

/* ---------------------------------------------------------------- limits -- */

/* Numbers in here can be multiplied by each other's ratios, and by the 1/cos
 * of the flattest lean, and stay normal: 1e-30 and 1e30 leave 2^26. */
#define COINF_PRIV_LEAST 1e-30f
#define COINF_PRIV_MOST 1e30f

/* That over the largest 1/cos^2 theta: below 1e16 for every |theta| < pi/2
 * that a float and its remainder hold. */
#define COINF_PRIV_W2_MAX 1e14f

/* I_Z may be this part larger than 2 I_X, for the rounding of both. */
#define COINF_PRIV_INERTIA_SLACK 1e-6f

/* Whether the remainders that a state keeps are in range: those of the angles
 * are below 2^-22 within half a turn, and stages take them to first order. */
#define COINF_PRIV_LOW_HOLDS(s) coinf_priv_low_holds((s)->low)
static inline int coinf_priv_low_holds(const float low[8])
{
    const float angles = fabsf(low[0]) + fabsf(low[1]) + fabsf(low[2]);
    const float others = fabsf(low[3]) + fabsf(low[4]) + fabsf(low[5]) +
                         fabsf(low[6]) + fabsf(low[7]);
    return angles <= 1.0f / 1048576 && others <= FLT_MAX;
}

/* What a state's initializer ends with: the remainders of exact members. */
#define COINF_PRIV_NO_LOW                                                      \
    ,                                                                          \
    {                                                                          \
        0, 0, 0, 0, 0, 0, 0, 0                                                 \
    }

/* ---------------------------------------------------------------- series -- */

/* Terms below this part of their sum no longer change it. */
#define COINF_PRIV_NEGLIGIBLE 1e-9f

/* Terms that the drift's series takes: its ratio is at most 0.18. */
#define COINF_PRIV_SERIES_TERMS 11

#endif
