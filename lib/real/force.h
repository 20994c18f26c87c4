/* SPDX-License-Identifier: MIT */
/* The force of the table along a motion, as power series of tau. */
#ifndef ROLLCOIN_FORCE_H
#define ROLLCOIN_FORCE_H

#include "../motion/equations.h"

/* How many terms: all, or the few that short stretches need. */
#define COIN_PRIV_FORCE_TERMS 7
#define COIN_PRIV_FORCE_FEW 4

/* The first terms of series about a state: cos theta, and by (92) cos theta
 * times the force over M a along e_X, e_h and the vertical. */
typedef struct coin_priv_force {
    int terms; /* how many are known */
    double along[COIN_PRIV_FORCE_TERMS];
    double across[COIN_PRIV_FORCE_TERMS];
    double normal[COIN_PRIV_FORCE_TERMS];
    double cth[COIN_PRIV_FORCE_TERMS];
} coin_priv_force;

/* The series in powers of tau/unit; the force is in that unit of time.  terms
 * is one of the two numbers above. */
void coin_priv_force_of(coin_priv_force *out, const coin_priv_body *b,
                        const coin_priv_variables *y, double unit, int terms);

#endif
