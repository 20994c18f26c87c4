/* SPDX-License-Identifier: MIT */
/* Steps in Sundman's time tau, dt = cos theta dtau. */
#ifndef ROLLCOIN_SUNDMAN_H
#define ROLLCOIN_SUNDMAN_H

#include "run.h"

/* A coin that comes nearer to flat than this lies flat: its pass would be over
 * in no time that a double can tell. */
#define COIN_PRIV_FLAT 1e-30

/* The tau of a step of the given stride from here.  A stride of 1 is the tau in
 * which the motion changes: 1 over the coin's own rate. */
double coin_priv_sundman_tau(const coin_priv_body *b,
                             const coin_priv_variables *y, double stride);

/* Ends a step in tau that was accepted: y are the variables at its end, adds
 * what it adds to the pose.  0, and *r untouched, if phi or psi leave their
 * range. */
int coin_priv_sundman_accept(coin_priv_run *r, const coin_priv_variables *y,
                             const coin_priv_pose *adds);

/* Takes theta from its pair, after steps in tau and before a step in t. */
void coin_priv_read_lean(coin_priv_progress *g);

#endif
