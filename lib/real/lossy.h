/* SPDX-License-Identifier: MIT */
/* Steps of a coin with losses, in Sundman's time. */
#ifndef ROLLCOIN_LOSSY_H
#define ROLLCOIN_LOSSY_H

#include "../step/run.h"

#include "losses.h"

/* Friction is not smooth where the contact turns round, d(psi)/dt = 0.  A step
 * is planned to cover at most this part of the way to there.  With
 * half of it there are 4 to 10 % more steps.  With twice as much there are 3 to
 * 10 % fewer, but at tol = 1e-9 one call in 100 errs by 10 tol (make tuning).
 */
#define COIN_PRIV_TURN_ROUND 0.5

/* A step that turns out to cover more than this part of the way is refused.
 * With 0.6 there are 2 to 7 % more steps, and the median error falls by a
 * third.  With 0.8 there are up to 2 % fewer, and the largest error grows from
 * 0.8 to 1.1 tol.  If none is refused, the largest error is 5 tol at tol = 1e-4
 * (make tuning). */
#define COIN_PRIV_TURNED 0.7

/* A coin with losses under way. */
typedef struct coin_priv_lossy {
    coin_priv_losses l;
    coin_priv_run run;
    double du; /* d(u)/dtau where a step begins, u = cos(theta) d(psi)/dt: set
                  by coin_priv_lossy_bound() */
} coin_priv_lossy;

/* A step tried: where it leads, and its error. */
typedef struct coin_priv_trial {
    coin_priv_variables next;
    coin_priv_pose adds; /* adds.t: the time that the step takes */
    double error;        /* estimated, of rates, sines and cosines;
                            1e100 if the step goes too near to where the contact
                            turns round; infinite if a stage or the end would
                            be below the table, or not finite */
} coin_priv_trial;

/* Tries a step; `effect` as in coin_priv_lossy_bound(). */
void coin_priv_lossy_try(coin_priv_trial *trial, const coin_priv_lossy *w,
                         double tau, double effect);

/* The rate over which a step's length is measured [1/T]: the coin's own rate in
 * tau, plus a part of that of the friction. */
double coin_priv_lossy_rate(const coin_priv_lossy *w);

/* The tau in which a step covers COIN_PRIV_TURN_ROUND of the way to where the
 * contact turns round, d(psi)/dt = 0, and friction is not smooth; infinite if
 * there is no such place.  An effect on the rates below `effect` natural units
 * is not resolved. */
double coin_priv_lossy_bound(coin_priv_lossy *w, double effect);

/* The same, where w->du is known. */
double coin_priv_turn_bound(const coin_priv_lossy *w, double effect);

/* The part of the way to where the contact turns round that a step of tau
 * covers; 0 if it is small.  `then` is u after the step.  Within the step u is
 * taken as a parabola: it begins with the slope w->du, which is almost 0 where
 * the contact rolls fastest. */
double coin_priv_part_of_way(const coin_priv_lossy *w, double then, double tau,
                             double effect);

/* Sets the lean to flat, and keeps the rate of fall: COIN_RESTS. */
int32_t coin_priv_lay_flat(coin_priv_run *r);

#endif
