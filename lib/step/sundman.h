/* SPDX-License-Identifier: MIT */
/* Steps in Sundman's time tau, dt = cos theta dtau. */
#ifndef ROLLCOIN_SUNDMAN_H
#define ROLLCOIN_SUNDMAN_H

#include "run.h"

/* Where cos theta is less than this, the coin counts as flat.  A pass as close
 * as that would take less time than a double resolves. */
#define COIN_PRIV_FLAT 1e-30

/* The tau of a step of the given stride from here: the stride divided by the
 * coin's own rate.  In a step of stride 1 the motion changes by about its own
 * size. */
double coin_priv_sundman_tau(const coin_priv_body *b,
                             const coin_priv_variables *y, double stride);

/* The tau in which the time rem passes from here, to third order. */
double coin_priv_tau_of(const coin_priv_body *b, const coin_priv_variables *y,
                        double rem);

/* Ends a step in tau that was accepted: y are the variables at its end, adds
 * what it adds to the pose.  0, and *r untouched, if the pose leaves its range.
 */
int coin_priv_sundman_accept(coin_priv_run *r, const coin_priv_variables *y,
                             const coin_priv_pose *adds);

/* Takes theta from its pair, after steps in tau and before a step in t. */
void coin_priv_read_lean(coin_priv_progress *g);

#endif
