/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_BODY_H
#define ROLLCOIN_BODY_H

#include "number.h"

#include <coin.h>

/* What the formulas read of a body, in the letters of docs/physics.md:
 * m = M a^2, J = I_X + m, K = I_Z + m. */
typedef struct PRIV(body) {
    real M, a, IX, IZ;
    real m, J, K;
    real Mg, Mga;
    real g_a;    /* g/a: 1 over the natural unit of time squared */
    real KJ, XJ; /* K/J, I_X/J */
    real GJ;     /* M g a/J */
    real k1, k2; /* I_Z/I_X, m/K */
    real w2_max; /* the square of the largest component of omega */
} PRIV(body);

/* The body of p, which need not be in range. */
COIN_PRIV_INLINE PRIV(body) PRIV(body_of)(const COIN(params) * p)
{
    const real M = p->mass, a = p->radius, g = p->gravity;
    const real IX = p->inertia_X, IZ = p->inertia_Z;
    const real m = M * a * a, J = IX + m, K = IZ + m, Mga = M * g * a;
    const real g_a = g / a;
    const PRIV(body) b = {
        M,       a,       IX,    IZ,
        m,       J,       K,     M * g,
        Mga,     g_a,     K / J, IX / J,
        Mga / J, IZ / IX, m / K, COIN_PRIV_RATE_MAX * COIN_PRIV_RATE_MAX * g_a,
    };
    return b;
}

/* The ratios of a body's numbers that are accepted: I_X/(M a^2) from
 * LEAST_RATIO to MOST_RATIO, I_Z/I_X from LEAST_RATIO to 2. */
#define COIN_PRIV_LEAST_RATIO K(1e-3)
#define COIN_PRIV_MOST_RATIO K(1e3)

COIN_PRIV_INLINE int PRIV(is_ordinary)(real x)
{
    return x >= COIN_PRIV_LEAST && x <= COIN_PRIV_MOST;
}

/* Whether parameters are in range.  NaN is not. */
COIN_PRIV_INLINE int PRIV(params_hold)(const COIN(params) * p)
{
    const real IX = p->inertia_X, IZ = p->inertia_Z;
    const real m = p->mass * p->radius * p->radius;
    const whole reserved = PRIV(bits)(p->reserved[0]) |
                           PRIV(bits)(p->reserved[1]) |
                           PRIV(bits)(p->reserved[2]);
    return PRIV(is_ordinary)(p->mass) && PRIV(is_ordinary)(p->radius) &&
           PRIV(is_ordinary)(p->gravity) && IX >= COIN_PRIV_LEAST_RATIO * m &&
           IX <= COIN_PRIV_MOST_RATIO * m && IZ >= COIN_PRIV_LEAST_RATIO * IX &&
           IZ <= 2 * (1 + COIN_PRIV_INERTIA_SLACK) * IX &&
           (reserved & COIN_PRIV_ALL_BUT_SIGN) == 0;
}

/* COIN_OK and *b, or COIN_EPARAMS.  p is not null. */
COIN_PRIV_INLINE int32_t PRIV(check_body)(PRIV(body) * b,
                                          const COIN(params) * p)
{
    if (!PRIV(params_hold)(p))
        return COIN_EPARAMS;
    *b = PRIV(body_of)(p);
    return COIN_OK;
}

#endif
