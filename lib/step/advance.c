/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/rest.h"

#include "extrapolation.h"
#include "sundman.h"

/* Natural units of time beyond which a step would change nothing of t. */
#define TOO_LONG 1e15

/* The most steps of a call: 0.2 s. */
#define STEPS_MAX (UINT64_C(1) << 20)

/* |rem| W below which one step in t lands, in units of tol^(1/8) for RK8 and of
 * tol^(3/16) for RK4: measured so that its error stays below tol/10. */
#define LAST_RK8 1.6
#define LAST_RK4 0.6

/* A step is STRIDE tol^(1/14) over the rate, at most LONGEST: measured so that
 * its error stays below tol per natural unit of time (docs/accuracy.md). */
#define STRIDE 3.0
#define LONGEST 1.65

/* How far a call of coin_advance() may step. */
struct reach {
    double stride;   /* in tau, over the rate */
    double rk8, rk4; /* in t, times W */
};

/* The tau that the time rem takes from here: t = c0 tau + ... reversed to
 * third order, with the derivatives c1, c2 of cos theta by t.  (54) */
static double tau_of(const coin_priv_body *b, const coin_priv_variables *y,
                     double rem)
{
    const coin_priv_field f = coin_priv_field_of(b, 1);
    const double c = y->cth, r = rem / c;
    const double dwX = coin_priv_sundman_rates(&f, y).wX / c;
    const double c1 = -y->sth * y->wX * r; /* times r, r^2: without unit */
    const double c2 = (-c * y->wX * y->wX - y->sth * dwX) * r * r;
    return r * (1 - c1 / 2 + (2 * c1 * c1 - c * c2) / 6);
}

/* The next step in tau: a full one, or what lands on rem if that is less.  The
 * series holds for a step or so; what it gives beyond is not trusted. */
static double next_tau(const coin_priv_body *b, const coin_priv_variables *y,
                       double stride, double rem)
{
    const double side = rem < 0 ? -1 : 1;
    const double full = coin_priv_sundman_tau(b, y, stride);
    if (!(fabs(rem) < 2 * full * y->cth))
        return side * full;
    const double tau = tau_of(b, y, rem);
    return fabs(tau) < full ? tau : side * full;
}

/* The square of what is to be compared with a reach in t. */
static double left2(const coin_priv_run *r, double rem)
{
    return rem * rem * coin_priv_rate2(r->b.g_a, &r->g.y);
}

/* Moves *r until *rem, the time still to go, is short, or the coin is flat, or
 * a step fails or is one too many.  Each time that a step goes too far the next
 * may go only half as far: however bad the series, that ends. */
static int32_t approach(coin_priv_run *r, const struct reach *reach,
                        coin_priv_sum *rem)
{
    double stride = reach->stride;
    while (!(left2(r, rem->sum) <= reach->rk8 * reach->rk8)) {
        const double before = rem->sum;
        const double tau = next_tau(&r->b, &r->g.y, stride, before);
        if (r->g.y.cth < COIN_PRIV_FLAT)
            return COIN_EFLAT;
        if (r->steps == STEPS_MAX)
            return COIN_ESTEP;
        r->g.added.t = 0;
        if (!coin_priv_extrapolate(r, tau))
            return COIN_ESTEP;
        coin_priv_add(rem, -r->g.added.t);
        if ((rem->sum < 0) != (before < 0))
            stride /= 2;
    }
    return COIN_OK;
}

/* The last bit of the way, in t. */
static int32_t land(coin_priv_run *r, const struct reach *reach,
                    coin_priv_sum *rem)
{
    if (rem->sum == 0)
        return COIN_OK;
    const uint64_t before = r->steps;
    r->dt = rem->sum;
    if (left2(r, rem->sum) <= reach->rk4 * reach->rk4)
        coin_priv_rk4(r, 1);
    else
        coin_priv_rk8(r, 1);
    if (r->steps == before)
        return COIN_ESTEP;
    rem->sum = 0;
    return COIN_OK;
}

/* tol^(1/14) of x = tol^(1/16): x^(8/7) within 0.6 % from tol = 1e-14 up. */
static double root14(double x)
{
    return (0.2127 * x + 0.8261) * x - 0.014;
}

static struct reach reach_of(double tol)
{
    const double r8 = sqrt(sqrt(sqrt(tol))), r16 = sqrt(r8);
    const double stride = STRIDE * root14(r16);
    const struct reach r = {
        stride < LONGEST ? stride : LONGEST,
        LAST_RK8 * r8,
        LAST_RK4 * r8 * r16,
    };
    return r;
}

int32_t coin_advance(coin_state *s, const coin_params *p, double t, double tol,
                     double *reached)
{
    coin_priv_body b;
    int32_t status =
        tol >= 1e-13 && tol <= 1e-2 ? coin_priv_check(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    if (!(fabs(t) * sqrt(b.g_a) <= TOO_LONG))
        return COIN_ESTEP;
    if (t >= 0 && coin_priv_rests(s)) {
        if (reached)
            *reached = 0;
        return COIN_EFLAT;
    }
    coin_priv_run r;
    coin_priv_sum rem = {t, 0};
    const struct reach reach = reach_of(tol);
    r.b = b;
    coin_priv_run_from(&r, s, COIN_RK4, 0);
    r.limits.coarse2 = r.limits.most2 = (double)INFINITY;
    status = approach(&r, &reach, &rem);
    if (r.steps > 0)
        coin_priv_read_lean(&r.g);
    if (status == COIN_OK)
        status = land(&r, &reach, &rem);
    const coin_state end = coin_priv_run_state(&r);
    /* A path so long that x or z overflowed counts as none, as in a run. */
    const int lost = !coin_priv_pose_holds(&end);
    if (!lost)
        coin_priv_copy_state(s, &end);
    if (reached)
        *reached = lost ? 0 : t - rem.sum;
    return lost ? COIN_ESTEP : status;
}
