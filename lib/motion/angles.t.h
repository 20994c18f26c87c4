/* SPDX-License-Identifier: MIT */
/* Sine and cosine, with the same bits on every platform.  If COIN_PRIV_BY_PAIRS
 * is defined, the functions of one number use those of a pair of numbers, for
 * which this file has been included before. */
#include "number.h"

#include "kind.h"

typedef struct coin_priv_sc {
    number s, c;
} coin_priv_sc;

/* COIN_PRIV_SINE and COIN_PRIV_COSINE at z. */
COIN_PRIV_INLINE coin_priv_sc coin_priv_polynomials(number z)
{
#ifdef COIN_PRIV_BY_PAIRS
    const coin_pair zz = coin_pair_of(z, z);
    const coin_pair p =
        COIN_PRIV_EVALUATE(zz, COIN_PRIV_SINE_AND_COSINE(coin_pair_of));
    const coin_priv_sc r = {p[0], p[1]};
#else
    const coin_priv_sc r = {COIN_PRIV_SINE(z), COIN_PRIV_COSINE(z)};
#endif
    return r;
}

/* Sine and cosine of x + y.  Pre: |x + y| <= pi/4, |y| <= ulp(x).  The rounding
 * error of 1 - z/2 is computed and added to the cosine. */
COIN_PRIV_INLINE coin_priv_sc coin_priv_sine_cosine_reduced(number x, number y)
{
    const number z = x * x, w = K(1) - K(0.5) * z;
    const coin_priv_sc p = coin_priv_polynomials(z);
    const coin_priv_sc r = {
        x + (x * z * p.s + y * w),
        w + (((K(1) - w) - K(0.5) * z) + (z * z * p.c - x * y)),
    };
    return r;
}

/* An angle without n quarter turns, hi + lo, by the method of Cody and Waite.
 * Pre: |n| < COIN_PRIV_ANGLE_MAX, |hi| <= pi/4. */
typedef struct coin_priv_rest {
    number hi, lo;
} coin_priv_rest;

COIN_PRIV_INLINE coin_priv_rest coin_priv_reduced(number x, number n)
{
    const number t = (x - n * COIN_PRIV_P1) - n * COIN_PRIV_P2; /* exact */
    const number r3 = t - n * COIN_PRIV_P3;
    const number hi = r3 - n * COIN_PRIV_P4;
    const coin_priv_rest r = {
        hi,
        ((r3 - hi) - n * COIN_PRIV_P4) + ((t - r3) - n * COIN_PRIV_P3),
    };
    return r;
}

/* Sine and cosine of x.
 * Pre: |x| <= COIN_PRIV_ANGLE_MAX.  NaN for NaN and infinity.
 * Accuracy: 1 ulp for |x| <= 2^20, near multiples of pi/2 too (test_sincos). */
COIN_PRIV_INLINE coin_priv_sc coin_priv_sine_cosine(number x)
{
    const number sum = x * (K(1) / COIN_PRIV_HALF_PI) + COIN_PRIV_ROUNDER;
    const coin_priv_rest r = coin_priv_reduced(x, sum - COIN_PRIV_ROUNDER);
    const coin_priv_sc rest = coin_priv_sine_cosine_reduced(r.hi, r.lo);
    const integer quarter = coin_priv_bits(sum);
    const integer odd = -(quarter & 1); /* all ones or 0 */
    const integer below = -(quarter & 2), left = -((quarter + 1) & 2);
    const number s = coin_priv_choose(odd, rest.c, rest.s);
    const number c = coin_priv_choose(odd, rest.s, rest.c);
    const coin_priv_sc at = {
        coin_priv_of_bits(coin_priv_bits(s) ^ (below & COIN_PRIV_SIGN)),
        coin_priv_of_bits(coin_priv_bits(c) ^ (left & COIN_PRIV_SIGN)),
    };
    return at;
}

/* What turning an angle by d, |d| <= pi/2, adds to its sine and cosine, by
 * sin d = 2 sin(d/2) cos(d/2) and 1 - cos d = 2 sin(d/2)^2. */
COIN_PRIV_INLINE_UNLESS_SMALL coin_priv_sc
coin_priv_turn_adds(coin_priv_sc pair, number d)
{
    const number half = K(0.5) * d, z = half * half;
    const coin_priv_sc p = coin_priv_polynomials(z);
    const number s2 = d + d * z * p.s; /* 2 sin(d/2) */
    const number versine = K(0.5) * s2 * s2;
    const number sine = s2 + s2 * (z * z * p.c - K(0.5) * z);
    const coin_priv_sc r = {
        pair.c * sine - pair.s * versine,
        -(pair.s * sine + pair.c * versine),
    };
    return r;
}

/* The sine and cosine of an angle after it is turned by d, |d| <= pi/2.
 * Accuracy: 2 u of the pair's norm for |d| <= 1/2, 3 u for |d| <= 1, 5 u up to
 * pi/2, where u is half of COIN_PRIV_EPSILON (test_angles). */
COIN_PRIV_INLINE coin_priv_sc coin_priv_turned(coin_priv_sc pair, number d)
{
    const coin_priv_sc by = coin_priv_turn_adds(pair, d);
    const coin_priv_sc r = {pair.s + by.s, pair.c + by.c};
    return r;
}

/* The same for |d| <= COIN_PRIV_LITTLE_TURN, in half of the time. */
COIN_PRIV_INLINE coin_priv_sc coin_priv_turned_a_little(coin_priv_sc pair,
                                                        number d)
{
    const number z = d * d;
    const number sine = d - (d * z) * (K(1.0 / 6) - z * K(1.0 / 120));
    const number versine = z * (K(0.5) - z * K(1.0 / 24));
    const coin_priv_sc r = {
        pair.s + (pair.c * sine - pair.s * versine),
        pair.c - (pair.s * sine + pair.c * versine),
    };
    return r;
}

/* Turns two pairs, a by x and b by y. */
COIN_PRIV_INLINE void coin_priv_turn_both(coin_priv_sc *a, coin_priv_sc *b,
                                          number x, number y)
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
    *a = coin_priv_turned(*a, x);
    *b = coin_priv_turned(*b, y);
#endif
}
