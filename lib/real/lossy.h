/* SPDX-License-Identifier: MIT */
/* Steps of a coin with losses, in Sundman's time. */
#ifndef ROLLCOIN_LOSSY_H
#define ROLLCOIN_LOSSY_H

#include "../step/run.h"

#include "losses.h"

/* A step is made so long that it covers this part of the way to where the
 * contact turns round, d(psi)/dt = 0: friction is not smooth there.  A half
 * takes 4 to 10 % more steps than this.  All of the way saves 3 to 10 %, but at
 * tol = 1e-9 one of 100 random calls then errs by 10 tol (make tuning). */
#define COIN_PRIV_TURN_ROUND 0.5

/* A step that has covered more than this part of it is refused.  With 0.6 there
 * are 2 to 7 % more steps, and the median error is 2/3.  0.8 saves 2 % at most,
 * for a largest error of 1.1 instead of 0.8 tol.  Without refusals, which save
 * 4
 * %, the largest error is 5 tol at tol = 1e-4 (make tuning). */
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
    double error;        /* estimated; natural units, radians and radii;
                            1e100 if the step goes too near to where the contact
                            turns round; infinite if a stage or the end would
                            be below the table, or not finite */
} coin_priv_trial;

/* Tries a step; `least` is the `error` of coin_priv_lossy_bound(). */
void coin_priv_lossy_try(coin_priv_trial *trial, const coin_priv_lossy *w,
                         double tau, double least);

/* The rate over which a step's length is measured [1/T]: the coin's own rate in
 * tau, plus a part of that of the friction. */
double coin_priv_lossy_rate(const coin_priv_lossy *w);

/* The largest tau of a step that does not pass the place where the contact
 * turns round, d(psi)/dt = 0, and friction is not smooth; infinite if there is
 * none.  An effect on the rates below `error` natural units is not resolved. */
double coin_priv_lossy_bound(coin_priv_lossy *w, double error);

/* The same by w->du. */
double coin_priv_way_to_turn(const coin_priv_lossy *w, double error);

/* Which part of the way to where the contact turns round a step of tau covers,
 * after which u is `then`; 0 for a small part.  u is taken as a parabola: where
 * a step begins next to the largest u, w->du is almost 0. */
double coin_priv_part_of_way(const coin_priv_lossy *w, double then, double tau,
                             double error);

/* Sets the lean to flat, and keeps the rate of fall: COIN_RESTS. */
int32_t coin_priv_lay_flat(coin_priv_run *r);

#endif
