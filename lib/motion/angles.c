/* SPDX-License-Identifier: MIT */
#include "angles.h"

coin_priv_sc coin_priv_sincos(number x)
{
    return coin_priv_sine_cosine(x);
}

/* The series of asin x up to x^5.  Its error, 15/336 x^7, is below 2^-56 x for
 * |x| < SMALL. */
#define SMALL K(0.0025)
static number arcsine(number x)
{
    const number z = x * x;
    return x + x * z * (K(1.0 / 6) + z * K(3.0 / 40));
}

number coin_priv_angle(coin_priv_sc pair)
{
    /* The guess takes the arc sine of the sine or of the cosine, whichever is
     * smaller.  Its series errs most where the two are equal, by less than
     * 0.007.  The result is the guess plus the arc sine of sin(angle - guess),
     * whose series then errs by less than 1e-16. */
    number guess;
    if (FABS(pair.s) < SMALL && pair.c > 0)
        return arcsine(pair.s);
    if (FABS(pair.s) > FABS(pair.c))
        guess = (pair.s > 0 ? COIN_PRIV_HALF_PI : -COIN_PRIV_HALF_PI) -
                (pair.s > 0 ? arcsine(pair.c) : -arcsine(pair.c));
    else if (pair.c > 0)
        guess = arcsine(pair.s);
    else
        guess = (pair.s < 0 ? -2 : 2) * COIN_PRIV_HALF_PI - arcsine(pair.s);
    const coin_priv_sc at = coin_priv_sincos(guess);
    return guess + arcsine(pair.s * at.c - pair.c * at.s);
}
