/* SPDX-License-Identifier: MIT */
/* Sine and cosine, with the same bits on every platform.  If COIN_PRIV_BY_PAIRS
 * is defined, the functions of one number use those of a pair of numbers, for
 * which this file has been included before. */
#include "number.h"

#include "kind.h"

typedef struct PRIV(sc) {
    real s, c;
} PRIV(sc);

/* COIN_PRIV_SINE and COIN_PRIV_COSINE at z. */
COIN_PRIV_INLINE PRIV(sc) PRIV(polynomials)(real z)
{
#ifdef COIN_PRIV_BY_PAIRS
    const coin_pair zz = coin_pair_of(z, z);
    const coin_pair p =
        COIN_PRIV_EVALUATE(zz, COIN_PRIV_SINE_AND_COSINE(coin_pair_of));
    const PRIV(sc) r = {p[0], p[1]};
#else
    const PRIV(sc) r = {COIN_PRIV_SINE(z), COIN_PRIV_COSINE(z)};
#endif
    return r;
}

/* Sine and cosine of x + y.  Pre: |x + y| <= pi/4, |y| <= ulp(x).  The rounding
 * error of 1 - z/2 is computed and added to the cosine. */
COIN_PRIV_INLINE PRIV(sc) PRIV(sine_cosine_reduced)(real x, real y)
{
    const real z = x * x, w = K(1) - K(0.5) * z;
    const PRIV(sc) p = PRIV(polynomials)(z);
    const PRIV(sc) r = {
        x + (x * z * p.s + y * w),
        w + (((K(1) - w) - K(0.5) * z) + (z * z * p.c - x * y)),
    };
    return r;
}

/* Sine and cosine of x, which is reduced by the method of Cody and Waite:
 * x = n pi/2 + (hi + lo) with an integer n.
 * Pre: |x| <= COIN_PRIV_ANGLE_MAX.  NaN for NaN and infinity.
 * Accuracy: 1 ulp for |x| <= 2^20, near multiples of pi/2 too (test_sincos). */
COIN_PRIV_INLINE PRIV(sc) PRIV(sine_cosine)(real x)
{
    const real sum = x * (K(1) / COIN_PRIV_HALF_PI) + COIN_PRIV_ROUNDER;
    const real n = sum - COIN_PRIV_ROUNDER;
    const real t = (x - n * COIN_PRIV_P1) - n * COIN_PRIV_P2; /* exact */
    const real r3 = t - n * COIN_PRIV_P3;
    const real hi = r3 - n * COIN_PRIV_P4;
    const real lo =
        ((r3 - hi) - n * COIN_PRIV_P4) + ((t - r3) - n * COIN_PRIV_P3);
    const PRIV(sc) rest = PRIV(sine_cosine_reduced)(hi, lo);
    const whole quarter = PRIV(bits)(sum);
    const whole odd = -(quarter & 1); /* all ones or 0 */
    const whole below = -(quarter & 2), left = -((quarter + 1) & 2);
    const real s = PRIV(choose)(odd, rest.c, rest.s);
    const real c = PRIV(choose)(odd, rest.s, rest.c);
    const PRIV(sc) r = {
        PRIV(of_bits)(PRIV(bits)(s) ^ (below & COIN_PRIV_SIGN)),
        PRIV(of_bits)(PRIV(bits)(c) ^ (left & COIN_PRIV_SIGN)),
    };
    return r;
}

/* What turning an angle by d, |d| <= pi/2, adds to its sine and cosine, by
 * sin d = 2 sin(d/2) cos(d/2) and 1 - cos d = 2 sin(d/2)^2. */
COIN_PRIV_INLINE_UNLESS_SMALL PRIV(sc) PRIV(turn_adds)(PRIV(sc) of, real d)
{
    const real half = K(0.5) * d, z = half * half;
    const PRIV(sc) p = PRIV(polynomials)(z);
    const real s2 = d + d * z * p.s; /* 2 sin(d/2) */
    const real versine = K(0.5) * s2 * s2;
    const real sine = s2 + s2 * (z * z * p.c - K(0.5) * z);
    const PRIV(sc) r = {
        of.c * sine - of.s * versine,
        -(of.s * sine + of.c * versine),
    };
    return r;
}

/* The sine and cosine of an angle after it is turned by d, |d| <= pi/2.
 * Accuracy: 2 u of the pair's norm for |d| <= 1/2, 3 u for |d| <= 1, 5 u up to
 * pi/2, where u is half of COIN_PRIV_EPSILON (test_angles). */
COIN_PRIV_INLINE PRIV(sc) PRIV(turned)(PRIV(sc) of, real d)
{
    const PRIV(sc) by = PRIV(turn_adds)(of, d);
    const PRIV(sc) r = {of.s + by.s, of.c + by.c};
    return r;
}

/* The same for |d| <= COIN_PRIV_LITTLE_TURN, in half of the time. */
COIN_PRIV_INLINE PRIV(sc) PRIV(turned_a_little)(PRIV(sc) of, real d)
{
    const real z = d * d;
    const real sine = d - (d * z) * (K(1.0 / 6) - z * K(1.0 / 120));
    const real versine = z * (K(0.5) - z * K(1.0 / 24));
    const PRIV(sc) r = {
        of.s + (of.c * sine - of.s * versine),
        of.c - (of.s * sine + of.c * versine),
    };
    return r;
}

/* Turns two pairs, a by x and b by y. */
COIN_PRIV_INLINE void PRIV(turn_both)(PRIV(sc) * a, PRIV(sc) * b, real x,
                                      real y)
{
#ifdef COIN_PRIV_BY_PAIRS
    const coin_pair_sc from = {coin_pair_of(a->s, b->s),
                               coin_pair_of(a->c, b->c)};
    const coin_pair_sc to = coin_pair_turned(from, coin_pair_of(x, y));
    a->s = to.s[0];
    a->c = to.c[0];
    b->s = to.s[1];
    b->c = to.c[1];
#else
    *a = PRIV(turned)(*a, x);
    *b = PRIV(turned)(*b, y);
#endif
}
