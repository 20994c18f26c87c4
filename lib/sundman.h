/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_SUNDMAN_H
#define ROLLCOIN_SUNDMAN_H

#include "stepper.h"

/* A coin that comes nearer to flat than this lies flat: its pass would be over
 * in no time that a double can tell. */
#define COIN_PRIV_FLAT 1e-30

/* The step in tau of the given stride from here: about 1 for a coarse look at
 * the motion, less for accuracy (advance.c). */
double coin_priv_sundman_tau(const coin_priv_body *b, const coin_priv_stage *y,
                             double stride);

/* One step of order 8 in tau; adds the time it takes to pose.t.  0, and *c
 * untouched, if it would not be sound. */
int coin_priv_sundman_step(coin_priv_carry *c, const coin_priv_body *b,
                           double tau);

#endif
