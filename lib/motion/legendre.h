/* SPDX-License-Identifier: MIT */
/* The linear pair, a function of the lean alone, Eq. (33): with u = sin theta
 * and p = wY cos theta,
 *     dp/du = k1 wZ,   dwZ/du = k2 p/(1 - u^2),   kap = k1 k2,
 * Legendre's equation of degree nu, nu (nu + 1) = -kap.  All functions that
 * solve it are computed here.  0 < kap < 2 for every body. */
#ifndef ROLLCOIN_LEGENDRE_H
#define ROLLCOIN_LEGENDRE_H

#include "number.h"

/* Solutions that are even and odd about u = 0: Pe and Po for p, We and Wo for
 * wZ.  p = KY Pe + k1 KZ Po and wZ = KZ We + k2 KY Wo.
 * Pe We - kap Po Wo = 1. */
typedef struct coin_priv_central {
    number Pe, Po, We, Wo;
} coin_priv_central;

/* Solutions about the flat coin: R and S for wZ, PR and PS for k2 p.
 * wZ = al R + be S and k2 p = al PR + be PS.  R PS - S PR = -2. */
typedef struct coin_priv_flat {
    number R, S, PR, PS;
} coin_priv_flat;

/* The power series about u = 0.  Pre: |u| <= 0.7.  Accuracy: 1e-15 relative
 * (test_legendre).  Cost: at most 60 terms. */
coin_priv_central coin_priv_legendre_central(number kap, number u);

/* The series about the flat coin, v = (1 - |u|)/2 = sin^2(delta/2) with delta =
 * pi/2 - |theta|.  ln_v is ln v plus any constant.  The constant selects the
 * solution S, so that it has to be the same wherever al and be are.
 * Pre: 0 < v <= 1/2.  Accuracy: 1e-15 of the terms, 5e-15 at v = 1/2, down to
 * v = 1e-32 (test_legendre).  Cost: at most 65 terms. */
coin_priv_flat coin_priv_legendre_flat(number kap, number v, number ln_v);

/* legendre_change() leads from the pair at u to that at u + e, by the power
 * series about u, (34).  c2 is 1 - u^2.
 * Pre: |e| (1 + |u|) <= COIN_PRIV_SERIES_REACH c2.  Each term of the series is
 * then at most 0.18 of the one before.
 * Accuracy: 12 units of rounding of the terms of the change (test_drift).
 * Cost: COIN_PRIV_SERIES_TERMS terms, always: 0.18^22 is 4e-17. */
#define COIN_PRIV_SERIES_REACH K(0.18)
#define COIN_PRIV_SERIES_TERMS 22

/* 1/((n + 1)(n + 2)), in a table: a division takes as long as three products.
 */
#define COIN_PRIV_OVER(n) (K(1.0) / (((n) + 1) * ((n) + 2)))
#define COIN_PRIV_OVER4(n)                                                     \
    COIN_PRIV_OVER(n), COIN_PRIV_OVER(n + 1), COIN_PRIV_OVER(n + 2),           \
        COIN_PRIV_OVER(n + 3)
static const number coin_priv_over[24] = {
    COIN_PRIV_OVER4(0),  COIN_PRIV_OVER4(4),  COIN_PRIV_OVER4(8),
    COIN_PRIV_OVER4(12), COIN_PRIV_OVER4(16), COIN_PRIV_OVER4(20),
};

/* Sets *dp and *dwZ to the changes of p and wZ. */
COIN_PRIV_INLINE void coin_priv_legendre_change(number *dp, number *dwZ,
                                                number p, number wZ, number k1,
                                                number k2, number u, number c2,
                                                number e)
{
    const number kap = k1 * k2, x = e / c2;
    const number back1 = 2 * u * x, back2 = e * x;
    number b0 = wZ, b1 = k2 * p * x; /* a_n e^n of this term and the next */
    number change = 0, sum = b0;
    for (int i = 0; i < COIN_PRIV_SERIES_TERMS; ++i) {
        const number n = (number)i, next = coin_priv_over[i];
        const number b2 = back1 * b1 * ((n + 1) * (n + 1) * next) +
                          back2 * b0 * ((n * (n + 1) + kap) * next);
        change += b1;
        sum += b1 * ((n + 1) * next);
        b0 = b1;
        b1 = b2;
    }
    *dp = k1 * e * sum;
    *dwZ = change;
}

#endif
