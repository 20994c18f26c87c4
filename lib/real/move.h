/* SPDX-License-Identifier: MIT */
/* A coin on the table, on its way through the modes of law.h.  docs/design.md,
 * "The modes of a coin", says what each mode computes and what ends it. */
#ifndef ROLLCOIN_MOVE_H
#define ROLLCOIN_MOVE_H

#include "../motion/state.h"
#include "dop853.h"

/* The longest stride.  The losses' own rate is then followed in steps of at
 * most 4 of its relaxation times (move.c), and that of the direction of a slip
 * in 5; the method is stable up to 6.  Measured: COIN_PRIV_MOST_STRIDE in
 * tables.md. */
#define COIN_PRIV_MOST_STRIDE 1.2

/* A step that crosses the cos theta of COIN_NEARLY_FLAT ends so far beyond it
 * that the lean, which is rounded, is beyond it too. */
#define COIN_PRIV_BEYOND (8 * DBL_EPSILON)

/* The slip speed below which a coin rolls, in natural units, besides the
 * rounding of the speeds whose difference it is: a promise of coin.h. Measured:
 * COIN_PRIV_SLIP_LEAST in tables.md. */
#define COIN_PRIV_SLIP_LEAST 1e-10

/* A call sets the first part; begin.c sets what a coin in contact starts with.
 * Then only move.c changes its mode and its pose. */
typedef struct coin_priv_moving {
    coin_priv_law law;
    double time, tol;
    coin_priv_sum moved; /* the time so far */
    int32_t stop;        /* the moments that end the call */
    int32_t was;         /* what held last, as coin_priv_moments(); -1 at the
                            start of the call */
    int32_t found;       /* the moments that have ended the call; COIN_MORE */
    int tries;           /* of steps: how many are left */

    coin_priv_coin c; /* of a coin in contact, only phi, psi, x and z: step.y
                         has the rest until the contact ends */
    int changed; /* whether the coin is not as it was when the call began; in a
                    contact, when that did */

    int mode;      /* COIN_PRIV_SLIPS ... */
    double stride; /* the length of steps, over 1/rate, on the line a time; 0 is
                      not known */
    double slow;   /* in the step of a slow slip, (onset.c), the speed up to
                      which it is slow; its uX, uh are those of (1 + u) n, so
                      that u has a sign; else 0 */
    double margin; /* coin_priv_contact_margin() at step.y, of the mode in
                      which the next step is made */
    coin_priv_dop853 step; /* its slope[0] is set where a step begins */
} coin_priv_moving;

/* begin.c: scales a state to units in which lengths and rates are these times
 * what they were. */
void coin_priv_scale(coin_state *s, double length, double rate);

/* begin.c: sets *c to a state in natural units.  Height and velocity become
 * 0. */
void coin_priv_set_state(coin_priv_coin *c, const coin_state *s, double half);

/* begin.c: the state of a coin, in natural units. */
void coin_priv_get_state(coin_state *s, const coin_priv_coin *c);

/* begin.c: sets height and velocity to those of a coin that rolls on the rim at
 * eta, or on the line between both, 0. */
void coin_priv_set_rolling(coin_priv_coin *c, double eta);

/* begin.c: sets all but phi, psi, x and z to variables of a contact on the rim
 * at eta. */
void coin_priv_set_contact(coin_priv_coin *c, const double *y, double eta);

/* begin.c: a call of this time and tolerance, with no bits of stop. */
void coin_priv_begin_call(coin_priv_moving *g, double time, double tol,
                          int tries);

/* begin.c: sets the variables of a contact, step.y, to the coin g->c with a
 * slip velocity, in a mode. */
void coin_priv_begin(coin_priv_moving *g, int mode, const double u[2]);

/* begin.c: sets g->c to the variables of a contact that ends.  A contact
 * integrates the heading twice: as phi, and as its sine and cosine.  Without a
 * pull phi is kept.  With one, sine and cosine are: the force depends on them.
 */
void coin_priv_end(coin_priv_moving *g);

/* begin.c: the time moved by a call of `time`, in units of t: t itself if all
 * of it was moved. */
double coin_priv_reached(const coin_priv_moving *g, double time, double t,
                         double w0);

/* Moves a coin in contact until the time is over or the contact ends; g->mode
 * then has AIR, RESTS or ROCKS.  Sets g->c to the coin at the end, if anything
 * has changed.  Returns COIN_OK, or COIN_ERANGE. */
int32_t coin_priv_go(coin_priv_moving *g);

/* Ends the call here: no time is left.  why: what coin_move() says besides the
 * mode. */
void coin_priv_end_here(coin_priv_moving *g, int32_t why);

/* The coin now is as these bits say: COIN_LIFTS, in the air; COIN_SLIPS;
 * COIN_RESTS; COIN_NEARLY_FLAT, besides one of the last two or alone.  Ends the
 * call if this is a moment of g->stop. */
void coin_priv_moments(coin_priv_moving *g, int32_t is);

/* events.c: the first event within the step just made, of `stride` radians of
 * the motion: 1, and the variables just after it, if there is one. */
int coin_priv_first_event(double *cut, coin_priv_moving *g, double stride);

/* move.c: by how much the energy of a coin is above that of balancing on a
 * rim. */
double coin_priv_undecided(const coin_priv_coin *c, const coin_priv_law *l);

/* thrown.c: moves through all modes until the time is over, the coin rests or a
 * moment of stop has come: the mode, or-ed with the moments and COIN_MORE;
 * COIN_ERANGE.  The call has begun. */
int32_t coin_priv_go_on(coin_priv_moving *g);

/* What a coin does where it is: its mode, or the mode that it changes to.  Sets
 * g->margin. */
int coin_priv_next_mode(coin_priv_moving *g);

/* Begins or ends to hold the contact. */
void coin_priv_set_held(coin_priv_moving *g);

/* onset.c: begins the slip of a coin whose contact leaves the cone of friction,
 * as a slow one. */
void coin_priv_begin_slip(coin_priv_moving *g);

/* onset.c: whether a coin slips slowly; begins a step of it then.
 * g->step.slope[0] is set. */
int coin_priv_slips_slowly(coin_priv_moving *g);

/* onset.c: sets the slip of *y from how it is written while it is slow. */
void coin_priv_end_slow(const coin_priv_moving *g, double *y);

/* onset.c: the slopes of a slow slip, by the time of the mode without a slip,
 * or by t. */
int coin_priv_slow_rates(double *d, const double *y,
                         const coin_priv_problem *of);

/* onset.c: ends the slip of a coin that slips by a straight line, where that is
 * accurate; else 0. */
int coin_priv_end_slip(coin_priv_moving *g);

/* How fast a coin moves that nothing leans: the larger of its roll and its
 * slip; infinity of any other. */
COIN_PRIV_INLINE double coin_priv_upright_speed(const double *y)
{
    const double uX = y[COIN_PRIV_UX], uh = y[COIN_PRIV_UH];
    if (y[COIN_PRIV_S] != 0 || y[COIN_PRIV_WX] != 0 || y[COIN_PRIV_WY] != 0)
        return (double)INFINITY;
    return coin_priv_larger(fabs(y[COIN_PRIV_WZ]), sqrt(uX * uX + uh * uh));
}

/* The time left of the call. */
COIN_PRIV_INLINE double coin_priv_time_left(const coin_priv_moving *g)
{
    return (g->time - g->moved.sum) - g->moved.low;
}

/* Adds a time, or all that is left. */
COIN_PRIV_INLINE void coin_priv_spend(coin_priv_moving *g, double t, int all)
{
    const coin_priv_sum whole = {g->time, 0};
    if (all)
        g->moved = whole;
    else
        coin_priv_add(&g->moved, t);
}

/* Whether a tolerance, and a time t, may be asked for. */
COIN_PRIV_INLINE int coin_priv_tol_in_range(double tol)
{
    return tol >= 1e-12 && tol <= 1e-2;
}

COIN_PRIV_INLINE int coin_priv_duration_in_range(double t, double w0)
{
    return t >= 0 && (t * w0 <= COIN_PRIV_TIME_MAX || t > DBL_MAX);
}

/* move.c: adds what a step has added, with y[PHI], ... becoming 0: COIN_OK; or
 * COIN_ERANGE, and nothing is done.  ends: the step ends the call, so that no
 * time is left. */
int32_t coin_priv_accept(coin_priv_moving *g, const double *y, int ends);

/* move.c: the rate of the motion in tau, or in t while the contact is held. The
 * factor of a slip's time, (83), is not in it. */
double coin_priv_rate(const double *y, const coin_priv_law *l, int mode);

/* move.c: the rate in tau at which the losses make the rates decay. */
double coin_priv_loss_rate(const double *y, const coin_priv_law *l, int mode);

#endif
