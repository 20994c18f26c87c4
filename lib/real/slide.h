/* SPDX-License-Identifier: MIT */
/* A coin that rolls and slips by turns. */
#ifndef ROLLCOIN_SLIDE_H
#define ROLLCOIN_SLIDE_H

#include "../step/advance.h"

#include "cone.h"
#include "lossy.h"
#include "stretch.h"

/* Slip speeds in natural units.  A slip that slows to SLIP_LEAST ends.  One
 * begins with SLIP_SEED, twice that, so that it does not end at once.  If
 * both are multiplied by 0.1 or 10, random slides have the same errors, and
 * numbers of steps within 0.1 % (make tuning).  Other tests are stricter.  If
 * both are doubled, a slip is ended that would turn round and go on
 * (test_slide_stiff).  With 0.1 the time of rest depends on the calls
 * (test_slide_rest).  Half passes. */
#define COIN_PRIV_SLIP_LEAST 1e-10
#define COIN_PRIV_SLIP_SEED 2e-10

/* A slide under way. */
typedef struct coin_priv_sliding {
    /* Set by slide.c for the whole call. */
    coin_params p; /* for coin_settle() and searches of the cone */
    coin_losses losses;
    int lossy; /* whether it has losses */
    double tol;
    coin_priv_lengths lengths;
    coin_priv_contact contact; /* but slip.c and onset.c set psi_held */

    /* Where the slide is.  roll.c, onset.c and slip.c move it. */
    coin_priv_lossy w; /* its run holds all but the slip; its losses are those
                          of a coin that rolls */
    double uX, uh;     /* the slip velocity; while the coin rolls 0, or, of one
                          whose slip waits, what friction would have given it */
    int slips;         /* whether it slips now */
    coin_priv_sum rem; /* the time still to go */
    uint64_t tries;    /* of steps */
    int ended_in_t;    /* whether the last step was one in t: then the run
                      has theta */

    /* The steps of a rolling coin, of roll.c. */
    double roll_stride;
    coin_priv_progress from; /* where the step began: coin_priv_mark() */
    uint64_t steps;          /* the number of steps of the run there */
    coin_state stopped; /* where the losses were found to hold the contact */

    /* What cone_of_step.c knows of the force while the coin rolls. */
    int surely_rolls; /* 1: the force here is certainly within the cone.  0: it
                    is not, or that is not known */
    coin_priv_end ends[2]; /* with losses: of a step; ends[now] is here */
    int now;
    coin_priv_stretch series; /* without losses: the last step that was judged,
                                 if force.terms > 0.  Of its `from` only b and
                                 g.y are set */
    int turning_points; /* the number of turning points of the lean that were
                  passed since coin_priv_judge_here() */
    double least_sth, most_sth; /* the least and the largest sin theta at which
                           steps ended since coin_priv_judge_here() */

    /* The steps of a slip, of slip.c; onset.c sets the first stride. */
    double slip_stride;
    coin_priv_slip slope; /* by sigma, where the step began */
} coin_priv_sliding;

/* The most trials of a call.  A trial is a step, whether it is kept, refused or
 * made again, or a call of coin_settle(). */
#define COIN_PRIV_SLIDE_TRIES (UINT64_C(1) << 20)

/* The variables of a slip, with a pose of 0. */
coin_priv_slip coin_priv_slip_of(const coin_priv_variables *y, double uX,
                                 double uh);

/* Moves the run to *y, whose pose is the change since the last step; 0, and *r
 * untouched, if phi or psi would leave its range. */
int coin_priv_slip_into(coin_priv_run *r, const coin_priv_slip *y);

/* Moves the slide to *y: COIN_OK, or COIN_ESTEP as above. */
int32_t coin_priv_slip_take(coin_priv_sliding *g, const coin_priv_slip *y);

/* How near an event is located, as a part of the step, over tol.  So its error
 * is far below that of the step.  A tenth costs 1 % more steps.  100 times as
 * much saves 2 % and changes no error of a slide visibly (make tuning). */
#define COIN_PRIV_LOCATED 1e-3

/* A function of the length of a step that is 0 at an event. */
typedef double coin_priv_event(coin_priv_sliding *g, double h);

/* Returns an h in [0, h1] at or just before an event.  The function of the
 * event is at0 at 0, and at1 <= 0 at h1.  Returns 0 unless at0 > 0.  In roll.c
 * and onset.c the functions of events move the run, so that their caller has to
 * make the step to h afterwards. */
double coin_priv_locate(coin_priv_sliding *g, coin_priv_event *event,
                        double at0, double h1, double at1);

/* roll.c: tries a step of tau of a coin that rolls, from where the run is.
 * Returns
 *     -1      phi or psi would leave its range, or a step without losses would
 *             lead to the table: the step is not made
 *     0       made, without losses: its length was chosen for its error
 *     0 to 1  made, with losses: its error over what is allowed
 *     > 1     not made, with losses: its error is too large
 * added.t becomes the time moved, which is 0 if the step is not made. */
double coin_priv_roll_try(coin_priv_sliding *g, double tau);

/* The rate in tau by which the steps of a rolling coin are measured. */
double coin_priv_roll_rate(const coin_priv_sliding *g);

/* roll.c: the `effect` of coin_priv_lossy_bound(). */
double coin_priv_least_effect(const coin_priv_sliding *g);

/* slide.c: the size of what the slopes of a slip are products of. */
double coin_priv_slip_size(const coin_priv_contact *contact,
                           const coin_priv_slip *y);

/* slide.c: coin_priv_slip_slopes() for a step that is tried.  If the step is
 * far too long, the size grows from stage to stage.  Where it exceeds
 * contact->most, the slopes are 0 and that of t is NaN, so that nothing
 * overflows. */
void coin_priv_trial_slopes(double *dy, const double *y, const void *contact);

/* slide.c: the rate at which the coin's motion changes while it slips, in tau
 * or, if psi is held, in t. */
double coin_priv_slip_rate(const coin_priv_sliding *g);

/* A step as long as its error allows, at most `most`: its tau, or 0. */
double coin_priv_roll_step(coin_priv_sliding *g, double rate, double most);

/* coin_priv_mark() notes where a step begins.  coin_priv_again() repeats the
 * step from there, with another tau. */
void coin_priv_mark(coin_priv_sliding *g);
void coin_priv_again(coin_priv_sliding *g, double tau);

/* Subtracts the time of that step from the time left. */
void coin_priv_spend_time(coin_priv_sliding *g);

/* cone_of_step.c: computes the force where the run is, and sets
 * g->surely_rolls.  It starts a new count of turning points and a new range of
 * leans.  With losses it also sets g->ends[g->now]. */
void coin_priv_judge_here(coin_priv_sliding *g);

/* cone_of_step.c: judges the step just made.  Returns 1 if it is certain that
 * the coin rolls all along, 0 if it slips or if that is not certain. */
int coin_priv_judge_step(coin_priv_sliding *g, double tau, double rate);

/* coin_priv_clearance() where the run is, of a coin that rolls. */
double coin_priv_rolling_clearance(const coin_priv_sliding *g);

/* roll.c and slip.c: a step of a coin that rolls; of one that slips.  COIN_OK,
 * or a status that ends the call: COIN_RESTS, COIN_ELIFT, COIN_ESTEP. */
int32_t coin_priv_roll_on(coin_priv_sliding *g);
int32_t coin_priv_slip_on(coin_priv_sliding *g);

/* onset.c: goes on from where rolling needs too much friction.  The slip
 * begins, and g->slips becomes 1.  A slip that would grow too slowly waits: the
 * coin rolls on for one step, and g->uX and g->uh keep what friction would
 * have done. */
int32_t coin_priv_begin_slip(coin_priv_sliding *g);

/* onset.c, for a coin near flat whose contact is held by the losses: its
 * clearance, and the beginning of its slip.  coin_priv_begin_held_slip()
 * returns 0, and does nothing, if the coin does not slip. */
double coin_priv_held_clearance(const coin_priv_sliding *g);
int coin_priv_begin_held_slip(coin_priv_sliding *g);

#endif
