/* SPDX-License-Identifier: MIT */
/* Steps of a coin with losses, in Sundman's time. */
#ifndef ROLLCOIN_LOSSY_H
#define ROLLCOIN_LOSSY_H

#include "../step/run.h"

#include "losses.h"

/* A coin with losses under way. */
typedef struct coin_priv_lossy {
    coin_priv_losses l;
    coin_priv_run run;
} coin_priv_lossy;

/* A step tried: where it leads, and how far it may be off. */
typedef struct coin_priv_trial {
    coin_priv_variables next;
    coin_priv_pose adds; /* adds.t: the time that the step takes */
    double error;        /* estimated; natural units, radians and radii;
                            infinite if a stage or the end would be below
                            the table, or not finite */
} coin_priv_trial;

void coin_priv_lossy_try(coin_priv_trial *trial, const coin_priv_lossy *w,
                         double tau);

/* What a step's length is measured by [1/T]: the rate at which the coin moves
 * in tau, and the rate at which friction does. */
double coin_priv_lossy_rate(const coin_priv_lossy *w);

/* The largest tau that does not step over the place where the contact turns
 * round, d(psi)/dt = 0, where friction is not smooth; infinite without it.
 * What is below `error` natural units of rate is not resolved. */
double coin_priv_lossy_bound(const coin_priv_lossy *w, double error);

#endif
