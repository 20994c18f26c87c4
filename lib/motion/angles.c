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
    const number sine = pair.s, cosine = pair.c;
    coin_priv_sc rest = pair; /* without n quarter turns: |s| <= |c| */
    number n = 0;
    if (FABS(sine) > FABS(cosine)) {
        n = sine > 0 ? 1 : -1;
        rest.s = -n * cosine;
        rest.c = n * sine;
    } else if (!(cosine > 0)) {
        n = sine < 0 ? -2 : 2;
        rest.s = -sine;
        rest.c = -cosine;
    } else if (FABS(sine) < SMALL) {
        return arcsine(sine);
    }
    /* The series of the guess errs by less than 0.007, and that of the arc sine
     * of sin(angle - guess) by less than 1e-16. */
    const number guess = n * COIN_PRIV_HALF_PI + arcsine(rest.s);
    const coin_priv_rest r = coin_priv_reduced(guess, n);
    const coin_priv_sc at = coin_priv_sine_cosine_reduced(r.hi, r.lo);
    return guess + arcsine(rest.s * at.c - rest.c * at.s);
}
