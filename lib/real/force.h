/* SPDX-License-Identifier: MIT */
/* The force of the table along a motion, as power series of tau. */
#ifndef ROLLCOIN_FORCE_H
#define ROLLCOIN_FORCE_H

#include "../motion/equations.h"

/* The highest power. */
#define COIN_PRIV_FORCE_ORDER 6
#define COIN_PRIV_FORCE_TERMS (COIN_PRIV_FORCE_ORDER + 1)

/* Series about a state: cos theta, and by (92) cos theta times the force over
 * M a along e_X, e_h and the vertical. */
typedef struct coin_priv_force {
    double along[COIN_PRIV_FORCE_TERMS];
    double across[COIN_PRIV_FORCE_TERMS];
    double normal[COIN_PRIV_FORCE_TERMS];
    double cth[COIN_PRIV_FORCE_TERMS];
} coin_priv_force;

/* The series in powers of tau/unit; the force is in that unit of time. */
void coin_priv_force_of(coin_priv_force *out, const coin_priv_body *b,
                        const coin_priv_variables *y, double unit);

#endif
