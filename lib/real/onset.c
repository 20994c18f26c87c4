/* SPDX-License-Identifier: MIT */
/* The beginning of a slip. */
#include "../motion/pinned.h"

#include "control.h"
#include "slide.h"

/* A slip begins at once if its slope is at least QUICK times friction, and if
 * it gains COIN_PRIV_SLIP_SEED within the usual wait of coin_priv_begin_slip().
 * A slower slip would grow by many short steps.  It waits instead.  The error
 * of the wait is kept below tol and below LARGEST_TOL.
 *
 * Measured on 3900 random slides.  Any QUICK from 0.25 to 2 gives the same
 * number of steps.  0, no wait for speed, gives 2 to 7 % more.  Without
 * LARGEST_TOL the errors at tol = 1e-4 are a fifth larger, for 0.5 % fewer
 * steps. */
#define QUICK 0.5
#define LARGEST_TOL 5e-5

/* The usual wait is WAIT tol^(3/8) of the time in which the motion changes.
 * Half of it takes 0.5 % more steps, twice saves 0.2 % for errors that are a
 * tenth larger (make tuning). */
#define WAIT 2

/* How a slip would begin here: its direction, its slope, the friction, and the
 * slopes of the coin if it slips and if it rolls, in the units of contact.h. */
struct onset {
    coin_priv_direction n;
    double slope, friction;
    coin_priv_slip slides, rolls;
};

static struct onset onset_of(const coin_priv_sliding *g)
{
    struct onset o;
    const coin_priv_contact *t = &g->contact;
    const coin_priv_slip y = coin_priv_slip_of(&g->w.run.g.y, 0, 0);
    const coin_priv_push stick = coin_priv_static(t, &y);
    o.n = coin_priv_slip_direction(t, &y, &stick);
    const coin_priv_push slide = coin_priv_kinetic(t, &y, o.n);
    coin_priv_slopes_under(&o.slides, t, &y, &slide);
    coin_priv_slopes_under(&o.rolls, t, &y, &stick);
    o.slope = o.slides.uX * o.n.X + o.slides.uh * o.n.h;
    o.friction = t->mu_kinetic * slide.N;
    return o;
}

/* The coin a tau after *from, by the slopes of its slip. */
static coin_priv_slip after_slopes(const coin_priv_slip *from,
                                   const struct onset *o, double tau)
{
    coin_priv_slip y = *from;
    double *at = (double *)&y;
    const double *slope = (const double *)&o->slides;
    for (int i = 0; i < COIN_PRIV_SLIP_SIZE; ++i)
        at[i] += tau * slope[i];
    return y;
}

/* The coin as if it had slipped since an onset a tau ago.  The run has rolled
 * from there to here.  What friction would have changed on the way is added, by
 * the trapezoidal rule. */
static coin_priv_slip after(const coin_priv_sliding *g,
                            const struct onset *from, double tau)
{
    const struct onset to = onset_of(g);
    const double half = tau / 2;
    const double u =
        coin_priv_hypot(g->uX, g->uh) + half * (from->slope + to.slope);
    coin_priv_slip y = coin_priv_slip_of(&g->w.run.g.y, u * to.n.X, u * to.n.h);
    y.wX += half * (from->slides.wX - from->rolls.wX);
    y.wY += half * (from->slides.wY - from->rolls.wY);
    y.wZ += half * (from->slides.wZ - from->rolls.wZ);
    y.wX += half * (to.slides.wX - to.rolls.wX);
    y.wY += half * (to.slides.wY - to.rolls.wY);
    y.wZ += half * (to.slides.wZ - to.rolls.wZ);
    return y;
}

/* The normal force where the slip would begin, if the coin rolled for tau from
 * coin_priv_mark() on. */
static double roll_to_clearance(coin_priv_sliding *g, double tau)
{
    g->w.run.g = g->from;
    const struct onset from = onset_of(g);
    coin_priv_again(g, tau);
    const coin_priv_slip y = after(g, &from, tau);
    return coin_priv_clearance(&g->contact, &y, 1);
}

/* The slip begins at *y. */
static int32_t begin(coin_priv_sliding *g, const coin_priv_slip *y)
{
    g->slips = 1;
    g->slip_stride = coin_priv_first_stride(g->tol);
    return coin_priv_slip_take(g, y);
}

/* The coin where the slip that began at *start has the speed
 * COIN_PRIV_SLIP_SEED.  One step of the midpoint rule leads there.  Straight
 * slopes would not do: without friction the step may be long. */
static coin_priv_slip at_seed(const coin_priv_contact *t,
                              const coin_priv_slip *start, struct onset *o)
{
    const double tau = COIN_PRIV_SLIP_SEED * t->w0 / o->slope;
    const coin_priv_slip mid = after_slopes(start, o, tau / 2);
    const coin_priv_push friction = coin_priv_kinetic(t, &mid, o->n);
    coin_priv_slopes_under(&o->slides, t, &mid, &friction);
    return after_slopes(start, o, tau);
}

/* Rolls on for at most tau from an onset at *start, where friction changes the
 * slip too slowly to begin it at once. */
static int32_t wait_for_speed(coin_priv_sliding *g, const coin_priv_slip *start,
                              struct onset *from, double tau)
{
    coin_priv_mark(g);
    double by = coin_priv_roll_step(g, coin_priv_roll_rate(g), tau);
    if (by == 0)
        return COIN_ESTEP;
    const double over = g->w.run.g.added.t - g->rem.sum;
    if (over > 0) { /* the step passed the end of the time: a shorter one */
        by *= 1 - 2 * over / g->w.run.g.added.t;
        coin_priv_again(g, by);
    }
    const double seed = COIN_PRIV_SLIP_SEED * g->contact.w0;
    if (coin_priv_rolling_clearance(g) >= 0) {
        if (from->slope * by >= seed) { /* the slip begins before */
            g->w.run.g = g->from;
            g->w.run.steps = g->steps;
            const coin_priv_slip soon = at_seed(&g->contact, start, from);
            return begin(g, &soon);
        }
        coin_priv_spend_time(g);
        return COIN_OK;
    }
    coin_priv_slip y = after(g, from, by);
    const double end = coin_priv_clearance(&g->contact, &y, 1);
    if (end <= 0) {
        const double before = coin_priv_clearance(&g->contact, start, 1);
        by = coin_priv_locate(g, roll_to_clearance, before, by, end);
        coin_priv_again(g, by);
        y = after(g, from, by);
    }
    coin_priv_spend_time(g);
    g->uX = y.uX;
    g->uh = y.uh;
    if (end > 0 && coin_priv_hypot(y.uX, y.uh) < seed)
        return COIN_OK;
    const int32_t begun = begin(g, &y);
    return end > 0 ? begun : COIN_ELIFT;
}

/* A slip whose speed grows fast begins at once, with a speed of
 * COIN_PRIV_SLIP_SEED.  The number of steps in which it then grows is
 * proportional to friction over the slope of its speed.  So a slow one waits:
 * the coin rolls on for a time, and what friction would have changed meanwhile
 * is added as an impulse.  The error of the wait is proportional to slope times
 * the square of the time waited. */
int32_t coin_priv_begin_slip(coin_priv_sliding *g)
{
    const coin_priv_slip start = coin_priv_slip_of(&g->w.run.g.y, 0, 0);
    const double seed = COIN_PRIV_SLIP_SEED * g->contact.w0;
    const double r4 = sqrt(sqrt(g->tol));
    const double tol = coin_priv_lesser(g->tol, LARGEST_TOL);
    const double unit = coin_priv_lesser(1 / coin_priv_roll_rate(g),
                                         1 / coin_priv_slip_rate(g));
    double wait = unit * (WAIT * r4 * sqrt(r4));
    g->surely_rolls = 0;
    if (!coin_priv_can_slip(&g->contact, &start))
        return COIN_ELIFT;
    if (g->rem.sum <= DBL_EPSILON * wait * start.cth) {
        g->rem.sum = 0;
        return COIN_OK;
    }
    struct onset o = onset_of(g);
    const double tau = coin_priv_lesser(wait, g->rem.sum / start.cth);
    /* The error of a wait is proportional to slope/friction times the square of
     * the wait.  of_error is the wait whose error is tol.  It is shorter than
     * the usual wait if slope/friction is at least r4/WAIT^2. */
    if (o.slope > r4 / (WAIT * WAIT) * o.friction) {
        const double of_error = unit * sqrt(tol * (o.friction / o.slope));
        wait = o.slope * of_error >= seed ? of_error : wait;
    }
    if (!(o.slope >= QUICK * o.friction && o.slope * tau >= seed))
        return wait_for_speed(g, &start, &o, wait);
    const coin_priv_slip y = at_seed(&g->contact, &start, &o);
    return begin(g, &y);
}

/* A held coin slips where F/N exceeds mu_static.  It has to exceed mu_kinetic
 * by HELD_EXCESS as well, so that the slip accelerates.  With 0 a slip may
 * begin that rounding alone accelerates (test_slide_flat).  Half and twice pass
 * that test as well; 1e-7 and 1e-3 fail it. */
#define HELD_EXCESS 1e-5

double coin_priv_held_clearance(const coin_priv_sliding *g)
{
    coin_priv_contact contact = g->contact;
    const coin_priv_slip y = coin_priv_slip_of(&g->w.run.g.y, 0, 0);
    const double least = contact.mu_kinetic + HELD_EXCESS;
    contact.psi_held = 1;
    if (contact.mu_static < least)
        contact.mu_static = least;
    return coin_priv_clearance(&contact, &y, 0);
}

/* The slip begins at once, with a speed of COIN_PRIV_SLIP_SEED.  There is no
 * slip if it would not gain that speed while the coin keeps its lean.  If the
 * call ends before it would, g->uX and g->uh keep what it gains. */
int coin_priv_begin_held_slip(coin_priv_sliding *g)
{
    coin_priv_contact *const t = &g->contact;
    const coin_priv_slip start = coin_priv_slip_of(&g->w.run.g.y, 0, 0);
    const double unit = coin_priv_sundman_tau(&t->b, &g->w.run.g.y, 1);
    const double seed = COIN_PRIV_SLIP_SEED * t->w0;
    t->psi_held = 1;
    struct onset o = onset_of(g);
    const double gains = o.slope * unit * start.cth;
    const double gained = coin_priv_hypot(g->uX, g->uh) + o.slope * g->rem.sum;
    const int slips = (gains >= seed) & (gained >= seed);
    const coin_priv_slip y = slips ? at_seed(t, &start, &o) : start;
    t->psi_held = 0;
    if (slips)
        return begin(g, &y) == COIN_OK;
    const double kept = gains >= seed ? gained : 0;
    g->uX = kept * o.n.X;
    g->uh = kept * o.n.h;
    return 0;
}
