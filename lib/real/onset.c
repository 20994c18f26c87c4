/* SPDX-License-Identifier: MIT */
/* The beginning of a slip. */
#include "../motion/pinned.h"

#include "control.h"
#include "slide.h"

/* How a slip would begin here: its direction, its slope by tau, friction over M
 * a times cos theta, below 0 if the coin lifts instead, and the slopes of the
 * coin then and as it rolls. */
struct onset {
    coin_priv_direction n;
    double slope, friction;
    coin_priv_slip slides, rolls;
};

static struct onset onset_of(const coin_priv_sliding *g)
{
    struct onset o;
    const coin_priv_table *t = &g->table;
    const coin_priv_slip y = coin_priv_slip_of(&g->w.run.g.y, 0, 0);
    const coin_priv_push stick = coin_priv_static(t, &y);
    o.friction = -1;
    if (!(stick.N > 0))
        return o;
    o.n = coin_priv_onset(t, &y, &stick);
    const coin_priv_push slide = coin_priv_kinetic(t, &y, o.n);
    coin_priv_slopes_under(&o.slides, t, &y, &slide);
    coin_priv_slopes_under(&o.rolls, t, &y, &stick);
    o.slope = o.slides.uX * o.n.X + o.slides.uh * o.n.h;
    if (slide.N > 0)
        o.friction = t->mu_kinetic * slide.N;
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
    coin_priv_slip y = coin_priv_slip_of(&r->g.y, 0, 0);
    double *at = (double *)&y;
    const double *slope = (const double *)&o->slides;
    for (int i = 0; i < COIN_PRIV_SLIP_SIZE; ++i)
        at[i] += tau * slope[i];
    return y;
}

/* Friction a tau on. */
static double pressed(coin_priv_sliding *g, double tau)
{
    coin_priv_again(g, tau);
    return onset_of(g).friction;
}

/* The slip begins at *y, along n. */
static int32_t begin(coin_priv_sliding *g, coin_priv_slip *y,
                     coin_priv_direction n)
{
    y->uX = g->gained * n.X;
    y->uh = g->gained * n.h;
    g->slips = 1;
    g->slip_stride = coin_priv_first_stride(g->tol);
    return coin_priv_slip_take(g, y);
}

/* Rolls on for at most tau, from an onset. */
static int32_t roll_on(coin_priv_sliding *g, const struct onset *from,
                       double tau)
{
    coin_priv_mark(g);
    const double by = coin_priv_roll_step(g, coin_priv_roll_rate(g), tau);
    if (by == 0)
        return COIN_ESTEP;
    const struct onset to = onset_of(g);
    if (to.friction < 0)
        coin_priv_again(g, coin_priv_place(g, pressed, from->friction, by, -1));
    coin_priv_count(g);
    if (to.friction < 0)
        return COIN_ELIFT;
    if (coin_priv_cone_left(g) >= 0)
        return COIN_OK;
    g->gained += by / 2 * (from->slope + to.slope);
    if (g->gained < COIN_PRIV_SLIP_SEED * g->table.w0)
        return COIN_OK;
    coin_priv_slip y = coin_priv_slip_of(&g->w.run.g.y, 0, 0);
    push(&y, from, by / 2);
    push(&y, &to, by / 2);
    return begin(g, &y, to.n);
}

/* A slip with an acceleration begins at once, with a speed of
 * COIN_PRIV_SLIP_SEED: its steps to grow are as friction over the acceleration.
 * Where that is small, below tol^(1/4)/4, the coin rolls on for a time, and
 * friction's part in it is added as an impulse; the error is as the
 * acceleration times that time squared, and that is below tol. */
int32_t coin_priv_begin_slip(coin_priv_sliding *g)
{
    const coin_priv_variables *v = &g->w.run.g.y;
    const double seed = COIN_PRIV_SLIP_SEED * g->table.w0,
                 r4 = sqrt(sqrt(g->tol));
    const double wait =
        coin_priv_sundman_tau(&g->w.run.b, v, 2 * r4 * sqrt(r4));
    const struct onset o = onset_of(g);
    g->seen = 0;
    if (o.friction < 0)
        return COIN_ELIFT;
    if (g->rem.sum <= DBL_EPSILON * wait * v->cth) {
        g->rem.sum = 0;
        return COIN_OK;
    }
    const double tau = coin_priv_lesser(wait, g->rem.sum / v->cth);
    if (!(o.slope >= r4 / 4 * o.friction && o.slope * tau >= seed))
        return roll_on(g, &o, wait);
    coin_priv_slip y = euler(&g->w.run, &o, seed / o.slope);
    g->gained = seed;
    return begin(g, &y, o.n);
}
