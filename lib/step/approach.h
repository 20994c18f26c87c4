/* SPDX-License-Identifier: MIT */
/* How far steps in tau go, and how the last one lands on a time. */
#ifndef ROLLCOIN_APPROACH_H
#define ROLLCOIN_APPROACH_H

#include "sundman.h"

/* |rem| W below which one step in t lands, in units of tol^(1/8) for RK8 and of
 * tol^(3/16) for RK4: measured so that its error stays below tol/10. */
#define COIN_PRIV_LAST_RK8 1.6
#define COIN_PRIV_LAST_RK4 0.6

/* A step is STRIDE tol^(1/14) over the rate, at most LONGEST: measured so that
 * its error stays below tol per natural unit of time (docs/accuracy.md). */
#define COIN_PRIV_STRIDE 3.0
#define COIN_PRIV_LONGEST 1.65

/* How far a call of coin_advance() may step. */
typedef struct coin_priv_reach {
    double stride;   /* in tau, over the rate */
    double rk8, rk4; /* in t, times W */
} coin_priv_reach;

/* The tau that the time rem takes from here: t = c0 tau + ... reversed to
 * third order, with the derivatives c1, c2 of cos theta by t.  (54) */
COIN_PRIV_INLINE double coin_priv_tau_of(const coin_priv_body *b,
                                         const coin_priv_variables *y,
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
COIN_PRIV_INLINE double coin_priv_next_tau(const coin_priv_body *b,
                                           const coin_priv_variables *y,
                                           double stride, double rem)
{
    const double side = rem < 0 ? -1 : 1;
    const double full = coin_priv_sundman_tau(b, y, stride);
    if (!(fabs(rem) < 2 * full * y->cth))
        return side * full;
    const double tau = coin_priv_tau_of(b, y, rem);
    return fabs(tau) < full ? tau : side * full;
}

/* The square of what is to be compared with a reach in t. */
COIN_PRIV_INLINE double coin_priv_left2(const coin_priv_run *r, double rem)
{
    return rem * rem * coin_priv_rate2(r->b.g_a, &r->g.y);
}

/* The last bit of the way, in t. */
COIN_PRIV_INLINE int32_t coin_priv_land(coin_priv_run *r,
                                        const coin_priv_reach *reach,
                                        coin_priv_sum *rem)
{
    if (rem->sum == 0)
        return COIN_OK;
    const uint64_t before = r->steps;
    r->dt = rem->sum;
    if (coin_priv_left2(r, rem->sum) <= reach->rk4 * reach->rk4)
        coin_priv_rk4(r, 1);
    else
        coin_priv_rk8(r, 1);
    if (r->steps == before)
        return COIN_ESTEP;
    rem->sum = 0;
    return COIN_OK;
}

/* tol^(1/14) of x = tol^(1/16): x^(8/7) within 0.6 % from tol = 1e-14 up. */
COIN_PRIV_INLINE double coin_priv_root14(double x)
{
    return (0.2127 * x + 0.8261) * x - 0.014;
}

COIN_PRIV_INLINE coin_priv_reach coin_priv_reach_of(double tol)
{
    const double r8 = sqrt(sqrt(sqrt(tol))), r16 = sqrt(r8);
    const double stride = COIN_PRIV_STRIDE * coin_priv_root14(r16);
    const coin_priv_reach r = {
        stride < COIN_PRIV_LONGEST ? stride : COIN_PRIV_LONGEST,
        COIN_PRIV_LAST_RK8 * r8,
        COIN_PRIV_LAST_RK4 * r8 * r16,
    };
    return r;
}

#endif
