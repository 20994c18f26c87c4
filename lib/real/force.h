/* SPDX-License-Identifier: MIT */
/* The force of the table along a motion, as power series of tau. */
#ifndef ROLLCOIN_FORCE_H
#define ROLLCOIN_FORCE_H

#include "../motion/equations.h"

/* How many terms: all; or some, or few, where the force is far from the edge of
 * the cone of friction. */
#define COIN_PRIV_FORCE_TERMS 7
#define COIN_PRIV_FORCE_SOME 5
#define COIN_PRIV_FORCE_FEW 3

/* A number at the begin and one at the end of a stretch of motion. */
typedef struct coin_priv_ends {
    double at[2];
} coin_priv_ends;

/* The first terms of series about both ends of a stretch: cos theta, and by
 * (92) cos theta times the force over M a along e_X, e_h and the vertical. */
typedef struct coin_priv_force {
    int terms; /* how many are known */
    coin_priv_ends along[COIN_PRIV_FORCE_TERMS];
    coin_priv_ends across[COIN_PRIV_FORCE_TERMS];
    coin_priv_ends normal[COIN_PRIV_FORCE_TERMS];
    coin_priv_ends cth[COIN_PRIV_FORCE_TERMS];
} coin_priv_force;

/* The series in powers of tau/unit; the force is in that unit of time.  terms
 * is one of the numbers above, or 1. */
void coin_priv_force_of(coin_priv_force *out, const coin_priv_body *b,
                        const coin_priv_variables *begin,
                        const coin_priv_variables *end, double unit, int terms);

#endif
