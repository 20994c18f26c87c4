/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_STEADY_H
#define ROLLCOIN_STEADY_H

#include "../motion/equations.h"
#include "../motion/state.h"

/* The usual checks, then COIN_EDOMAIN unless the motion is steady.  After
 * COIN_OK *b and *th hold the body and sine and cosine of the lean. */
int32_t coin_priv_check_steady(const coin_state *s, const coin_params *p,
                               coin_priv_body *b, coin_priv_sc *th);

/* The constant rates of a steady motion: d(phi)/dt, d(psi)/dt, and the centre's
 * speed along its path. */
typedef struct coin_priv_steady {
    double heading, roll, speed;
} coin_priv_steady;

/* Moves a steady state by any time; it may leave its range. */
void coin_priv_steady_move(coin_state *s, const coin_priv_steady *rates,
                           double t);

#endif
