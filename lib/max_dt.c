/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "method.h"
#include "state.h"
#include "sundman.h"

#include <math.h>

/* What decides a step is the worst that the motion has ahead, and that comes
 * once a period of theta.  So the coin is sent ahead through one period, first
 * at a coarse stride to see how long that is, how fast it gets and where, then
 * with the method itself at dt beside dt/2, whose difference is dt's error. */

/* A period is two turning points; for motions that have none, or are slow to
 * reach them, so many natural units of time do. */
#define LONG_ENOUGH 20.0

/* Steps that a look ahead may take, and a trial. */
#define PATIENCE 400
#define TRIAL_STEPS 4096

/* What of tol the trial may use: later periods may be worse than the first,
 * and a path bends away from another as the square of time. */
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

/* Looks ahead from c; the trial begins where W^2 first reaches enough. */
static struct outlook look_ahead(coin_priv_carry c, const coin_priv_body *b,
                                 double enough)
{
    struct outlook o = {c, 0, coin_priv_rate2(b->g_a, &c.at.y)};
    int turns = 0, found = o.worst2 >= enough;
    double begin = 0;
    for (int i = 0; i < PATIENCE && turns < 2; ++i) {
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
        if (c.at.pose.t * sqrt(b->g_a) > LONG_ENOUGH)
            break;
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

/* The difference of two sums with their parts. */
static double between(coin_priv_sum a, double part_a, coin_priv_sum b,
                      double part_b)
{
    return (a.sum - b.sum) + (part_a - part_b);
}

/* How far apart two runs from one start are, in radians and radii. */
static double apart(const coin_priv_carry *c, const coin_priv_carry *d)
{
    double e = 0;
    e = larger(c->at.y.sth * d->at.y.cth - c->at.y.cth * d->at.y.sth, e);
    e = larger(c->at.pose.phi - d->at.pose.phi, e);
    e = larger(between(c->psi, c->at.pose.psi, d->psi, d->at.pose.psi), e);
    e = larger(between(c->x, c->at.pose.x, d->x, d->at.pose.x), e);
    return larger(between(c->z, c->at.pose.z, d->z, d->at.pose.z), e);
}

/* The error per natural unit of time that steps of dt make over the span, or
 * infinity if they do not get through it. */
static double trial(const coin_priv_carry *start, const coin_priv_body *b,
                    int32_t method, double dt, double span)
{
    coin_priv_stepper *const step = coin_priv_method_stepper(method);
    coin_priv_limits any = {(double)INFINITY, b->w2_max, COIN_OK};
    coin_priv_carry c = *start, d = *start;
    const double unit = 1 / sqrt(b->g_a);
    double error = 0;
    for (uint64_t i = 1; i <= TRIAL_STEPS && (double)(i - 1) * dt < span; ++i) {
        step(&c, b, &any, dt, 1);
        step(&d, b, &any, dt / 2, 2);
        if (c.steps + d.steps < 2 * start->steps + 3 * i)
            return (double)INFINITY;
        const double t = (double)i * dt / unit;
        error = larger(apart(&c, &d) / (t > 1 ? t : 1), error);
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
    /* From where the pose has room, whatever it is. */
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
        const double error = trial(&o.from, &b, method, tried, o.span);
        const double wanted = tol * MARGIN / larger(error, ROUNDING);
        const double factor = root(wanted, order);
        dt = tried * (factor > 4 ? 4 : factor > 0 ? factor : 0.125);
    }
    return dt < most ? dt : most;
}
