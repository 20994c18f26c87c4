/* SPDX-License-Identifier: MIT */
/* The force of the table along a motion, as power series of tau. */
#ifndef ROLLCOIN_FORCE_H
#define ROLLCOIN_FORCE_H

#include "../motion/equations.h"

/* The number of terms of the series: all, or some, or few.  The farther the
 * force is from the edge of the cone of friction, the fewer suffice. */
#define COIN_PRIV_FORCE_TERMS 7
#define COIN_PRIV_FORCE_SOME 5
#define COIN_PRIV_FORCE_FEW 3

/* The values of a quantity at both ends of a stretch of motion: at[0] where it
 * begins, at[1] where it ends. */
typedef struct coin_priv_ends {
    double at[2];
} coin_priv_ends;

/* The power series in tau about both ends of a stretch: of cos theta; and, by
 * (92), of cos theta times the force over M a, along e_X, along e_h and along
 * the vertical. */
typedef struct coin_priv_force_series {
    int terms; /* how many terms are set */
    coin_priv_ends X[COIN_PRIV_FORCE_TERMS];
    coin_priv_ends h[COIN_PRIV_FORCE_TERMS];
    coin_priv_ends normal[COIN_PRIV_FORCE_TERMS];
    coin_priv_ends cth[COIN_PRIV_FORCE_TERMS];
} coin_priv_force_series;

/* The series are in powers of tau/unit, and `unit` is the unit of time of the
 * force too.  terms is one of the numbers above, or 1. */
void coin_priv_force_series_of(coin_priv_force_series *out,
                               const coin_priv_body *b,
                               const coin_priv_variables *begin,
                               const coin_priv_variables *end, double unit,
                               int terms);

#endif
