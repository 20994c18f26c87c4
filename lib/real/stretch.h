/* SPDX-License-Identifier: MIT */
/* A stretch of a motion: where it begins and ends, how long it lasts in tau,
 * and the force at both ends. */
#ifndef ROLLCOIN_STRETCH_H
#define ROLLCOIN_STRETCH_H

#include "../step/extrapolation.h"

#include "force.h"

typedef struct coin_priv_stretch {
    coin_priv_run from;     /* the run at its begin */
    coin_priv_variables to; /* the variables at its end */
    double unit;            /* of the series */
    double tau;             /* how long it lasts, exact if t is 0 */
    double t; /* if not 0: its last step was one in t, the whole lasts t */
    coin_priv_force force;
} coin_priv_stretch;

/* Computes so many terms of the force, and by them the tau of a stretch whose t
 * is not 0; t is 0 if only one term is asked for. */
void coin_priv_stretch_know(coin_priv_stretch *w, int terms);

#endif
