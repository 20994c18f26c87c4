/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "extrapolation.h"
#include "sundman.h"

/* As a rule the largest error of a step occurs once in a period of theta.  So
 * one period is examined, in two stages.  The look ahead takes coarse steps in
 * tau.  It finds the length of the period, its largest W and where that is.
 * The trial runs the method itself, with dt and with dt/2.  The difference of
 * their states estimates the error of dt. */

/* The look ahead covers two turning points of theta and at least this many
 * natural units: where nutation and heading have nearly one period, the error
 * of the path grows as t^2 over many of them. */
#define LOOK_TIME_MIN 4.0

/* The look ahead ends after this many natural units, even if there were fewer
 * than two turning points. */
#define LOOK_TIME_MAX 20.0

/* The steps of a look ahead, in strides of sundman.h.  Half of it doubles the
 * cost of the look ahead for the same dt within 8 %; twice halves it (make
 * tuning). */
#define LOOK_STRIDE 0.5

/* The largest numbers of steps of a look ahead and of a trial, and of states
 * that a trial compares.  They bound the cost of a call.  With half of
 * TRIAL_STEPS dt stays the same within 2 %.  With a quarter of COMPARED dt is
 * up to 17 % longer, and the largest error is 3 times as large (make tuning).
 */
#define LOOK_STEPS 400
#define TRIAL_STEPS 4096
#define COMPARED 128

/* The part of tol that a trial may use: errors grow from period to period, and
 * the error of the path grows as the square of time.  Twice of it lets twice
 * the errors pass, up to 3 tol per unit over 10 units of RK8 at tol = 1e-9, for
 * 13 % fewer steps of RK4 (make tuning). */
#define MARGIN 0.125

/* The trial begins where W^2 first reaches the part 1/PEAK_RISE of its largest
 * value, to see how the error grows towards the peak.  4 or 64 for 16 changes
 * dt by 4 % at most (make tuning). */
#define PEAK_RISE 16

/* The longest factor from the dt of a trial to the next, so that no dt is
 * extrapolated far.  From 2 to 16 it gives the same dt for random motions (make
 * tuning). */
#define LONGER 4

/* The steps of a look ahead may miss the peak of W by 2 %. */
#define PEAK 0.97

/* Differences below this are rounding. */
#define ROUNDING 1e-14

struct outlook {
    coin_priv_run from; /* where the trial begins */
    double span;        /* the time looked at from there */
    double worst2;      /* the largest W^2 in it; infinite if it ends flat */
};

static int seen_enough(int turns, double units)
{
    return units >= LOOK_TIME_MAX || (turns >= 2 && units >= LOOK_TIME_MIN);
}

/* W^2.  It is infinite if the coin is flat, or so near to it that W^2 could
 * overflow. */
static double rate2_of(const coin_priv_run *r)
{
    const coin_priv_variables *y = &r->g.y;
    const double w2 = y->wX * y->wX + y->wY * y->wY, cth = y->cth;
    const int flat =
        (cth < COIN_PRIV_FLAT) | (w2 > COIN_PRIV_MOST * (cth * cth));
    return flat ? (double)INFINITY : coin_priv_rate2(r->b.g_a, y);
}

/* Looks ahead from r; the trial begins where W^2 first reaches enough. */
static struct outlook look_ahead(coin_priv_run r, double enough)
{
    const double w0 = sqrt(r.b.g_a);
    struct outlook o = {r, 0, rate2_of(&r)};
    int turns = 0, found = o.worst2 >= enough;
    double begin = 0, units = 0;
    for (int i = 0; i < LOOK_STEPS && !seen_enough(turns, units); ++i) {
        const double wX = r.g.y.wX;
        if (r.g.y.cth < COIN_PRIV_FLAT)
            break;
        const double tau = coin_priv_sundman_tau(&r.b, &r.g.y, LOOK_STRIDE);
        coin_priv_extrapolate(&r, tau); /* one that fails changes nothing */
        const double W2 = rate2_of(&r);
        if (!found) {
            o.from = r;
            begin = r.g.added.t;
            found = W2 >= enough;
        }
        o.worst2 = W2 > o.worst2 ? W2 : o.worst2;
        turns += wX * r.g.y.wX < 0;
        units = r.g.added.t * w0;
    }
    coin_priv_read_lean(&o.from.g);
    o.span = r.g.added.t - begin;
    return o;
}

/* The distance of the poses that two runs from one start report, in radians
 * and radii. */
static double apart(const coin_priv_run *c, const coin_priv_run *d)
{
    const coin_priv_pose s = coin_priv_pose_of(&c->g, 1);
    const coin_priv_pose r = coin_priv_pose_of(&d->g, 1);
    double e = coin_priv_larger(fabs(s.theta - r.theta), 0);
    e = coin_priv_larger(fabs(s.phi - r.phi), e);
    e = coin_priv_larger(fabs(s.psi - r.psi), e);
    e = coin_priv_larger(fabs(s.x - r.x), e);
    return coin_priv_larger(fabs(s.z - r.z), e);
}

/* The error of steps of dt per natural unit of time; at least 1 if a step
 * fails.  The difference of the states is divided by the time since the start,
 * but by no less than one unit, or than the span where that is shorter: the
 * error goes on growing after the span. */
static double trial(const struct outlook *o, int32_t method, double dt)
{
    coin_priv_run c = o->from, d = o->from;
    const double all = o->span / dt, rate = sqrt(c.b.g_a);
    const double most = coin_priv_lesser(all, TRIAL_STEPS);
    const uint64_t down = (uint64_t)most, n = down + ((double)down < most);
    const uint64_t block = n / COMPARED + 1;
    const double least = coin_priv_lesser((double)n * dt * rate, 1);
    double error = 0;
    c.limits.coarse2 = d.limits.coarse2 = (double)INFINITY;
    c.limits.most2 = d.limits.most2 = c.b.w2_max;
    c.steps = d.steps = 0;
    c.dt = dt;
    d.dt = dt / 2;
    for (uint64_t i = block; i < n + block; i += block) {
        const uint64_t missing = 3 * block -
                                 coin_priv_run_by(&c, method, block) -
                                 coin_priv_run_by(&d, method, 2 * block);
        error += (double)missing; /* if a step fails */
        const double t = (double)i * dt * rate;
        error =
            coin_priv_larger(apart(&c, &d) / coin_priv_larger(t, least), error);
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
    if (!coin_priv_method_is_known(method) || !coin_priv_tol_is_valid(tol) ||
        coin_priv_check(s, p, &b) != COIN_OK)
        return NAN;
    /* The trial starts at phi = psi = 0, so that the range of these angles
     * cannot end it. */
    const coin_state lean = {s->theta, 0, 0, 0, 0, s->wX, s->wY, s->wZ};
    coin_priv_run start;
    start.b = b;
    coin_priv_run_unlimited(&start, &lean);
    const double worst2 = look_ahead(start, 0).worst2;
    if (worst2 > b.w2_max)
        return 0;
    const struct outlook o = look_ahead(start, worst2 / PEAK_RISE);
    const double most = PEAK * coin_priv_coarse_limit(method) / sqrt(worst2);
    const int32_t order = coin_method_order(method);
    double dt = most;
    /* Three trials, each with the dt that the last one estimates: only near the
     * dt wanted is the error a power of dt.  Two or four give the same dt
     * within 0.5 % (make tuning).  dt is not so short that a trial ends before
     * the span does, and an error below rounding counts as that. */
    for (int i = 0; i < 3; ++i) {
        const double seen = coin_priv_larger(o.span / TRIAL_STEPS, dt);
        const double tried = coin_priv_lesser(seen, most);
        const double error = trial(&o, method, tried);
        const double wanted = tol * MARGIN / coin_priv_larger(error, ROUNDING);
        const double factor = root(wanted, order);
        dt = tried * coin_priv_lesser(factor, LONGER);
    }
    return dt < most ? dt : most;
}
