/* SPDX-License-Identifier: MIT */
/* The beginning and the end of a slip. */
#include "../motion/pinned.h"

#include "move.h"

/* A slip begins with one step of Heun's rule in which its direction is that of
 * an onset.  It is tol^(3/8) of the time in which the motion changes.  If the
 * slip accelerates, a step of that length errs more.  Then it is of_error: the
 * time in which the error is tol, plus LONGER of that in which the motion
 * changes, so that it is not 0 without friction.  It is at most STABLE over the
 * rate of the losses: up to 2 over it Heun's rule is stable.  It goes at most
 * STABLE of the way down to an event of cos theta, which is taken to lie PAST
 * tol lower, so that a step can pass it.  With twice STABLE, the 99th
 * percentile of the errors of slips near flat at 1e-4 is 14 tol instead of 0.5;
 * half of it, LONGER from 1e-11 to 1e-7 and PAST from 1e-4 to 1e-2 cost and err
 * the same (make tuning).
 *
 * The steps of a slip are as short as its speed is small, since its direction
 * is followed.  One that hardly accelerates would take many to grow.  It is
 * slow below SLOW tol^(3/4), while it grows by less than QUICK of the friction
 * and is within ALIGNED of the direction of an onset.  It goes on by such
 * steps, in which it has that direction.  Half of SLOW costs 3 % more.  With
 * twice SLOW, twice QUICK or ten times ALIGNED a launch errs by 2, 8 or 1.4 tol
 * instead of 0.4 (make tuning).
 *
 * A slip up to LEAST is none, and an acceleration up to LEAST counts as that:
 * far below COIN_PRIV_SLIP_LEAST.  From 1e-20 to 1e-11 no motion of make tuning
 * depends on it. */
#define LONGER 1e-9
#define STABLE 0.5
#define PAST 1e-3
#define SLOW 0.5
#define QUICK 0.5
#define ALIGNED 0.01
#define LEAST 1e-14

/* A slip is taken as a straight line for at most STRAIGHT sqrt(tol) of the time
 * in which the motion changes, or the slip velocity does by sqrt(g a).  One
 * below LEAST ends in any case: the direction of some never settles.  The error
 * of the line is half the square of that part: tol/32.  Half of it costs 1 %
 * more; with twice of it errors of light coins double (make tuning). */
#define STRAIGHT 0.25

/* How a slip begins: its direction, the slopes by t of the variables and of its
 * speed, the friction, and dt over the time of the mode. */
struct onset {
    coin_priv_direction n;
    double slopes[COIN_PRIV_WIDE], du, friction, dt;
};

static void onset_at(struct onset *o, const coin_priv_moving *g,
                     const double *y)
{
    const int mode = g->mode | COIN_PRIV_SLIPS;
    const coin_priv_direction no_friction = {0, 0};
    const coin_priv_push stick = coin_priv_slopes(
        0, y, &g->law, g->mode & ~COIN_PRIV_SLIPS, no_friction);
    o->n = coin_priv_onset(y, &g->law, g->mode, stick);
    const coin_priv_push slide =
        coin_priv_slopes(o->slopes, y, &g->law, mode, o->n);
    o->dt = o->slopes[COIN_PRIV_ADDS_T];
    for (int i = 0; i < COIN_PRIV_SIZE; ++i)
        o->slopes[i] /= o->dt;
    o->du = o->slopes[COIN_PRIV_UX] * o->n.X + o->slopes[COIN_PRIV_UH] * o->n.h;
    o->friction = g->law.mu_kinetic * slide.N / o->dt;
}

int coin_priv_slips_slowly(const coin_priv_moving *g)
{
    const double *y = g->step.y, *d = g->step.slope[0];
    const double uX = y[COIN_PRIV_UX], uh = y[COIN_PRIV_UH];
    const double r8 = sqrt(sqrt(sqrt(g->tol))), r38 = r8 * r8 * r8;
    const double slow = SLOW * r38 * r38, u2 = uX * uX + uh * uh;
    if (!(g->mode & COIN_PRIV_SLIPS && u2 < slow * slow))
        return 0;
    const double N = coin_priv_push_of(y, &g->law, g->mode).N;
    const double most = g->law.mu_kinetic * N * u2;
    const double grows = uX * d[COIN_PRIV_UX] + uh * d[COIN_PRIV_UH];
    const double aside = uX * d[COIN_PRIV_UH] - uh * d[COIN_PRIV_UX];
    return grows > 0 && grows < QUICK * most && fabs(aside) < ALIGNED * most;
}

int32_t coin_priv_begin_slip(coin_priv_moving *g, int *slips)
{
    struct onset a, b;
    double y[COIN_PRIV_WIDE];
    const double left = coin_priv_time_left(g), c = g->step.y[COIN_PRIV_C];
    const double uX = g->step.y[COIN_PRIV_UX], uh = g->step.y[COIN_PRIV_UH];
    const int slipping = g->mode | COIN_PRIV_SLIPS;
    const double r8 = sqrt(sqrt(sqrt(g->tol)));
    onset_at(&a, g, g->step.y);
    const double rate = coin_priv_rate(g->step.y, &g->law, slipping) / a.dt;
    const double loss =
        coin_priv_loss_rate(g->step.y, &g->law, slipping) / a.dt;
    const double du = coin_priv_larger(a.du, LEAST);
    /* The friction is below 0, by rounding, where the contact has no weight. */
    const double of_error =
        (sqrt(g->tol * fabs(a.friction) / du) + LONGER) / rate;
    double h = r8 * r8 * r8 / rate;
    /* A step of of_error must lead to a slip. */
    h = a.du * of_error > 10 * LEAST ? coin_priv_lesser(h, of_error) : h;
    h = h * loss > STABLE ? STABLE / loss : h;
    const double event =
        g->stop & COIN_NEARLY_FLAT ? COIN_PRIV_NEARLY : g->law.flat;
    const double low = coin_priv_larger(0, event - PAST * g->tol);
    const double fall = -a.slopes[COIN_PRIV_C] / (c - low);
    h = h * fall > STABLE ? STABLE / fall : h;
    const int ends = h >= left;
    h = ends ? left : h;
    for (int i = 0; i < COIN_PRIV_SIZE; ++i)
        y[i] = g->step.y[i] + h * a.slopes[i];
    y[COIN_PRIV_UX] = y[COIN_PRIV_UH] = 0;
    onset_at(&b, g, y);
    for (int i = 0; i < COIN_PRIV_SIZE; ++i)
        y[i] = g->step.y[i] + h / 2 * (a.slopes[i] + b.slopes[i]);
    const double u = sqrt(uX * uX + uh * uh) + h / 2 * (a.du + b.du);
    *slips = u > LEAST;
    /* On ice the slip keeps the direction that its acceleration gave it. */
    if (g->law.mu_kinetic > 0 || !*slips) {
        y[COIN_PRIV_UX] = *slips ? u * b.n.X : 0;
        y[COIN_PRIV_UH] = *slips ? u * b.n.h : 0;
    }
    return coin_priv_accept(g, y, ends);
}

int coin_priv_end_slip(coin_priv_moving *g)
{
    double to[COIN_PRIV_WIDE];
    if (!(g->mode & COIN_PRIV_SLIPS))
        return 0;
    const double *y = g->step.y, *d = g->step.slope[0];
    const double u = sqrt(y[COIN_PRIV_UX] * y[COIN_PRIV_UX] +
                          y[COIN_PRIV_UH] * y[COIN_PRIV_UH]);
    const double nX = y[COIN_PRIV_UX] / u, nh = y[COIN_PRIV_UH] / u;
    const double grows = nX * d[COIN_PRIV_UX] + nh * d[COIN_PRIV_UH];
    if (!(grows < 0))
        return 0;
    const double aside = fabs(nX * d[COIN_PRIV_UH] - nh * d[COIN_PRIV_UX]);
    const double part = STRAIGHT * sqrt(g->tol);
    const double h = u / -grows, scale = u / (u + 1);
    const double left = coin_priv_time_left(g);
    const double rate = coin_priv_rate(y, &g->law, g->mode) +
                        coin_priv_loss_rate(y, &g->law, g->mode);
    const int is_short = u < part && scale * rate * h < part;
    const int is_straight = aside <= part * -grows || u < LEAST;
    if (!(is_short && is_straight && h * d[COIN_PRIV_ADDS_T] <= left))
        return 0;
    for (int i = 0; i < COIN_PRIV_SIZE; ++i)
        to[i] = y[i] + h * d[i];
    to[COIN_PRIV_UX] = to[COIN_PRIV_UH] = 0;
    return coin_priv_accept(g, to, 0) == COIN_OK;
}
