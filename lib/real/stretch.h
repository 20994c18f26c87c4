/* SPDX-License-Identifier: MIT */
/* A stretch of a motion: where it begins and ends, how long it lasts in tau,
 * and the force at both ends. */
#ifndef ROLLCOIN_STRETCH_H
#define ROLLCOIN_STRETCH_H

#include "../step/extrapolation.h"

#include "force.h"

/* The unit of time of the series is the same in all stretches of a call, so
 * that the end of one is the begin of the next. */
typedef struct coin_priv_stretch {
    coin_priv_run from;     /* the run at its begin */
    coin_priv_variables to; /* the variables at its end */
    double unit;
    double tau; /* how long it lasts, exact if t is 0 */
    double t;   /* if not 0: its last step was one in t, the whole lasts t */
    coin_priv_force begin, end;
} coin_priv_stretch;

/* Computes what is not known yet of so many terms: of the forces, and the tau
 * of a stretch whose t is not 0, to the accuracy of the terms. */
void coin_priv_stretch_know(coin_priv_stretch *w, int terms);

#endif
