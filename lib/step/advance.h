/* SPDX-License-Identifier: MIT */
/* A move by any time: steps in tau until the time left is short, then one step
 * in t. */
#ifndef ROLLCOIN_ADVANCE_H
#define ROLLCOIN_ADVANCE_H

#include "extrapolation.h"
#include "sundman.h"

/* Natural units of time beyond which a step would change nothing of t. */
#define COIN_PRIV_TOO_LONG 1e15

/* The most steps of a call: 0.2 s. */
#define COIN_PRIV_STEPS_MAX (UINT64_C(1) << 20)

/* |rem| W below which one step in t arrives, in units of tol^(1/8) for RK8 and
 * of tol^(3/16) for RK4: measured so that its error stays below tol/10.  The
 * most for RK8 at any tol: from 0.9 on some would lead through the table. */
#define COIN_PRIV_LAST_RK8 1.6
#define COIN_PRIV_LAST_RK4 0.6
#define COIN_PRIV_LAST_MOST 0.5

/* A call that ends by its first step may step further if lean and heading turn
 * slowly.  RK8 may where they turn by less than SLOW_RK8 tol^(1/8).  Its error
 * is as rem (rem W)^8, so that W has a limit too, FASTEST in natural units:
 * measured so that the error stays below 0.6 tol per unit. */
#define COIN_PRIV_ONLY_RK8 4.7
#define COIN_PRIV_SLOW_RK8 0.5
#define COIN_PRIV_FASTEST 3.0

/* RK4 may be the only step of a call where W (rem W)^4 is at most ONLY_RK4 tol,
 * W in natural units: measured so that its error stays below 0.65 tol per
 * unit. */
#define COIN_PRIV_ONLY_RK4 16.0

/* A step is STRIDE tol^(1/14) over the rate, at most LONGEST: measured so that
 * its error stays below tol per natural unit of time (docs/accuracy.md). */
#define COIN_PRIV_STRIDE 3.0
#define COIN_PRIV_LONGEST 1.65

/* An only step may be so many strides long, but no longer than LONGEST, where
 * lean and heading turn by less than SLOW: measured as ONLY_RK8 was. */
#define COIN_PRIV_ONLY 1.75
#define COIN_PRIV_SLOW 0.1

/* How far a call may step. */
typedef struct coin_priv_reach {
    double stride;   /* in tau, over the rate */
    double rk8, rk4; /* in t, times W */
    double only_rk8; /* the same for an only step */
    double slow;     /* what lean and heading may turn by in that */
    double only_rk4; /* W (t W)^4 of an only step */
} coin_priv_reach;

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
        coin_priv_lesser(COIN_PRIV_LAST_RK8 * r8, COIN_PRIV_LAST_MOST),
        COIN_PRIV_LAST_RK4 * r8 * r16,
        coin_priv_lesser(COIN_PRIV_ONLY_RK8 * r8, 1),
        COIN_PRIV_SLOW_RK8 * r8,
        COIN_PRIV_ONLY_RK4 * tol,
    };
    return r;
}

/* The tau that the time rem takes from here: t = c0 tau + ... reversed to
 * third order, with the derivatives c1, c2 of cos theta by t.  (54) */
COIN_PRIV_INLINE double coin_priv_tau_of(const coin_priv_body *b,
                                         const coin_priv_variables *y,
                                         double rem)
{
    const coin_priv_field f = coin_priv_field_of(b, 1);
    const double c = y->cth, r = rem / c;
    const double dwX = coin_priv_sundman_slopes(&f, y).wX / c;
    const double c1 = -y->sth * y->wX * r; /* times r, r^2: without unit */
    const double c2 = (-c * y->wX * y->wX - y->sth * dwX) * r * r;
    return r * (1 - c1 / 2 + (2 * c1 * c1 - c * c2) / 6);
}

/* Whether lean and heading turn by less than an angle in the time rem; near the
 * table only by so much less as cos theta is.  0 after the first step. */
COIN_PRIV_INLINE int coin_priv_is_slow(const coin_priv_run *r, double rem,
                                       double angle)
{
    if (r->steps > 0)
        return 0;
    const coin_priv_variables *y = &r->g.y;
    const coin_priv_field f = coin_priv_field_of(&r->b, rem);
    const double wX = fabs(y->wX) + fabs(coin_priv_slopes_at(&f, y).wX) / 2;
    const double turn2 = (wX * wX + y->wY * y->wY) * (rem * rem);
    return turn2 <= (angle * angle) * (y->cth * y->cth);
}

/* The next step in tau: a full one, or what arrives at rem if that is less. The
 * series holds for a step or so; what it gives beyond is not trusted. */
COIN_PRIV_INLINE double coin_priv_next_tau(const coin_priv_run *r,
                                           double stride, double rem)
{
    const double side = rem < 0 ? -1 : 1;
    const double full = coin_priv_sundman_tau(&r->b, &r->g.y, stride);
    if (!(fabs(rem) < 2 * full * r->g.y.cth))
        return side * full;
    const double tau = coin_priv_tau_of(&r->b, &r->g.y, rem);
    if (fabs(tau) < full)
        return tau;
    const double only =
        coin_priv_lesser(COIN_PRIV_ONLY, COIN_PRIV_LONGEST / stride) * full;
    const int arrives =
        fabs(tau) < only && coin_priv_is_slow(r, rem, COIN_PRIV_SLOW);
    return arrives ? tau : side * full;
}

/* The square of what is to be compared with a reach in t. */
COIN_PRIV_INLINE double coin_priv_left2(const coin_priv_run *r, double rem)
{
    return rem * rem * coin_priv_rate2(r->b.g_a, &r->g.y);
}

/* Whether one step in t arrives. */
COIN_PRIV_INLINE int coin_priv_arrives(const coin_priv_run *r,
                                       const coin_priv_reach *reach, double rem)
{
    const double left2 = coin_priv_left2(r, rem);
    const double most2 = COIN_PRIV_FASTEST * COIN_PRIV_FASTEST * r->b.g_a;
    return left2 <= reach->rk8 * reach->rk8 ||
           (left2 <= reach->only_rk8 * reach->only_rk8 &&
            left2 <= rem * rem * most2 &&
            coin_priv_is_slow(r, rem, reach->slow));
}

/* A step of tau; each time that one goes too far the next may go only half as
 * far: however bad the series, that ends.  *r is untouched if the coin is flat,
 * or the step fails or is one too many. */
COIN_PRIV_INLINE int32_t coin_priv_advance_by(coin_priv_run *r, double tau,
                                              double *stride,
                                              coin_priv_sum *rem)
{
    const double before = rem->sum;
    if (r->g.y.cth < COIN_PRIV_FLAT)
        return COIN_EFLAT;
    if (r->steps == COIN_PRIV_STEPS_MAX)
        return COIN_ESTEP;
    r->g.added.t = 0;
    if (!coin_priv_extrapolate(r, tau))
        return COIN_ESTEP;
    coin_priv_add(rem, -r->g.added.t);
    if ((rem->sum < 0) != (before < 0))
        *stride /= 2;
    return COIN_OK;
}

/* Whether RK4 is enough for the last step. */
COIN_PRIV_INLINE int coin_priv_rk4_lands(const coin_priv_run *r,
                                         const coin_priv_reach *reach,
                                         double rem)
{
    const double left2 = coin_priv_left2(r, rem);
    if (r->steps != 0)
        return left2 <= reach->rk4 * reach->rk4;
    const double error = reach->only_rk4 * rem;
    return left2 * left2 * left2 * left2 * left2 <= error * error * r->b.g_a;
}

/* The last bit of the way, in t; not 0. */
COIN_PRIV_INLINE int32_t coin_priv_last_step(coin_priv_run *r,
                                             const coin_priv_reach *reach,
                                             coin_priv_sum *rem)
{
    const uint64_t before = r->steps;
    r->dt = rem->sum;
    if (coin_priv_rk4_lands(r, reach, rem->sum))
        coin_priv_rk4(r, 1);
    else
        coin_priv_rk8(r, 1);
    if (r->steps == before)
        return COIN_ESTEP;
    rem->sum = 0;
    return COIN_OK;
}

/* That, if anything is left. */
COIN_PRIV_INLINE int32_t coin_priv_land(coin_priv_run *r,
                                        const coin_priv_reach *reach,
                                        coin_priv_sum *rem)
{
    return rem->sum == 0 ? COIN_OK : coin_priv_last_step(r, reach, rem);
}

/* Ends a call that was to move *s by t, of which rem is left.  A path so long
 * that x or z overflowed counts as none, as in a run. */
COIN_PRIV_INLINE int32_t coin_priv_arrive(coin_state *s, const coin_priv_run *r,
                                          int32_t status, double t, double rem,
                                          double *reached)
{
    const coin_state end = coin_priv_run_state(r);
    const int lost = !coin_priv_pose_holds(&end);
    if (!lost)
        coin_priv_copy_state(s, &end);
    if (reached)
        *reached = lost ? 0 : t - rem;
    return lost ? COIN_ESTEP : status;
}

#endif
