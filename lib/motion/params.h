/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_PARAMS_H
#define ROLLCOIN_PARAMS_H

#include "number.h"

#include <coin.h>

/* The constants of the equations for a coin, in the letters of docs/physics.md:
 * m = M a^2, J = I_X + m, K = I_Z + m. */
typedef struct coin_priv_constants {
    number M, a, IX, IZ;
    number m, J, K;
    number Mg, Mga;
    number g_a;    /* g/a: 1 over the natural unit of time squared */
    number KJ, XJ; /* K/J, I_X/J */
    number GJ;     /* M g a/J */
    number k1, k2; /* I_Z/I_X, m/K */
    number w2_max; /* the square of the largest component of omega */
} coin_priv_constants;

/* The constants of p, which need not be in range. */
COIN_PRIV_INLINE coin_priv_constants
coin_priv_constants_of(const coin_params *p)
{
    const number M = p->mass, a = p->radius, g = p->gravity;
    const number IX = p->inertia_X, IZ = p->inertia_Z;
    const number m = M * a * a, J = IX + m, K = IZ + m, Mga = M * g * a;
    const number g_a = g / a;
    const coin_priv_constants b = {
        M,       a,       IX,    IZ,
        m,       J,       K,     M * g,
        Mga,     g_a,     K / J, IX / J,
        Mga / J, IZ / IX, m / K, COIN_PRIV_RATE_MAX * COIN_PRIV_RATE_MAX * g_a,
    };
    return b;
}

/* The ratios of parameters that are accepted: I_X/(M a^2) from LEAST_RATIO
 * to MOST_RATIO, I_Z/I_X from LEAST_RATIO to 2. */
#define COIN_PRIV_LEAST_RATIO K(1e-3)
#define COIN_PRIV_MOST_RATIO K(1e3)

COIN_PRIV_INLINE int coin_priv_size_in_range(number x)
{
    return x >= COIN_PRIV_LEAST && x <= COIN_PRIV_MOST;
}

/* Whether members are 0, as reserved ones have to be.  NaN is not. */
COIN_PRIV_INLINE int coin_priv_are_zero(const number *x, int count)
{
    integer any = 0;
#pragma GCC unroll 8
    for (int i = 0; i < count; ++i)
        any |= coin_priv_bits(x[i]);
    return (any & COIN_PRIV_ALL_BUT_SIGN) == 0;
}

/* Whether all members but the thickness are in range.  NaN is not. */
COIN_PRIV_INLINE int coin_priv_params_in_range(const coin_params *p)
{
    const number IX = p->inertia_X, IZ = p->inertia_Z;
    const number m = p->mass * p->radius * p->radius;
    return coin_priv_size_in_range(p->mass) &&
           coin_priv_size_in_range(p->radius) &&
           coin_priv_size_in_range(p->gravity) &&
           IX >= COIN_PRIV_LEAST_RATIO * m && IX <= COIN_PRIV_MOST_RATIO * m &&
           IZ >= COIN_PRIV_LEAST_RATIO * IX &&
           IZ <= 2 * (1 + COIN_PRIV_INERTIA_SLACK) * IX &&
           coin_priv_are_zero(p->reserved, 2);
}

/* Those of a thin coin: COIN_OK and *b, or COIN_EPARAMS.  p is not null. */
COIN_PRIV_INLINE int32_t coin_priv_check_params(coin_priv_constants *b,
                                                const coin_params *p)
{
    if (COIN_PRIV_RARELY(!(coin_priv_params_in_range(p) && p->thickness == 0)))
        return COIN_EPARAMS;
    *b = coin_priv_constants_of(p);
    return COIN_OK;
}

/* The same of a coin that may have a thickness. */
COIN_PRIV_INLINE int32_t coin_priv_check_thick(coin_priv_constants *b,
                                               const coin_params *p)
{
    const number H = p->thickness, a = p->radius;
    const int suits = H == 0 || (H >= COIN_PRIV_LEAST_THICKNESS * a &&
                                 H <= COIN_PRIV_MOST_THICKNESS * a);
    if (COIN_PRIV_RARELY(!(coin_priv_params_in_range(p) && suits)))
        return COIN_EPARAMS;
    *b = coin_priv_constants_of(p);
    return COIN_OK;
}

#endif
