/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "method.h"
#include "number.h"
#include "state.h"
#include "sundman.h"

#include <math.h>

/* The largest error of a step usually comes once in a period of theta.  So the
 * motion is followed through one period, first by coarse steps, which find its
 * length, its largest W and where that is.  Then the method itself runs with dt
 * beside dt/2; the difference of the states that they report estimates the
 * error of dt. */

/* The look ahead covers two turning points of theta and at least this many
 * natural units: where nutation and heading have nearly one period, the error
 * of the path grows as t^2 over many of them. */
#define LOOK_TIME_MIN 4.0

/* It ends after so many where turning points are late or missing. */
#define LOOK_TIME_MAX 20.0

/* The largest numbers of steps of a look ahead and of a trial, and of states
 * that a trial compares. */
#define LOOK_STEPS 400
#define TRIAL_STEPS 4096
#define COMPARED 128

/* The part of tol that a trial may use: errors grow from period to period, and
 * the error of the path grows as the square of time. */
#define MARGIN 0.125

/* The steps of a look ahead may miss the peak of W by 2 %. */
#define PEAK 0.97

/* Differences below this are rounding. */
#define ROUNDING 1e-14

struct outlook {
    coin_priv_carry from; /* where the trial begins */
    double span;          /* the time looked at from there */
    double worst2;        /* the largest W^2 in it; infinite if no step will do:
                             it ends flat, or W is beyond what a step takes */
};

static int seen_enough(int turns, double units)
{
    return units >= LOOK_TIME_MAX || (turns >= 2 && units >= LOOK_TIME_MIN);
}

/* Looks ahead from c; the trial begins where W^2 first reaches enough. */
static struct outlook look_ahead(coin_priv_carry c, const coin_priv_body *b,
                                 double enough)
{
    struct outlook o = {c, 0, coin_priv_rate2(b->g_a, &c.at.y)};
    int turns = 0, found = o.worst2 >= enough;
    double begin = 0, units = 0;
    for (int i = 0; i < LOOK_STEPS && !seen_enough(turns, units); ++i) {
        const double wX = c.at.y.wX;
        const double tau = coin_priv_sundman_tau(b, &c.at.y, 0.5);
        coin_priv_sundman_step(&c, b, tau); /* one that fails changes nothing */
        const double W2 = coin_priv_rate2(b->g_a, &c.at.y);
        if (!found) {
            const coin_priv_sc lean = {c.at.y.sth, c.at.y.cth};
            o.from = c;
            o.from.at.theta = coin_priv_angle(lean);
            o.from.at.p = c.at.y.wY * c.at.y.cth;
            begin = c.at.pose.t;
            found = W2 >= enough;
        }
        o.worst2 = W2 > o.worst2 ? W2 : o.worst2;
        turns += wX * c.at.y.wX < 0;
        units = c.at.pose.t * sqrt(b->g_a);
    }
    if (c.at.y.cth < COIN_PRIV_FLAT || o.worst2 > b->w2_max)
        o.worst2 = (double)INFINITY;
    coin_priv_settle(&o.from, &o.from.at);
    o.span = c.at.pose.t - begin;
    return o;
}

static double larger(double a, double b)
{
    return fabs(a) > b ? fabs(a) : b;
}

/* The distance of the poses that two runs from one start report, in radians
 * and radii. */
static double apart(const coin_priv_carry *c, const coin_priv_carry *d,
                    const coin_priv_body *b)
{
    static const coin_state origin = {0, 0, 0, 0, 0, 0, 0, 0};
    const coin_state s = coin_priv_state_of(c, b, &origin);
    const coin_state r = coin_priv_state_of(d, b, &origin);
    double e = larger(s.theta - r.theta, 0);
    e = larger(s.phi - r.phi, e);
    e = larger(s.psi - r.psi, e);
    e = larger((s.x - r.x) / b->a, e);
    return larger((s.z - r.z) / b->a, e);
}

/* The error per natural unit of time that steps of dt make over the span, or
 * infinity if they do not get through it.  A span below a natural unit counts
 * in full: the error goes on growing after it. */
static double trial(const struct outlook *o, const coin_priv_body *b,
                    int32_t method, double dt)
{
    coin_priv_stepper *const step = coin_priv_method_stepper(method);
    coin_priv_limits any = {(double)INFINITY, b->w2_max, COIN_OK};
    coin_priv_carry c = o->from, d = o->from;
    const double all = ceil(o->span / dt), rate = sqrt(b->g_a);
    const uint64_t n = all < TRIAL_STEPS ? (uint64_t)all : TRIAL_STEPS;
    const uint64_t block = n / COMPARED + 1;
    const double least = coin_priv_lesser((double)n * dt * rate, 1);
    double error = 0;
    for (uint64_t i = block; i < n + block; i += block) {
        step(&c, b, &any, dt, block);
        step(&d, b, &any, dt / 2, 2 * block);
        if (c.steps + d.steps < 2 * o->from.steps + 3 * i)
            return (double)INFINITY;
        const double t = (double)i * dt * rate;
        error = larger(apart(&c, &d, b) / (t > least ? t : least), error);
    }
    return error;
}

/* x^(1/order), order a power of two. */
static double root(double x, int32_t order)
{
    for (; order > 1; order /= 2)
        x = sqrt(x);
    return x;
}

double coin_max_dt(const coin_state *s, const coin_params *p, int32_t method,
                   double tol)
{
    coin_priv_body b;
    if (!coin_priv_method_known(method) || !(tol >= 1e-13 && tol <= 1e-2) ||
        coin_priv_check(s, p, &b) != COIN_OK)
        return NAN;
    /* From phi = psi = 0, so that the range of angles cannot end the trial. */
    const coin_state lean = {s->theta, 0, 0, 0, 0, s->wX, s->wY, s->wZ};
    coin_priv_carry start;
    coin_priv_carry_begin(&start, &lean);
    const double worst2 = look_ahead(start, &b, 0).worst2;
    const struct outlook o = look_ahead(start, &b, worst2 / 16);
    const double most = PEAK * coin_priv_method_coarse(method) / sqrt(worst2);
    const int32_t order = coin_method_order(method);
    double dt = most;
    /* Three trials, each where the last one points: far from the dt in question
     * the error is no power of it.  None is so short that it does not see the
     * span, or so fine that the error is lost in rounding. */
    for (int i = 0; i < 3; ++i) {
        const double seen = larger(o.span / TRIAL_STEPS, dt);
        const double tried = seen < most ? seen : most;
        const double error = trial(&o, &b, method, tried);
        const double wanted = tol * MARGIN / larger(error, ROUNDING);
        const double factor = root(wanted, order);
        dt = tried * (factor > 4 ? 4 : factor > 0 ? factor : 0.125);
    }
    return dt < most ? dt : most;
}
