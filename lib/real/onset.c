/* SPDX-License-Identifier: MIT */
/* Slow slips, with which a slip begins and may end. */
#include "../motion/pinned.h"

#include "move.h"

#include <string.h>

/* Friction turns a slip of the speed u towards the direction of (84), which a
 * slip keeps.  That takes a time of the size of u, so that steps which follow
 * the turn are as short.  While a slip is slow, only its speed is integrated.
 * Its direction n is that of (84), turned by a small angle: it lags while the
 * direction of (84) changes.  Steps are then as long as those of the coin's own
 * motion.  The speed has a sign, and the slip ends where it passes 0.
 *
 * The angle is computed to first order in u.  A slip is slow while an estimate
 * of it is below SLOW tol^(5/16), and its own direction is so near to n that
 * the error of its velocity is ALIGNED tol.  Measured: SLOW in tables.md.
 *
 * A step is cut where a slow slip has become twice as fast as a slow slip may
 * be.  Its polynomial is wrong where a slip on ice turns round, and may give
 * any speed.  So the speed at the cut is limited to OVER times that of a slow
 * slip.
 *
 * A slip that grows or ends faster than by QUICK of the friction changes in few
 * steps that follow it, which cost less.  Measured: QUICK in tables.md.
 *
 * A slip up to LEAST is none: far below COIN_PRIV_SLIP_LEAST.  Measured: LEAST
 * in tables.md. */
#define SLOW 0.1
#define ALIGNED 0.05
#define OVER 10
#define QUICK 0.1
#define LEAST 1e-14

/* How slopes change is their difference for a turn of n by ANGLE, and for the
 * part AHEAD of the time in which the motion changes.  Measured: ANGLE, AHEAD
 * in tables.md. */
#define ANGLE 1e-6
#define AHEAD 1e-5

/* A slip is taken as a straight line for at most STRAIGHT sqrt(tol) of the time
 * in which the motion changes, or the slip velocity does by sqrt(g a).  One
 * below LEAST ends in any case: the direction of some never settles.  The error
 * of the line is half the square of that part: tol/32.  Measured: STRAIGHT in
 * tables.md. */
#define STRAIGHT 0.25

/* A slow slip.  Its slopes are by the time of the mode without a slip. */
struct slow_slip {
    coin_priv_direction from, n;  /* the direction of (84), and of the slip */
    double d[COIN_PRIV_WIDE], du; /* the slopes, and that of its speed */
    double turn;                  /* the slope of the direction of (84) */
    double off;                   /* the angle from a given direction to n */
    double most;                  /* about its speed where it lags by 1 */
};

static coin_priv_direction turned(coin_priv_direction n, double angle)
{
    const double X = n.X - angle * n.h, h = n.h + angle * n.X;
    const double size = sqrt(X * X + h * h);
    const coin_priv_direction to = {X / size, h / size};
    return to;
}

static void set_pair(double *y, double size, coin_priv_direction n)
{
    y[COIN_PRIV_UX] = size * n.X;
    y[COIN_PRIV_UH] = size * n.h;
}

static double speeding(const double *d, coin_priv_direction n)
{
    return n.X * d[COIN_PRIV_UX] + n.h * d[COIN_PRIV_UH];
}

/* Sets the slopes of a slip of the speed u along n.  Returns u times that of
 * its direction. */
static double along(double *d, const double *y, double u, coin_priv_direction n,
                    const coin_priv_law *l, int mode)
{
    double at[COIN_PRIV_READ];
    memcpy(at, y, sizeof at);
    set_pair(at, u, n);
    (void)coin_priv_slopes(d, at, l, mode, n);
    return n.X * d[COIN_PRIV_UH] - n.h * d[COIN_PRIV_UX];
}

/* 1/x, but 0 where |x| is far below `weak`. */
static double inverse_of(double x, double weak)
{
    return x / (x * x + weak * weak);
}

/* Sets *o to the slow slip of the speed u, to first order in u.  n: a direction
 * near that of the slip.  Let q be what along() returns.  The direction of (84)
 * is where q = 0, that of the slip where q = u d(n)/dt. */
static void find_slow(struct slow_slip *o, const double *y, double u,
                      coin_priv_direction n, const coin_priv_law *l, int mode)
{
    double other[COIN_PRIV_WIDE], ahead[COIN_PRIV_READ];
    double *const d = o->d;
    const double q = along(d, y, u, n, l, mode), du = speeding(d, n);
    const double rate =
        coin_priv_rate(y, l, mode) + coin_priv_loss_rate(y, l, mode);
    const double h = AHEAD / rate;
    for (int i = 0; i < COIN_PRIV_READ; ++i)
        ahead[i] = y[i] + h * d[i];
    const double by_angle =
        (along(other, y, u, turned(n, ANGLE), l, mode) - q) / ANGLE;
    const double by_time =
        (along(other, ahead, u + h * du, n, l, mode) - q) / h;
    const double size = fabs(by_angle), weak = LEAST * d[COIN_PRIV_ADDS_T];
    o->turn = -by_time * inverse_of(by_angle, weak);
    o->off = -q * inverse_of(by_angle, weak);
    o->from = turned(n, o->off);
    o->off -= u * o->turn * inverse_of(du - by_angle, weak);
    o->n = turned(n, o->off);
    o->most = (du - by_angle) * size / (rate * (size + weak) + fabs(by_time));
    (void)along(d, y, u, o->n, l, mode);
    o->du = speeding(d, o->n);
}

/* The speed of a slow slip in a step, and its direction. */
static double speed_of(coin_priv_direction *n, const double *y)
{
    const double uX = y[COIN_PRIV_UX], uh = y[COIN_PRIV_UH];
    const double size = sqrt(uX * uX + uh * uh);
    n->X = uX / size;
    n->h = uh / size;
    return size - 1;
}

int coin_priv_slow_rates(double *d, const double *y,
                         const coin_priv_problem *of)
{
    coin_priv_direction n;
    struct slow_slip o;
    const int sound = coin_priv_rates(0, y, of);
    if (!sound || !d)
        return sound;
    const double u = speed_of(&n, y);
    find_slow(&o, y, u, n, of->law, of->mode);
    memcpy(d, o.d, sizeof o.d);
    d[COIN_PRIV_UX] = o.du * n.X - (1 + u) * o.turn * n.h;
    d[COIN_PRIV_UH] = o.du * n.h + (1 + u) * o.turn * n.X;
    if (of->by_t)
        (void)coin_priv_by_t(d);
    return 1;
}

/* The angle by which a slow slip may lag. */
static double most_lag(const coin_priv_moving *g)
{
    const double r4 = sqrt(sqrt(g->tol));
    return SLOW * (r4 * sqrt(sqrt(r4)));
}

void coin_priv_begin_slip(coin_priv_moving *g)
{
    const coin_priv_direction no_friction = {0, 0};
    double *const y = g->step.y;
    struct slow_slip o;
    const coin_priv_push stick =
        coin_priv_slopes(0, y, &g->law, g->mode, no_friction);
    const coin_priv_direction n = coin_priv_onset(y, &g->law, g->mode, stick);
    g->mode |= COIN_PRIV_SLIPS;
    find_slow(&o, y, 0, n, &g->law, g->mode);
    g->slow = coin_priv_larger(most_lag(g) * o.most, COIN_PRIV_SLIP_LEAST);
    set_pair(y, 1, n);
    g->margin = coin_priv_contact_margin(y, &g->law, g->mode);
}

int coin_priv_slips_slowly(coin_priv_moving *g)
{
    double *const y = g->step.y;
    const double uX = y[COIN_PRIV_UX], uh = y[COIN_PRIV_UH];
    const double u = sqrt(uX * uX + uh * uh), lag = most_lag(g);
    struct slow_slip o;
    if (!(g->mode & COIN_PRIV_SLIPS && u > LEAST && u < lag))
        return 0;
    const coin_priv_direction n = {uX / u, uh / u};
    const double N = coin_priv_push_of(y, &g->law, g->mode).N;
    const double grows = fabs(speeding(g->step.slope[0], n)) * (1 + u);
    if (!(grows < QUICK * g->law.mu_kinetic * N * u))
        return 0;
    find_slow(&o, y, u, n, &g->law, g->mode);
    if (!(u < lag * o.most && (u + g->tol) * fabs(o.off) < ALIGNED * g->tol))
        return 0;
    g->slow = lag * o.most;
    set_pair(y, 1 + u, o.from);
    return 1;
}

void coin_priv_end_slow(const coin_priv_moving *g, double *y)
{
    coin_priv_direction n;
    struct slow_slip o;
    const double u = coin_priv_lesser(speed_of(&n, y), OVER * g->slow);
    const int slips = u > LEAST;
    if (slips)
        find_slow(&o, y, u, n, &g->law, g->mode);
    set_pair(y, slips ? u : 0, slips ? o.n : n);
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
    const double scale = u / (u + 1);
    const double rate = coin_priv_rate(y, &g->law, g->mode) +
                        coin_priv_loss_rate(y, &g->law, g->mode);
    const int is_short = u < part && scale * rate * u < part * -grows;
    const int is_straight = aside <= part * -grows || u < LEAST;
    if (!(is_short && is_straight))
        return 0;
    const double h = u / -grows;
    if (!(h * d[COIN_PRIV_ADDS_T] <= coin_priv_time_left(g)))
        return 0;
    for (int i = 0; i < COIN_PRIV_SIZE; ++i)
        to[i] = y[i] + h * d[i];
    to[COIN_PRIV_UX] = to[COIN_PRIV_UH] = 0;
    if (g->law.eta * to[COIN_PRIV_S] < -4 * DBL_EPSILON)
        return 0; /* beyond upright, where the other rim touches */
    return coin_priv_accept(g, to, 0) == COIN_OK;
}
