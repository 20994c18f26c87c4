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
    double tau; /* how long it lasts.  If t is not 0, it is a guess until
                   coin_priv_stretch_know() has computed it */
    double t;   /* 0 if all its steps were in tau.  Else the last step was one
                   in t, and the stretch lasts t */
    coin_priv_force_series force;
} coin_priv_stretch;

/* Computes so many terms of the force.  If t is not 0, it also computes tau
 * from t, by the terms of cos theta.  Pre: t is 0 or terms > 1. */
void coin_priv_stretch_know(coin_priv_stretch *w, int terms);

#endif
