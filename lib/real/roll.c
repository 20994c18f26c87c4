/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../step/extrapolation.h"

#include "control.h"
#include "hold.h"
#include "slide.h"

/* If the last step but one is shorter than this part of the stride, it and the
 * last step are judged together, which saves a series of the force.  Only the
 * cost depends on it: by half of it the series are 2 % more (make tuning).  A
 * longer step and the last one together may need more terms. */
#define TOGETHER 0.9

/* A step of coin_priv_again() no longer than this is none.  Its inverse is far
 * from overflow. */
#define NO_STEP 1e-250

/* Whether a step shorter than this part of the time in which the motion changes
 * leaves the cone is told by its ends. */
#define SHORTEST 1e-8

/* A coin that falls back within coin_priv_rise_time() is highest at half of it.
 * This part is a little more, so that the coin then falls.  How much more is
 * free: it only has to exceed rounding. */
#define TOP 0.505

double coin_priv_least_effect(const coin_priv_sliding *g)
{
    return coin_priv_allowed_in(&g->w.run, g->tol, COIN_PRIV_BRIEF);
}

/* As coin_priv_roll_try(), but a step is accepted whose error is at most
 * `worst` times what is allowed. */
static double roll_by(coin_priv_sliding *g, double tau, double worst)
{
    coin_priv_run *const r = &g->w.run;
    ++g->tries;
    r->g.added.t = 0;
    if (!g->lossy)
        return coin_priv_extrapolate(r, tau) ? 0 : -1;
    coin_priv_trial trial;
    coin_priv_lossy_try(&trial, &g->w, tau, coin_priv_least_effect(g));
    const double most = coin_priv_allowed(r, g->tol, trial.adds.t);
    const double error = trial.error / most;
    if (error <= worst &&
        !coin_priv_sundman_accept(r, &trial.next, &trial.adds))
        return -1;
    return error;
}

double coin_priv_roll_try(coin_priv_sliding *g, double tau)
{
    return roll_by(g, tau, 1);
}

double coin_priv_roll_rate(const coin_priv_sliding *g)
{
    const coin_priv_run *r = &g->w.run;
    return g->lossy ? coin_priv_lossy_rate(&g->w)
                    : 1 / coin_priv_sundman_tau(&r->b, &r->g.y, 1);
}

void coin_priv_mark(coin_priv_sliding *g)
{
    g->from = g->w.run.g;
    g->steps = g->w.run.steps;
}

/* A part of a step that was accepted is accepted too, even if its error is
 * estimated to be larger. */
void coin_priv_again(coin_priv_sliding *g, double tau)
{
    g->w.run.g = g->from;
    g->w.run.steps = g->steps;
    g->w.run.g.added.t = 0;
    g->ended_in_t = 0;
    if (fabs(tau) > NO_STEP)
        (void)roll_by(g, tau, DBL_MAX);
    else
        ++g->tries;
}

double coin_priv_rolling_clearance(const coin_priv_sliding *g)
{
    const coin_priv_slip y = coin_priv_slip_of(&g->w.run.g.y, 0, 0);
    return coin_priv_clearance(&g->contact, &y, 0);
}

static double step_to_clearance(coin_priv_sliding *g, double tau)
{
    coin_priv_again(g, tau);
    return coin_priv_rolling_clearance(g);
}

void coin_priv_spend_time(coin_priv_sliding *g)
{
    coin_priv_add(&g->rem, -g->w.run.g.added.t);
}

/* Takes the rest of the time in one step in t, as coin_advance() does.  Returns
 * its tau, or 0 if the step fails. */
static double step_to_end(coin_priv_sliding *g, double left)
{
    coin_priv_run *const r = &g->w.run;
    coin_priv_sum rem = {left, 0};
    const double tau = coin_priv_tau_of(&r->b, &r->g.y, left);
    if (r->steps > 0)
        coin_priv_read_lean(&r->g);
    const int done = coin_priv_last_step(r, &g->lengths, &rem) == COIN_OK;
    r->g.added.t = g->rem.sum;
    g->ended_in_t = done;
    return done ? tau : 0;
}

/* For how long coin_settle() may move a coin whose contact is held by the
 * losses: to the end of the time, or to the end of a rise.  A coin needs most
 * friction there. */
static double time_held(const coin_priv_sliding *g)
{
    const coin_priv_held_fall f = coin_priv_fall_of(&g->w.l, &g->w.run.g.y);
    if (!(f.v < 0))
        return g->rem.sum;
    const double rise = coin_priv_rise_time(&f, &g->w.l, &g->w.run.b);
    return coin_priv_lesser(TOP * rise, g->rem.sum);
}

/* Moves the coin by coin_settle(), from g->stopped.  *time is the time to move,
 * and becomes the time moved. */
static int32_t settle(coin_priv_sliding *g, double *time)
{
    coin_state s = g->stopped;
    double moved = 0;
    const int32_t status =
        coin_settle(&s, &g->p, &g->losses, *time, g->tol, &moved);
    *time = moved;
    ++g->tries;
    coin_priv_run_unlimited(&g->w.run, &s);
    g->w.run.steps = 1;
    return status;
}

static double settle_to_clearance(coin_priv_sliding *g, double time)
{
    (void)settle(g, &time);
    return coin_priv_held_clearance(g);
}

/* What leave() returns, beside a status, for a coin that begins no slip. */
#define STAYS 1

/* Begins the slip of a coin whose contact was held, where the force leaves the
 * cone of friction; COIN_ELIFT if no force makes it slip. */
static int32_t leave(coin_priv_sliding *g)
{
    if (g->contact.mu_static > DBL_MAX)
        return COIN_ELIFT;
    return coin_priv_begin_held_slip(g) ? COIN_OK : STAYS;
}

/* A coin near flat whose contact is held by the losses: coin_settle() takes it
 * to the table, or as far as it rises; or to where it slips. */
static int32_t go_held(coin_priv_sliding *g)
{
    const double before = coin_priv_held_clearance(g);
    double moved = time_held(g);
    if (before >= 0)
        g->uX = g->uh = 0;
    const int whole = moved == g->rem.sum;
    g->surely_rolls = 0;
    if (before < 0) {
        const int32_t leaves = leave(g);
        if (leaves != STAYS)
            return leaves;
    }
    coin_priv_read_lean(&g->w.run.g);
    g->stopped = coin_priv_run_state(&g->w.run);
    int32_t status = settle(g, &moved);
    const double end = coin_priv_held_clearance(g);
    if (before >= 0 && end < 0) {
        const coin_priv_sum rem = g->rem;
        double part =
            coin_priv_locate(g, settle_to_clearance, before, moved, end);
        (void)settle(g, &part);
        coin_priv_add(&g->rem, -part);
        const int32_t leaves = leave(g);
        if (leaves != STAYS)
            return leaves;
        g->rem = rem;
        status = settle(g, &moved);
    }
    coin_priv_add(&g->rem, -moved);
    if (status == COIN_OK && whole)
        g->rem.sum = 0;
    return status;
}

/* Whether the losses hold the contact. */
static int is_held(const coin_priv_sliding *g)
{
    const double eps = coin_priv_stopped(g->tol);
    const coin_priv_variables *y = &g->w.run.g.y;
    return g->lossy && coin_priv_is_held(&g->w.l, &g->w.run.b, y, eps);
}

/* The tau of the next step.  It is limited by the time left, by the stride, and
 * by `bound`. */
static double next_tau(const coin_priv_sliding *g, double rate, double bound)
{
    const coin_priv_run *r = &g->w.run;
    const double rem = g->rem.sum, side = rem < 0 ? -1 : 1;
    const double own = g->roll_stride / rate, full = own < bound ? own : bound;
    if (!(fabs(rem) < 2 * full * r->g.y.cth))
        return side * full;
    const double tau = coin_priv_tau_of(&r->b, &r->g.y, rem);
    return fabs(tau) < full ? tau : side * full;
}

/* Whether a short step takes the rest of the time. */
static int is_last(const coin_priv_sliding *g, double rem, double rate)
{
    const coin_priv_run *r = &g->w.run;
    if (g->lossy)
        return fabs(rem) * rate <= COIN_PRIV_LAST_LOSSY * r->g.y.cth;
    return coin_priv_one_step_suffices(r, &g->lengths, rem);
}

double coin_priv_roll_step(coin_priv_sliding *g, double rate, double most)
{
    double bound = most;
    if (g->lossy)
        bound = coin_priv_lesser(
            coin_priv_lossy_bound(&g->w, coin_priv_least_effect(g)), most);
    for (;;) {
        const double tau = next_tau(g, rate, bound), used = fabs(tau) * rate;
        const double error = coin_priv_roll_try(g, tau);
        const int done = error <= 1;
        if (!g->lossy || error < 0)
            return error < 0 ? 0 : tau;
        g->roll_stride = coin_priv_next_stride(g->roll_stride, used, error, 1);
        if (done)
            return tau;
    }
}

/* Shortens the step made, of tau, to where the coin is known to roll.  Returns
 * 1 if the whole step was kept, 0 if a shorter one was, -1 if the coin leaves
 * the cone at its end. */
static int shorten(coin_priv_sliding *g, double tau, double rate)
{
    const coin_priv_slip from = coin_priv_slip_of(&g->from.y, 0, 0);
    const double before = coin_priv_clearance(&g->contact, &from, 0);
    for (int whole = 1;; whole = 0) {
        const coin_priv_slip to = coin_priv_slip_of(&g->w.run.g.y, 0, 0);
        const coin_priv_tested_step tested = {
            &g->contact, coin_priv_roll_slopes, &from, &to,
            tau,         fabs(tau) * rate,
        };
        double part = 1;
        const coin_priv_verdict is = tested.stride < SHORTEST
                                         ? COIN_PRIV_STAYS
                                         : coin_priv_test_cone(&tested, &part);
        if (is != COIN_PRIV_STAYS) {
            tau *= part;
            coin_priv_again(g, tau);
        }
        const double end = coin_priv_rolling_clearance(g);
        if (end < 0 && is != COIN_PRIV_UNCLEAR) {
            coin_priv_again(
                g, coin_priv_locate(g, step_to_clearance, before, tau, end));
            return -1;
        }
        if (is == COIN_PRIV_STAYS)
            return whole;
    }
}

/* Makes the next step, and with it the last one if that is near.  Returns the
 * tau of those made, or 0 if none could be.  *last: whether no time is left. */
static double next_step(coin_priv_sliding *g, double rate, int *last)
{
    double left = g->rem.sum, tau = 0;
    *last = is_last(g, left, rate);
    if (g->lossy) {
        const double rest = coin_priv_tau_of(&g->w.run.b, &g->w.run.g.y, left);
        tau = coin_priv_roll_step(g, rate, (double)INFINITY);
        *last &= tau == rest;
        return tau;
    }
    if (!*last) {
        tau = coin_priv_roll_step(g, rate, (double)INFINITY);
        if (tau == 0)
            return tau;
        left -= g->w.run.g.added.t;
        const int is_short = fabs(tau) * rate < TOGETHER * g->roll_stride;
        *last = (left != 0) & is_short & is_last(g, left, rate);
        if (!*last)
            return tau;
    }
    const double moved = g->w.run.g.added.t, more = step_to_end(g, left);
    if (more != 0)
        return tau + more;
    *last = 0;
    g->w.run.g.added.t = moved;
    return tau;
}

int32_t coin_priv_roll_on(coin_priv_sliding *g)
{
    const coin_priv_variables *y = &g->w.run.g.y;
    if (y->cth < COIN_PRIV_FLAT)
        return coin_priv_lay_flat(&g->w.run);
    if (g->rem.sum > 0 && is_held(g))
        return go_held(g);
    const double rate = coin_priv_roll_rate(g);
    const int back = g->rem.sum < 0; /* over a motion that has been judged */
    if (!g->surely_rolls && !back)
        coin_priv_judge_here(g);
    if (!g->surely_rolls && coin_priv_rolling_clearance(g) < 0)
        return coin_priv_begin_slip(g);
    g->uX = g->uh = 0;
    int last;
    coin_priv_mark(g);
    const double tau = next_step(g, rate, &last);
    if (tau == 0)
        return COIN_ESTEP;
    g->surely_rolls = !back && coin_priv_judge_step(g, tau, rate);
    const int rolls = g->surely_rolls || back ? 1 : shorten(g, tau, rate);
    coin_priv_spend_time(g);
    if (last && rolls > 0)
        g->rem.sum = 0;
    else if ((g->rem.sum < 0) != back)
        g->roll_stride /= 2;
    return rolls < 0 && g->rem.sum > 0 ? coin_priv_begin_slip(g) : COIN_OK;
}
