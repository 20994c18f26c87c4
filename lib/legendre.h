/* SPDX-License-Identifier: MIT */
/* The linear pair that lean alone drives, Eq. (33): with u = sin theta and
 * p = wY cos theta,
 *     dp/du = k1 wZ,   dwZ/du = k2 p/(1 - u^2),   kap = k1 k2,
 * Legendre's equation of degree nu, nu (nu + 1) = -kap.  The only home of its
 * special functions; 0 < kap < 2 for every body. */
#ifndef ROLLCOIN_LEGENDRE_H
#define ROLLCOIN_LEGENDRE_H

#include "pinned.h"
#include "precision.h"

/* p = KY Pe + k1 KZ Po and wZ = KZ We + k2 KY Wo; Pe We - kap Po Wo = 1. */
typedef struct coin_priv_central {
    double Pe, Po, We, Wo;
} coin_priv_central;

/* wZ = al R + be S and k2 p = al PR + be PS; R PS - S PR = -2. */
typedef struct coin_priv_flat {
    double R, S, PR, PS;
} coin_priv_flat;

/* The power series about u = 0.  Pre: |u| <= 0.7.  Accuracy: 1e-15 relative
 * (test_legendre).  Cost: at most 60 terms. */
coin_priv_central coin_priv_legendre_central(double kap, double u);

/* The series about the flat coin, v = (1 - |u|)/2 = sin^2(delta/2) with delta
 * = pi/2 - |theta|.  ln_v is ln v, to which the same constant may be added
 * wherever one pair of solutions is used: S then is another solution.
 * Pre: 0 < v <= 1/2.  Accuracy: 1e-15 of the terms, 5e-15 at v = 1/2, down to
 * v = 1e-32 (test_legendre).  Cost: at most 65 terms. */
coin_priv_flat coin_priv_legendre_flat(double kap, double v, double ln_v);

/* The pair carried from u to u + e by its power series about u.  (34)
 * Pre: |e| (1 + |u|) <= COIN_PRIV_SERIES_REACH c2, c2 = 1 - u^2, which makes
 * the series' ratio 0.18.  Accuracy: 6 u of the terms of the change
 * (test_drift).
 * Cost: 22 terms, always. */
#define COIN_PRIV_SERIES_REACH 0.18

/* 1/((n + 1)(n + 2)): a division costs a step as much as three products. */
#define COIN_PRIV_OVER(n) (1.0 / (((n) + 1) * ((n) + 2)))
#define COIN_PRIV_OVER4(n)                                                     \
    COIN_PRIV_OVER(n), COIN_PRIV_OVER(n + 1), COIN_PRIV_OVER(n + 2),           \
        COIN_PRIV_OVER(n + 3)
static const double coin_priv_over[24] = {
    COIN_PRIV_OVER4(0),  COIN_PRIV_OVER4(4),  COIN_PRIV_OVER4(8),
    COIN_PRIV_OVER4(12), COIN_PRIV_OVER4(16), COIN_PRIV_OVER4(20),
};

/* The change alone. */
COIN_PRIV_INLINE void coin_priv_legendre_change(double *dp, double *dwZ,
                                                double p, double wZ, double k1,
                                                double k2, double u, double c2,
                                                double e)
{
    const double kap = k1 * k2, x = e / c2;
    const double back1 = 2 * u * x, back2 = e * x;
    double b0 = wZ, b1 = k2 * p * x; /* a_n e^n of this term and the next */
    double change = 0, sum = b0;
    for (int i = 0; i < COIN_PRIV_SERIES_TERMS; ++i) {
        const double n = (double)i, next = coin_priv_over[i];
        const double b2 = back1 * b1 * ((n + 1) * (n + 1) * next) +
                          back2 * b0 * ((n * (n + 1) + kap) * next);
        change += b1;
        sum += b1 * ((n + 1) * next);
        b0 = b1;
        b1 = b2;
    }
    *dp = k1 * e * sum;
    *dwZ = change;
}

COIN_PRIV_INLINE void coin_priv_legendre_shift(double *p, double *wZ, double k1,
                                               double k2, double u, double c2,
                                               double e)
{
    double dp, dwZ;
    coin_priv_legendre_change(&dp, &dwZ, *p, *wZ, k1, k2, u, c2, e);
    *p += dp;
    *wZ += dwZ;
}

#endif
