/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "control.h"
#include "dopri8.h"
#include "hold.h"
#include "slide.h"

/* The rate that measures a step is that of the motion, plus RELAX times three
 * more: those at which the direction of the slip settles, at which losses slow
 * the coin, and at which the slip velocity changes, relative to it.  The
 * longest step is then LONGEST_STRIDE/RELAX = 5 times what the direction needs
 * to settle; the method is stable up to 6.  At tol = 1e-4 half or twice RELAX
 * takes 17 % more steps (make tuning). */
#define RELAX 0.24

/* The largest relative error of the slip velocity, which friction follows.  It
 * limits steps at tol = 1e-3 and above.  At tol = 1e-2 the worst hundredth of
 * random slides err by 0.4 tol; with 0.1 by 1.4 tol, with 0.001 by 0.2 tol for
 * 9 % more steps. */
#define SLIP_ERROR 1e-2

/* A slip is taken as a straight line for at most STRAIGHT sqrt(tol) of the time
 * in which the motion changes, or in which the slip velocity changes by
 * sqrt(g a).  The error of the line is half the square of that part: tol/32.
 * For large tol the part is MOST_STRAIGHT.  At tol = 1e-2 the median error
 * without it is 20 times as large, for 9 % fewer steps; a tenth of it takes 8 %
 * more. */
#define STRAIGHT 0.25
#define MOST_STRAIGHT 0.003

/* A step tried fails where rates and slip exceed those at its start by this
 * factor. */
#define RUNAWAY 1e6

/* The most trials of a step that is cut to the end of the time. */
#define NEWTONS 4

/* A step tried. */
struct tried {
    coin_priv_slip to;
    double error; /* over what is allowed */
};

static double speed(const coin_priv_slip *y)
{
    return coin_priv_hypot(y->uX, y->uh);
}

/* The slope of the slip speed. */
static double growth(const coin_priv_slip *y, const coin_priv_slip *d)
{
    const double u = speed(y);
    return y->uX / u * d->uX + y->uh / u * d->uh;
}

/* The rate in tau at which losses slow the coin; 0 if they hold psi. */
static double loss_rate(const coin_priv_sliding *g, const coin_priv_slip *y)
{
    const coin_priv_losses *l = &g->contact.l;
    const double sth = y->sth, cth = y->cth;
    if (!g->lossy || g->contact.psi_held)
        return 0;
    const double roll = coin_priv_roll_speed(y->wY, y->wZ, sth, cth);
    const double arm = sth * sth / l->IX + cth * cth / l->K; /* K is I_Z */
    return coin_priv_grip(l, roll, cth) * arm + l->spin * cth / l->IX;
}

/* The rate in sigma of (87), without its last term. */
static double rate_of(const coin_priv_sliding *g, const coin_priv_slip *y)
{
    const coin_priv_contact *t = &g->contact;
    const double u = speed(y), scale = coin_priv_slip_scale(t, u);
    const double sth = y->sth;
    const coin_priv_direction n = {y->uX / u, y->uh / u};
    const double N = coin_priv_kinetic(t, y, n).N;
    const double lever = t->b.m / t->b.IX;
    const double across = n.h * n.h * (1 + t->b.m / t->b.IZ) +
                          n.X * n.X * (1 + lever) / (1 + lever * sth * sth);
    const double settle = t->mu_kinetic * N * across / (u + t->w0);
    return scale * coin_priv_slip_rate(g) +
           RELAX * (settle + scale * loss_rate(g, y)); /* (87) */
}

/* The step that covers COIN_PRIV_TURN_ROUND of the way to where the contact
 * turns round. */
static double bound_of(coin_priv_sliding *g, const coin_priv_slip *y,
                       const coin_priv_slip *d)
{
    if (!g->lossy || g->contact.psi_held)
        return (double)INFINITY;
    const double per_tau = y->cth / d->t; /* dtau = dt/cos(theta) */
    g->w.du = per_tau * (y->cth * d->wZ + y->sth * d->wY + d->cth * y->wZ +
                         d->sth * y->wY);
    return per_tau * coin_priv_turn_bound(&g->w, coin_priv_least_effect(g));
}

/* Whether a step to `end` is refused since it comes too near to where the
 * contact turns round. */
static int comes_too_near(const coin_priv_sliding *g, const coin_priv_slip *end)
{
    const double then =
        coin_priv_roll_speed(end->wY, end->wZ, end->sth, end->cth);
    return g->lossy && !g->contact.psi_held &&
           coin_priv_part_of_way(&g->w, then, end->t / g->w.run.g.y.cth,
                                 coin_priv_least_effect(g)) > COIN_PRIV_TURNED;
}

/* The step h, and its error. */
static struct tried attempt(coin_priv_sliding *g, double h)
{
    const double w0 = g->contact.w0;
    const coin_priv_slip from = coin_priv_slip_of(&g->w.run.g.y, g->uX, g->uh);
    struct tried r = {from, 0};
    const double *begin = (const double *)&from;
    const double *end = (const double *)&r.to;
    coin_priv_estimates e;
    const double rounding = 4 * DBL_EPSILON * (speed(&from) / w0);
    double by5 = 0, by3 = 0, slip5 = 0, slip3 = 0, moved = 1000 * rounding;
    g->contact.most = RUNAWAY * coin_priv_slip_size(&g->contact, &from);
    coin_priv_dopri8((double *)&r.to, (const double *)&g->slope,
                     coin_priv_trial_slopes, &g->contact, h, &e);
    ++g->tries;
    if (r.to.t != r.to.t) {
        r.error = r.to.t = (double)INFINITY;
        return r;
    }
    for (int i = 0; i < COIN_PRIV_DOPRI8_READ; ++i) {
        const int slip = i == 5 || i == 6;
        const double per = i < 3 || slip ? 1 / w0 : 1;
        const double off5 = e.by5[i] * per;
        const double off3 = e.by3[i] * per;
        moved += fabs(end[i] - begin[i]) * per;
        by5 += off5 * off5;
        by3 += off3 * off3;
        slip5 += slip ? off5 * off5 : 0;
        slip3 += slip ? off3 * off3 : 0;
    }
    const double rates = fabs(from.wX) + fabs(from.wY) + fabs(from.wZ);
    const double size = 1 + (rates + speed(&from)) / w0;
    const double most = coin_priv_allowed(&g->w.run, g->tol, r.to.t) + rounding;
    const double of_all =
        coin_priv_guarded_error(by5, by3, coin_priv_lesser(moved, size)) / most;
    const double of_slip =
        coin_priv_error_of(slip5, slip3) * w0 / (SLIP_ERROR * speed(&from));
    const int above = g->contact.psi_held | (r.to.cth > 0);
    const int finite = by5 + by3 <= DBL_MAX;
    const int good = above & finite & (r.to.t >= 0);
    r.error = good && !comes_too_near(g, &r.to)
                  ? coin_priv_larger(of_all, of_slip)
                  : (double)INFINITY;
    return r;
}

/* Three functions of the length h of a step.  Each is 0 at an event: the time
 * has passed, the coin lifts off, the coin lies flat. */
static double time_left_after(coin_priv_sliding *g, double h)
{
    return g->rem.sum - attempt(g, h).to.t;
}

static double clearance_after(coin_priv_sliding *g, double h)
{
    const struct tried r = attempt(g, h);
    return coin_priv_clearance(&g->contact, &r.to, 1);
}

static double cos_after(coin_priv_sliding *g, double h)
{
    return attempt(g, h).to.cth;
}

/* A step short enough for its error to be allowed.  A step of 0 has no error,
 * so that the loop ends. */
static struct tried step(coin_priv_sliding *g, double *h, double rate,
                         double bound)
{
    for (;;) {
        const double full = g->slip_stride / rate;
        *h = full < bound ? full : bound;
        const struct tried r = attempt(g, *h);
        const double used = *h * rate;
        const int done = r.error <= 1;
        g->slip_stride =
            coin_priv_next_stride(g->slip_stride, used, r.error, 1);
        if (done)
            return r;
    }
}

/* Whether the normal force is surely positive all along a step h of a slip no
 * faster than u.  `from` and `to` are the clearances at its ends.  Between them
 * it may dip by an eighth of its second derivative, which is taken to be at
 * most 2 moved^2.  Returns 0 also if the clearance changes much.  With 2 or 8
 * in the place of 4 more or fewer steps are tested, to the same results (make
 * tuning). */
static int is_pressed(const coin_priv_sliding *g, double from, double to,
                      double u, double h)
{
    const double moved =
        h * coin_priv_slip_scale(&g->contact, u) * coin_priv_slip_rate(g);
    return coin_priv_lesser(from, to) >
           4 * fabs(to - from) + 0.25 * moved * moved;
}

/* Moves *y along a straight line by h in sigma. */
static void move_straight(coin_priv_slip *y, const coin_priv_slip *d, double h)
{
    double *at = (double *)y;
    const double *by = (const double *)d;
    for (int i = 0; i < COIN_PRIV_SLIP_SIZE; ++i)
        at[i] += h * by[i];
}

/* The part of a step, from 0 to 1, at which the time t has passed.  The time is
 * taken as a cubic: 0 and t1 at the ends of the step, with the slopes d0 and
 * d1.  Its root is found by Newton's method. */
static double part_at(double t, double t1, double d0, double d1)
{
    const double bend = 3 * t1 - 2 * d0 - d1, twist = d0 + d1 - 2 * t1;
    double x = t / t1;
    for (int i = 0; i < 4; ++i)
        x += (t - x * (d0 + x * (bend + x * twist))) /
             (d0 + x * (2 * bend + 3 * x * twist));
    const int within = (x > 0) & (x < 1);
    return within ? x : t / t1;
}

/* Shortens a step to the end of the time: by a cubic, then by Newton's method,
 * whose last correction is a straight line if its error is small enough. */
static void end_in_time(coin_priv_sliding *g, struct tried *r, double *h,
                        double rate)
{
    const double rem = g->rem.sum, whole = *h, over = r->to.t - rem;
    coin_priv_slip to;
    coin_priv_slip_slopes((double *)&to, (const double *)&r->to, &g->contact);
    *h *= part_at(rem, r->to.t, whole * g->slope.t, whole * to.t);
    for (int i = 0; (i < NEWTONS) & (*h > 0) & (*h < whole); ++i) {
        *r = attempt(g, *h);
        coin_priv_slip_slopes((double *)&to, (const double *)&r->to,
                              &g->contact);
        const double off = (rem - r->to.t) / to.t, by = off * rate;
        if (by * by <= COIN_PRIV_LOCATED * g->tol) {
            move_straight(&r->to, &to, off);
            r->to.t = rem;
            return;
        }
        *h += off;
    }
    *h = coin_priv_locate(g, time_left_after, rem, whole, -over);
    *r = attempt(g, *h);
    r->to.t = rem;
}

/* Shortens a step to the end of the time, to where the normal force comes to 0,
 * or to flat, whichever it passes first.  Returns the status there. */
static int32_t cut(coin_priv_sliding *g, struct tried *r, double *h,
                   double rate)
{
    const coin_priv_slip from = coin_priv_slip_of(&g->w.run.g.y, g->uX, g->uh);
    int32_t status = COIN_OK;
    if (r->to.cth <= 0) {
        *h = coin_priv_locate(g, cos_after, from.cth, *h, r->to.cth);
        *r = attempt(g, *h);
        status = COIN_RESTS;
    }
    if (r->to.t > g->rem.sum) {
        end_in_time(g, r, h, rate);
        status = COIN_OK;
    }
    const double before = coin_priv_clearance(&g->contact, &from, 1);
    const double u = coin_priv_larger(speed(&from), speed(&r->to));
    if (is_pressed(g, before, coin_priv_clearance(&g->contact, &r->to, 1), u,
                   *h))
        return status;
    for (;;) {
        const coin_priv_tested_step tested = {
            &g->contact, coin_priv_slip_slopes, &from, &r->to, *h, *h * rate,
        };
        double part;
        const coin_priv_verdict is = coin_priv_test_cone(&tested, &part);
        if (is != COIN_PRIV_STAYS) {
            *h *= part;
            *r = attempt(g, *h);
            status = COIN_OK;
        }
        const double end = coin_priv_clearance(&g->contact, &r->to, 1);
        if (!(end > 0) && is != COIN_PRIV_UNCLEAR) {
            *h = coin_priv_locate(g, clearance_after, before, *h, end);
            *r = attempt(g, *h);
            return COIN_ELIFT;
        }
        if (is == COIN_PRIV_STAYS)
            return status;
    }
}

/* Moves *y along a straight line, by h in sigma or to the end of the time.
 * Returns 1 if it moved by h. */
static int go_straight(coin_priv_slip *y, const coin_priv_slip *d, double h,
                       double rem)
{
    const int fits = d->t * h <= rem;
    move_straight(y, d, fits ? h : rem / d->t);
    if (!fits)
        y->t = rem;
    return fits;
}

/* Ends a slip, or makes it at least ten times as fast, by one straight line,
 * where that is accurate enough.  This is where a slip ends: its velocity
 * becomes 0, and the next step finds out whether the coin rolls, or slips in
 * another direction because rolling needs too much friction.  A slip whose
 * direction turns, or whose contact is held, is not made faster.  It is ended
 * only if it is slower than COIN_PRIV_SLIP_LEAST, and if it gains less than
 * that sideways until it ends.  Returns 0 if there is no such line, or if the
 * coin may lift off on it: *to is then of no use, and *g as it was. */
static int end_or_grow(coin_priv_sliding *g, coin_priv_slip *to,
                       const coin_priv_slip *d)
{
    const double u = speed(to), grows = growth(to, d);
    const double part =
        coin_priv_lesser(STRAIGHT * sqrt(g->tol), MOST_STRAIGHT);
    const double w0 = g->contact.w0;
    const double scale = coin_priv_slip_scale(&g->contact, u);
    const double rate = scale * (coin_priv_slip_rate(g) + loss_rate(g, to));
    const double slows = fabs(grows) / w0;
    const double h = part / coin_priv_larger(rate, slows);
    const double sideways = to->uX / u * d->uh - to->uh / u * d->uX;
    const int turns = fabs(sideways) > part * fabs(grows);
    const double least = COIN_PRIV_SLIP_LEAST * w0;
    const int is_least = u < least;
    const int keeps = fabs(sideways) * u <= fabs(grows) * least;
    const int ends = grows < 0, stops = ends & is_least & keeps;
    const int bends = turns | g->contact.psi_held;
    if (bends && !stops)
        return 0;
    if (!(ends ? u < -grows * h : u < grows * h / 9))
        return 0;
    const int fits = go_straight(to, d, ends ? u / -grows : h, g->rem.sum);
    if (!(coin_priv_clearance(&g->contact, to, 1) > 0))
        return 0;
    if (fits && ends) {
        to->uX = to->uh = 0;
        g->slips = g->surely_rolls = g->contact.psi_held = 0;
    }
    return 1;
}

/* Whether losses keep d(psi)/dt = 0 of a coin that slips near flat.  Two
 * torques along e_Z would change it, and the losses have to exceed each of
 * them.  One is that of friction, about a F_X (I_X/I_Z) cos^2 theta by (81) and
 * (85), with F_X = mu_k M g.  The other is (73), of a coin that is free at its
 * contact: I_Z stands in the place of K. */
static int psi_is_held(const coin_priv_sliding *g, const coin_priv_slip *y)
{
    const coin_priv_losses *l = &g->contact.l;
    const coin_priv_variables *v = &g->w.run.g.y;
    const coin_priv_body *b = &g->contact.b;
    const double eps = coin_priv_stopped(g->tol);
    if (!g->lossy)
        return 0;
    const double by_friction = g->contact.mu_kinetic * b->Mga * (b->IX / b->IZ);
    const double hold = coin_priv_holding_torque(
        l, coin_priv_stopped_speed2(b, v, eps), v->cth);
    return by_friction * y->cth * y->cth <= hold &&
           coin_priv_is_held(l, b, v, eps);
}

int32_t coin_priv_slip_on(coin_priv_sliding *g)
{
    const coin_priv_slip y = coin_priv_slip_of(&g->w.run.g.y, g->uX, g->uh);
    const coin_priv_slip *const d = &g->slope;
    if (!g->contact.psi_held && y.cth < COIN_PRIV_FLAT)
        return coin_priv_lay_flat(&g->w.run);
    g->contact.psi_held = psi_is_held(g, &y);
    coin_priv_slip_slopes((double *)&g->slope, (const double *)&y, &g->contact);
    coin_priv_slip to = y;
    if (end_or_grow(g, &to, d))
        return coin_priv_slip_take(g, &to);
    const double rate =
        rate_of(g, &y) + RELAX * coin_priv_hypot(d->uX, d->uh) / speed(&y);
    double h;
    struct tried r = step(g, &h, rate, bound_of(g, &y, d));
    const int32_t status = cut(g, &r, &h, rate);
    if (status == COIN_RESTS)
        r.to.cth = 0;
    const int32_t taken = coin_priv_slip_take(g, &r.to);
    if (taken != COIN_OK)
        return taken;
    return status == COIN_RESTS ? coin_priv_lay_flat(&g->w.run) : status;
}
