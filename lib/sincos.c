/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "sincos.h"

#include <stdint.h>

coin_priv_sc coin_priv_sincos(double x)
{
    coin_priv_sc r = {NAN, NAN};
    /* Also stops NaN, whose conversion to an integer is undefined. */
    if (!(fabs(x) <= COIN_PRIV_ANGLE_MAX))
        return r;
    double n;
    const coin_priv_sc rest = coin_priv_sincos_rest(&n, x);
    const int32_t quarter = (int32_t)n & 3;
    r.s = quarter & 1 ? rest.c : rest.s;
    r.c = quarter & 1 ? rest.s : rest.c;
    r.s = quarter & 2 ? -r.s : r.s;
    r.c = (quarter + 1) & 2 ? -r.c : r.c;
    return r;
}

/* asin x to x^5: off by 15/336 x^7, below x 2^-56 for |x| < SMALL. */
#define SMALL 0.0025
static double arcsine(double x)
{
    const double z = x * x;
    return x + x * z * (1.0 / 6 + z * (3.0 / 40));
}

double coin_priv_angle(coin_priv_sc of)
{
    /* A guess by the smaller of the two, off by 0.007 at pi/4 where they are
     * equal, and by a Newton step whose own rest is below 1e-16. */
    double guess;
    if (fabs(of.s) < SMALL && of.c > 0)
        return arcsine(of.s);
    if (fabs(of.s) > fabs(of.c))
        guess = (of.s > 0 ? COIN_PRIV_HALF_PI : -COIN_PRIV_HALF_PI) -
                (of.s > 0 ? arcsine(of.c) : -arcsine(of.c));
    else if (of.c > 0)
        guess = arcsine(of.s);
    else
        guess = (of.s < 0 ? -2 : 2) * COIN_PRIV_HALF_PI - arcsine(of.s);
    const coin_priv_sc at = coin_priv_sincos(guess);
    return guess + arcsine(of.s * at.c - of.c * at.s);
}
