/* SPDX-License-Identifier: MIT */
#include "pinned.h"

/* gcc 12 tuned for newer processors spills vectors through integer registers,
 * a fifth of a step's time; tuned for this one it does not. */
#if defined(__AVX512F__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC target("tune=icelake-server")
#endif

#define FIELD coin_priv_sundman
#define DRIFT coin_priv_sundman_drift
#define EACH_POSE(F) F(phi) F(psi) F(x) F(z) F(t)
#include "dop8.h"
#include "march.h"
#include "state.h"
#include "sundman.h"

/* Natural units of time beyond which a step would change nothing of t. */
#define TOO_LONG 1e15

/* The most steps of a call: 0.2 s. */
#define STEPS_MAX (UINT64_C(1) << 20)

/* |rem| W below which one classical step in t lands: it errs by the fifth
 * power, far below rounding. */
#define LAST 2e-3

/* A step is STRIDE tol^(1/8) over the rate, at most LONGEST: measured so that
 * its error stays below tol per natural unit of time (docs/accuracy.md), and
 * that the least tol reaches what rounding leaves. */
#define STRIDE 3.2
#define LONGEST 1.2

/* The rate at which things change in tau.  The weights of wY and wZ follow
 * Eq. (44), the coin's own frequency, and make the error of a step of given
 * length most nearly the same for every motion. */
static double sundman_rate(const coin_priv_body *b, const coin_priv_stage *y)
{
    const double wX = y->wX, wY = y->wY, cwZ = y->cth * y->wZ;
    return sqrt(wX * wX + 1.5 * (wY * wY) + b->KJ * b->k1 * (cwZ * cwZ) +
                y->cth * b->g_a);
}

double coin_priv_sundman_tau(const coin_priv_body *b, const coin_priv_stage *y,
                             double stride)
{
    return stride / sundman_rate(b, y);
}

int coin_priv_sundman_step(coin_priv_carry *c, const coin_priv_body *b,
                           double tau)
{
    const coin_priv_field f = coin_priv_field_of(b, tau);
    coin_priv_moment next;
    coin_priv_copy(&next, &c->at, sizeof next);
    const double lowest = dop8_step(&next, &c->at, &f);
    if (!(lowest > 0 && next.y.cth > 0) ||
        !coin_priv_angles_hold(&next, c->psi.sum, 0))
        return 0;
    if (++c->steps % COIN_PRIV_SETTLE == 0)
        coin_priv_settle(c, &next);
    coin_priv_copy(&c->at, &next, sizeof next);
    return 1;
}

/* The tau that the time rem takes from here: t = c0 tau + ... reversed to
 * third order, with the derivatives c1, c2 of cos theta by t.  (54) */
static double tau_of(const coin_priv_body *b, const coin_priv_stage *y,
                     double rem)
{
    const coin_priv_field f = coin_priv_field_of(b, 1);
    const double c = y->cth, r = rem / c;
    const double dwX = coin_priv_sundman(&f, y).wX / c;
    const double c1 = -y->sth * y->wX * r; /* times r, r^2: without unit */
    const double c2 = (-c * y->wX * y->wX - y->sth * dwX) * r * r;
    return r * (1 - c1 / 2 + (2 * c1 * c1 - c * c2) / 6);
}

/* The next step in tau: a full one, or what lands on rem if that is less.  The
 * series holds for a step or so; what it gives beyond is not trusted. */
static double next_tau(const coin_priv_body *b, const coin_priv_stage *y,
                       double stride, double rem)
{
    const double side = rem < 0 ? -1 : 1;
    const double full = coin_priv_sundman_tau(b, y, stride);
    if (!(fabs(rem) < 2 * full * y->cth))
        return side * full;
    const double tau = tau_of(b, y, rem);
    return fabs(tau) < full ? tau : side * full;
}

/* Whether one classical step in t may land from here. */
static int near(const coin_priv_carry *c, const coin_priv_body *b, double rem)
{
    return rem * rem * coin_priv_rate2(b->g_a, &c->at.y) <= LAST * LAST;
}

/* Moves *c until *rem, the time still to go, is short, or the coin is flat, or
 * a step fails or is one too many.  Each time that a step goes too far the next
 * may go only half as far: however bad the series, that ends. */
static int32_t approach(coin_priv_carry *c, const coin_priv_body *b,
                        double stride, coin_priv_sum *rem)
{
    while (!near(c, b, rem->sum)) {
        const double before = rem->sum;
        const double tau = next_tau(b, &c->at.y, stride, before);
        if (c->at.y.cth < COIN_PRIV_FLAT)
            return COIN_EFLAT;
        if (c->steps == STEPS_MAX)
            return COIN_ESTEP;
        c->at.pose.t = 0;
        if (!coin_priv_sundman_step(c, b, tau))
            return COIN_ESTEP;
        coin_priv_add(rem, -c->at.pose.t);
        if ((rem->sum < 0) != (before < 0))
            stride /= 2;
    }
    return COIN_OK;
}

/* The last bit of the way, in t. */
static int32_t land(coin_priv_carry *c, const coin_priv_body *b,
                    coin_priv_sum *rem)
{
    coin_priv_limits any = {(double)INFINITY, (double)INFINITY, COIN_OK};
    const uint64_t steps = c->steps;
    if (rem->sum == 0)
        return COIN_OK;
    coin_priv_rk4(c, b, &any, rem->sum, 1);
    if (c->steps == steps)
        return COIN_ESTEP;
    rem->sum = 0;
    return COIN_OK;
}

static double stride_of(double tol)
{
    const double stride = STRIDE * sqrt(sqrt(sqrt(tol)));
    return stride < LONGEST ? stride : LONGEST;
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
    coin_priv_carry c;
    coin_priv_carry_begin(&c, s);
    coin_priv_sum rem = {t, 0};
    status = approach(&c, &b, stride_of(tol), &rem);
    if (status == COIN_OK)
        status = land(&c, &b, &rem);
    const coin_state end = coin_priv_state_of(&c, &b, s);
    /* A path so long that x or z overflowed counts as none, as in a run. */
    const int lost = coin_priv_check_members(&end) != COIN_OK;
    if (!lost)
        coin_priv_copy(s, &end, sizeof end);
    if (reached)
        *reached = lost ? 0 : t - rem.sum;
    return lost ? COIN_ESTEP : status;
}
