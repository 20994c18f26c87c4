/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../step/extrapolation.h"

#include "control.h"
#include "hold.h"
#include "slide.h"

/* |rem| times the fastest rate below which a step with losses lands. */
#define LAST 1e-5

/* Nearer to flat than this a coin with losses ends as coin_settle() has it. */
#define END 1e-10

/* Where the slip's own slope is above this part of that of friction alone, the
 * slip begins at once: it takes some 1/EASY steps to grow. */
#define EASY (1.0 / 1024)

/* A step of a coin that rolls: the run after it.  added.t counts from 0. */
static double attempt(coin_priv_sliding *g, coin_priv_run *after, double tau)
{
    ++g->tries;
    *after = g->w.run;
    after->g.added.t = 0;
    if (!g->lossy)
        return coin_priv_extrapolate(after, tau) ? 0 : (double)INFINITY;
    coin_priv_trial trial;
    coin_priv_lossy_try(&trial, &g->w, tau);
    const double most = coin_priv_allowed(&g->w.run, g->tol, trial.adds.t);
    if (!(trial.error <= DBL_MAX &&
          coin_priv_sundman_accept(after, &trial.next, &trial.adds)))
        return (double)INFINITY;
    return trial.error / most;
}

static double left_of(const coin_priv_sliding *g, const coin_priv_run *r)
{
    const coin_priv_slip y = coin_priv_slip_of(r, 0, 0);
    return coin_priv_left(&g->table, &y, 0);
}

static double cone_left(coin_priv_sliding *g, double tau)
{
    coin_priv_run after;
    (void)attempt(g, &after, tau);
    return left_of(g, &after);
}

static void take(coin_priv_sliding *g, const coin_priv_run *after)
{
    const double t = after->g.added.t;
    g->w.run = *after;
    g->w.run.g.added.t = 0;
    coin_priv_add(&g->rem, -t);
}

/* The rest of the time in one short step, as coin_advance() ends. */
static int land(coin_priv_sliding *g, coin_priv_run *after)
{
    coin_priv_sum rem = g->rem;
    *after = g->w.run;
    if (after->steps > 0)
        coin_priv_read_lean(&after->g);
    const int done = coin_priv_land(after, &g->reach, &rem) == COIN_OK;
    after->g.added.t = g->rem.sum;
    return done;
}

/* Where the contact of a coin with losses has stopped near flat, or nearly so,
 * coin_settle() takes it to the table, or as far as it rises. */
static int32_t settle(coin_priv_sliding *g)
{
    const coin_priv_held_fall f = coin_priv_fall_of(&g->w.l, &g->w.run.g.y);
    double time = g->rem.sum, moved;
    if (f.v < 0) {
        const double rise = coin_priv_rise_time(&f, &g->w.l, &g->w.run.b);
        time = rise < time ? rise : time;
    }
    coin_priv_read_lean(&g->w.run.g);
    coin_state s = coin_priv_run_state(&g->w.run);
    const int32_t status =
        coin_settle(&s, &g->p, &g->losses, time, g->tol, &moved);
    coin_priv_slide_from(g, &s);
    g->w.run.steps = 1;
    coin_priv_add(&g->rem, -moved);
    if (status == COIN_OK && time == g->rem.sum)
        g->rem.sum = 0;
    return status;
}

static int settles(const coin_priv_sliding *g)
{
    const double eps = coin_priv_stopped(g->tol);
    const coin_priv_variables *y = &g->w.run.g.y;
    return g->lossy &&
           (y->cth < END || coin_priv_held(&g->w.l, &g->w.run.b, y, eps));
}

/* The length of a step by its rules: of time, of rate, and of losses. */
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

/* Whether one short step takes the rest of the time. */
static int is_last(const coin_priv_sliding *g, double rate)
{
    const coin_priv_run *r = &g->w.run;
    const double rem = g->rem.sum;
    if (g->lossy)
        return fabs(rem) * rate <= LAST * r->g.y.cth;
    return coin_priv_left2(r, rem) <= g->reach.rk8 * g->reach.rk8;
}

/* The part of a step to *after up to which the coin is known to roll; below 0
 * if all but its end is. */
static double rolls(const coin_priv_sliding *g, const coin_priv_run *after,
                    double tau, double rate)
{
    const coin_priv_slip from = coin_priv_slip_of(&g->w.run, 0, 0);
    const coin_priv_slip to = coin_priv_slip_of(after, 0, 0);
    const coin_priv_look look = {
        &g->table, coin_priv_roll_slopes, &from, &to, tau, fabs(tau) * rate,
    };
    const double part = coin_priv_looked(&look);
    return part == 1 && coin_priv_left(&g->table, &to, 0) < 0 ? -1 : part;
}

/* A step as long as its error allows. */
static double step(coin_priv_sliding *g, coin_priv_run *after, double rate)
{
    const double bound =
        g->lossy ? coin_priv_lossy_bound(
                       &g->w, coin_priv_allowed(&g->w.run, g->tol, 0))
                 : (double)INFINITY;
    for (;;) {
        const double tau = next_tau(g, rate, bound), used = fabs(tau) * rate;
        const double error = attempt(g, after, tau);
        if (!g->lossy)
            return error == 0 ? tau : 0;
        const double next = used * coin_priv_change(error, 1);
        const int done = error <= 1;
        if (!done || next > g->roll_stride || used > 0.999 * g->roll_stride)
            g->roll_stride = next < COIN_PRIV_LONGEST_STRIDE
                                 ? next
                                 : COIN_PRIV_LONGEST_STRIDE;
        if (done)
            return tau;
        if (g->tries > COIN_PRIV_SLIDE_TRIES)
            return 0;
    }
}

/* Rolls to where the coin leaves the cone, within a step of tau. */
static int32_t leave(coin_priv_sliding *g, double left, double tau, double end)
{
    coin_priv_run after;
    const double place = coin_priv_place(g, cone_left, left, tau, end);
    if (place > 0) {
        (void)attempt(g, &after, place);
        take(g, &after);
    }
    return coin_priv_begin_slip(g);
}

int32_t coin_priv_roll_on(coin_priv_sliding *g)
{
    coin_priv_run after;
    const coin_priv_variables *y = &g->w.run.g.y;
    const double left = left_of(g, &g->w.run);
    if (left < 0)
        return coin_priv_begin_slip(g);
    g->gained = 0;
    if (y->cth < COIN_PRIV_FLAT)
        return coin_priv_lie(&g->w.run);
    if (settles(g))
        return settle(g);
    const double rate = g->lossy ? coin_priv_lossy_rate(&g->w)
                                 : 1 / coin_priv_sundman_tau(&g->w.run.b, y, 1);
    const int last = is_last(g, rate);
    double tau = 0;
    if (last && !g->lossy) {
        tau = coin_priv_tau_of(&g->w.run.b, y, g->rem.sum);
        if (!land(g, &after))
            return COIN_ESTEP;
    } else {
        tau = step(g, &after, rate);
        if (tau == 0)
            return COIN_ESTEP;
    }
    double part = rolls(g, &after, tau, rate);
    const int whole = part == 1;
    for (; part > 0 && part < 1; part = rolls(g, &after, tau, rate)) {
        tau *= part;
        (void)attempt(g, &after, tau);
    }
    if (part < 0)
        return leave(g, left, tau, left_of(g, &after));
    const double before = g->rem.sum;
    take(g, &after);
    if (last && whole)
        g->rem.sum = 0;
    else if ((g->rem.sum < 0) != (before < 0))
        g->roll_stride /= 2;
    return COIN_OK;
}

/* How a slip would begin here: its direction, its slope by tau, and what the
 * slopes of the coin then have over those of rolling. */
struct onset {
    coin_priv_direction n;
    double slope, friction;
    coin_priv_slip slides, rolls;
};

static struct onset onset_of(const coin_priv_sliding *g)
{
    struct onset o;
    const coin_priv_table *t = &g->table;
    const coin_priv_slip y = coin_priv_slip_of(&g->w.run, 0, 0);
    const coin_priv_push stick = coin_priv_static(t, &y);
    o.n = coin_priv_onset(t, &y, &stick);
    const coin_priv_push slide = coin_priv_kinetic(t, &y, o.n);
    coin_priv_slopes_under(&o.slides, t, &y, &slide);
    coin_priv_slopes_under(&o.rolls, t, &y, &stick);
    o.slope = o.slides.uX * o.n.X + o.slides.uh * o.n.h;
    o.friction = stick.N > 0 && slide.N > 0 ? t->mu_kinetic * slide.N : -1;
    return o;
}

/* Adds a part of what the slopes of o have over those of rolling. */
static void push(coin_priv_slip *y, const struct onset *o, double tau)
{
    y->wX += tau * (o->slides.wX - o->rolls.wX);
    y->wY += tau * (o->slides.wY - o->rolls.wY);
    y->wZ += tau * (o->slides.wZ - o->rolls.wZ);
}

/* The coin after a slip of so short a tau. */
static coin_priv_slip euler(const coin_priv_run *r, const struct onset *o,
                            double tau)
{
    coin_priv_slip y = coin_priv_slip_of(r, 0, 0);
    double *at = (double *)&y;
    const double *slope = (const double *)&o->slides;
    for (int i = 0; i < COIN_PRIV_SLIP_SIZE; ++i)
        at[i] += tau * slope[i];
    return y;
}

int32_t coin_priv_begin_slip(coin_priv_sliding *g)
{
    const double w0 = g->table.w0, seed = COIN_PRIV_SLIP_SEED * w0;
    const double r4 = sqrt(sqrt(g->tol)), wait = r4 * sqrt(r4) / w0;
    struct onset o = onset_of(g);
    coin_priv_slip y;
    if (o.friction < 0)
        return COIN_ELIFT;
    const double tau = coin_priv_lesser(wait, g->rem.sum) / g->w.run.g.y.cth;
    if (o.slope >= EASY * o.friction && o.slope * tau >= seed) {
        y = euler(&g->w.run, &o, seed / o.slope);
        y.t = coin_priv_lesser(y.t, g->rem.sum);
        g->gained = seed;
    } else {
        coin_priv_run after;
        const struct onset at = o;
        if (!(attempt(g, &after, tau) <= 1))
            return COIN_ESTEP;
        take(g, &after);
        if (g->rem.sum < 4 * DBL_EPSILON * wait)
            g->rem.sum = 0;
        if (left_of(g, &g->w.run) >= 0)
            return COIN_OK;
        o = onset_of(g);
        if (o.friction < 0)
            return COIN_ELIFT;
        const double slope = (at.slope > 0 ? at.slope : 0) + o.slope;
        g->gained += tau / 2 * (slope > 0 ? slope : 0);
        if (g->gained < seed)
            return COIN_OK;
        y = coin_priv_slip_of(&g->w.run, 0, 0);
        push(&y, &at, tau / 2);
        push(&y, &o, tau / 2);
    }
    y.uX = g->gained * o.n.X;
    y.uh = g->gained * o.n.h;
    g->slips = 1;
    g->slip_stride = coin_priv_first_stride(g->tol);
    return coin_priv_slip_take(g, &y);
}
