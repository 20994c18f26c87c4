/* SPDX-License-Identifier: MIT */
/* A coin on the table, on its way through the modes of law.h.  docs/design.md,
 * "The modes of a coin", says what each mode computes and what ends it. */
#ifndef ROLLCOIN_MOVE_H
#define ROLLCOIN_MOVE_H

#include "../step/run.h"

#include "../motion/rest.h"
#include "dop853.h"

/* The longest stride.  The losses' own rate is then followed in steps of at
 * most 4 of its relaxation times (move.c), and that of the direction of a slip
 * in 5; the method is stable up to 6.  Half of it costs 31 % more; twice of it
 * is not stable (make tuning). */
#define COIN_PRIV_MOST_STRIDE 1.2

/* COIN_NEARLY_FLAT begins some units of rounding lower, so that it also holds
 * where the lean is rounded. */
#define COIN_PRIV_NEARLY (COIN_PRIV_NEARLY_FLAT - 8 * DBL_EPSILON)

/* The slip speed below which a coin rolls, in natural units, besides the
 * rounding of the speeds whose difference it is: a promise of coin.h.  A
 * hundredth or a hundred times of it changes no motion of make tuning. */
#define COIN_PRIV_SLIP_LEAST 1e-10

/* begin.c sets what a coin starts with, but for the law and the trials.  Then
 * only move.c changes its mode and its pose. */
typedef struct coin_priv_moving {
    coin_priv_law law;
    double tol;
    int32_t stop;  /* the bits that end the call */
    int32_t event; /* COIN_ROLLS or COIN_TOUCHES, where they begin here */
    int tries;     /* of steps: how many are left of the whole call */

    int mode;              /* COIN_PRIV_SLIPS ... */
    coin_priv_sum pose[5]; /* phi, psi; x, z and t since the start, which
                              is that of this contact */
    double start[5];       /* phi, psi, x, z of the start in radii; 0 */
    double time;           /* from the start to the end of the call */
    int changed;           /* whether the coin is not as at the start */

    double stride; /* the length of steps, over 1/rate; 0 is not known */
    double margin; /* coin_priv_contact_margin() at step.y, of the mode in
                      which the next step is made */
    coin_priv_dop853 step; /* its slope[0] is set where a step begins */
} coin_priv_moving;

/* begin.c: scales a state to units in which lengths and rates are these times
 * what they were. */
void coin_priv_scale(coin_state *s, double length, double rate);

/* begin.c: starts a coin in a mode, in natural units, from a state, its
 * variables and its slip velocity; g->law is set, and g->tries is not. */
void coin_priv_begin(coin_priv_moving *g, const coin_state *s,
                     const coin_priv_variables *v, int mode, const double u[2],
                     double time, double tol);

/* begin.c: the state, if g->changed, to which the coin that began as *s has
 * come. */
void coin_priv_end(const coin_priv_moving *g, coin_state *s);

/* begin.c: the time moved, in units of t: t itself if all of `time`, the same
 * time in natural units, was moved. */
double coin_priv_reached(const coin_priv_sum *moved, double time, double t,
                         double w0);

/* Moves until the time is over, the mode becomes AIR or RESTS, or a bit of stop
 * holds.  event: COIN_TOUCHES or COIN_ROLLS, where they begin at the start.
 * COIN_OK, or the stop bits that hold at the end; COIN_ESTEP, COIN_ERANGE. */
int32_t coin_priv_go(coin_priv_moving *g, int32_t stop, int32_t event);

/* events.c: the first event within the step just made, of `stride` radians of
 * the motion: 1, and the variables just after it, if there is one. */
int coin_priv_first_event(double *cut, coin_priv_moving *g, double stride);

/* What a coin does where it is: its mode, or the mode that it changes to.  Sets
 * g->margin. */
int coin_priv_next_mode(coin_priv_moving *g);

/* onset.c: moves on a coin whose contact leaves the cone of friction, or whose
 * slip is slow, by a step in which the slip has the direction of an onset:
 * COIN_OK, or as coin_priv_accept().  *slips: whether it slips then. */
int32_t coin_priv_begin_slip(coin_priv_moving *g, int *slips);

/* onset.c: whether a coin slips so slowly, with the direction of an onset, that
 * coin_priv_begin_slip() makes its next step.  g->step.slope[0] is set. */
int coin_priv_slips_slowly(const coin_priv_moving *g);

/* onset.c: ends the slip of a coin that slips by a straight line, where that is
 * accurate; else 0. */
int coin_priv_end_slip(coin_priv_moving *g);

/* Sets the norm of the two pairs to 1.  A step leaves a difference of the size
 * of its error. */
COIN_PRIV_INLINE void coin_priv_normalize_pairs(double *y)
{
    const double s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
    const double sph = y[COIN_PRIV_SPH], cph = y[COIN_PRIV_CPH];
    const double th = 1 / sqrt(s * s + c * c);
    const double ph = 1 / sqrt(sph * sph + cph * cph);
    y[COIN_PRIV_S] *= th;
    y[COIN_PRIV_C] *= th;
    y[COIN_PRIV_SPH] *= ph;
    y[COIN_PRIV_CPH] *= ph;
}

/* The time left of the call. */
COIN_PRIV_INLINE double coin_priv_time_left(const coin_priv_moving *g)
{
    return (g->time - g->pose[4].sum) - g->pose[4].low;
}

/* Whether a tolerance, and a time t, may be asked for. */
COIN_PRIV_INLINE int coin_priv_tol_suits(double tol)
{
    return tol >= 1e-12 && tol <= 1e-2;
}

COIN_PRIV_INLINE int coin_priv_time_suits(double t, double w0)
{
    return t >= 0 && (t * w0 <= COIN_PRIV_TIME_MAX || t > DBL_MAX);
}

/* move.c: adds what a step has added, with y[PHI], ... becoming 0: COIN_OK; or
 * COIN_ERANGE, or COIN_ESTEP if a rate would leave its range, and nothing is
 * done.  ends: the step ends the call, so that no time is left. */
int32_t coin_priv_accept(coin_priv_moving *g, const double *y, int ends);

/* move.c: the rate of the motion in tau, or in t while the contact is held. The
 * factor of a slip's time, (83), is not in it. */
double coin_priv_rate(const double *y, const coin_priv_law *l, int mode);

/* move.c: the rate in tau at which the losses make the rates decay. */
double coin_priv_loss_rate(const double *y, const coin_priv_law *l, int mode);

#endif
