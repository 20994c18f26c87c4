/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_BODY_H
#define ROLLCOIN_BODY_H

#include "number.h"

#include <coin.h>

/* What the formulas read of a body, in the letters of docs/physics.md:
 * m = M a^2, J = I_X + m, K = I_Z + m.  All members are of type real: body.c
 * reads them as an array. */
typedef struct PRIV(body) {
    real M, a, IX, IZ;
    real m, J, K;
    real Mg, Mga;
    real g_a;    /* g/a: 1 over the natural unit of time squared */
    real KJ, XJ; /* K/J, I_X/J */
    real GJ;     /* M g a/J */
    real k1, k2; /* I_Z/I_X, m/K */
    real w2_max; /* the largest |omega|^2 with which nothing overflows */
} PRIV(body);

/* All members but w2_max; nothing is checked. */
COIN_PRIV_INLINE PRIV(body) PRIV(body_of)(const COIN(params) * p)
{
    const real M = p->mass, a = p->radius, g = p->gravity;
    const real IX = p->inertia_X, IZ = p->inertia_Z;
    const real m = M * a * a, J = IX + m, K = IZ + m, Mga = M * g * a;
    const PRIV(body) b = {
        M,   a,     IX,    IZ,     m,       J,       K,     M * g,
        Mga, g / a, K / J, IX / J, Mga / J, IZ / IX, m / K, 0,
    };
    return b;
}

/* The largest |omega|^2 whose products with the body's constants do not
 * overflow. */
COIN_PRIV_INLINE real PRIV(w2_max)(const PRIV(body) * b)
{
    return COIN_PRIV_W2_MAX / (1 + b->a + b->M * b->a + b->J + b->K);
}

/* The bits of x, as an unsigned integer, minus those of the least number of an
 * ordinary body.  Positive numbers have the order of their bits.  For a smaller
 * or negative number and for NaN the difference is larger than for any number
 * of an ordinary body. */
COIN_PRIV_INLINE unsigned_whole PRIV(above_least)(real x)
{
    return (unsigned_whole)PRIV(bits)(x) -
           (unsigned_whole)PRIV(bits)(COIN_PRIV_ORDINARY_LEAST);
}

/* Whether p is a body all of whose numbers lie in a range in which no product
 * of a few of them can overflow.  Nothing else has to be checked then. */
COIN_PRIV_INLINE int PRIV(is_ordinary_body)(const COIN(params) * p)
{
    const unsigned_whole span = PRIV(above_least)(COIN_PRIV_ORDINARY_MOST);
    const unsigned_whole mass = PRIV(above_least)(p->mass);
    const unsigned_whole radius = PRIV(above_least)(p->radius);
    const unsigned_whole gravity = PRIV(above_least)(p->gravity);
    const unsigned_whole inertia_X = PRIV(above_least)(p->inertia_X);
    const unsigned_whole inertia_Z = PRIV(above_least)(p->inertia_Z);
    const unsigned_whole reserved =
        (unsigned_whole)(PRIV(bits)(p->reserved[0]) |
                         PRIV(bits)(p->reserved[1]) |
                         PRIV(bits)(p->reserved[2]));
    return (int)(mass < span) & (radius < span) & (gravity < span) &
           (inertia_X < span) & (inertia_Z < span) &
           (p->inertia_Z <= 2 * p->inertia_X) & (reserved == 0);
}

/* COIN_OK and *b, or COIN_EPARAMS if p is no body, or one whose products leave
 * the range COIN_PRIV_LEAST to COIN_PRIV_MOST.  p is not null. */
int32_t PRIV(check_any_body)(PRIV(body) * b, const COIN(params) * p);

/* The same.  For an ordinary body it divides only where *b needs it. */
COIN_PRIV_INLINE int32_t PRIV(check_body)(PRIV(body) * b,
                                          const COIN(params) * p)
{
    if (COIN_PRIV_RARELY(!PRIV(is_ordinary_body)(p)))
        return PRIV(check_any_body)(b, p);
    *b = PRIV(body_of)(p);
    b->w2_max =
        COIN_PRIV_ORDINARY_W2 > 0 ? COIN_PRIV_ORDINARY_W2 : PRIV(w2_max)(b);
    return COIN_OK;
}

#endif
