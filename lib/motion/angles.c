/* SPDX-License-Identifier: MIT */
#include "angles.h"

PRIV(sc) PRIV(sincos)(real x)
{
    return PRIV(sine_cosine)(x);
}

/* asin x to x^5: off by 15/336 x^7, below x 2^-56 for |x| < SMALL. */
#define SMALL K(0.0025)
static real arcsine(real x)
{
    const real z = x * x;
    return x + x * z * (K(1.0 / 6) + z * K(3.0 / 40));
}

real PRIV(angle)(PRIV(sc) of)
{
    /* A guess by the smaller of the two, off by 0.007 at pi/4 where they are
     * equal, and by a Newton step whose own rest is below 1e-16. */
    real guess;
    if (FABS(of.s) < SMALL && of.c > 0)
        return arcsine(of.s);
    if (FABS(of.s) > FABS(of.c))
        guess = (of.s > 0 ? COIN_PRIV_HALF_PI : -COIN_PRIV_HALF_PI) -
                (of.s > 0 ? arcsine(of.c) : -arcsine(of.c));
    else if (of.c > 0)
        guess = arcsine(of.s);
    else
        guess = (of.s < 0 ? -2 : 2) * COIN_PRIV_HALF_PI - arcsine(of.s);
    const PRIV(sc) at = PRIV(sincos)(guess);
    return guess + arcsine(of.s * at.c - of.c * at.s);
}
