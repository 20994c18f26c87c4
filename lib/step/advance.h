/* SPDX-License-Identifier: MIT */
/* A move by any time: steps in tau until the time left is short, then one step
 * in t. */
#ifndef ROLLCOIN_ADVANCE_H
#define ROLLCOIN_ADVANCE_H

#include "../motion/number.h"

#include "extrapolation.h"
#include "sundman.h"

/* The most steps of a call. */
#define COIN_PRIV_STEPS_MAX (UINT64_C(1) << 20)

/* A step in tau is made if its stride times E, the estimate of its error, is at
 * most ACCEPTED tol.  The error is below E stride^2/7, so that a step adds at
 * most 0.6 tol per stride.  In a stride a coin turns by about a radian or moves
 * by a radius.  So the sum is as the law of coin.h says.  The stride after it
 * is chosen for ACCEPTED/AIMED tol.  Both are without unit; measured: the rows
 * of their names in tests/studies/tables.md. */
#define COIN_PRIV_ACCEPTED 4.0
#define COIN_PRIV_AIMED 16.0

/* No stride is longer than START tol^(1/14), nor than LONGEST, beyond which the
 * estimate is none.  The first of a call is START tol^(1/14)/(1 + 3 u^2)^(1/2),
 * if lean and heading turn at u times the rate of sundman.h.  Measured:
 * COIN_PRIV_START in tables.md. */
#define COIN_PRIV_START 7.5
#define COIN_PRIV_LONGEST 2.4

/* One step of RK8 in t ends a call where rem^2 (W^2 + TURN_WEIGHT w^2) is at
 * most the square of LAST_RK8 tol^(1/8), and of LAST_MOST; w is the rate of
 * lean and heading, powers of which are in each derivative of high order.  It
 * is a step of RK4 where |rem| W is at most LAST_RK4 tol^(1/4).  Measured: the
 * rows of these names in tables.md. */
#define COIN_PRIV_LAST_RK8 5.5
#define COIN_PRIV_LAST_MOST 2.0
#define COIN_PRIV_TURN_WEIGHT 10.0
#define COIN_PRIV_LAST_RK4 2.0

/* How far a call may step. */
typedef struct coin_priv_lengths {
    double tol;
    double stride; /* the longest */
    double rk8_2;  /* the most rem^2 (W^2 + TURN_WEIGHT w^2) of RK8 */
    double rk4_2;  /* the most rem^2 W^2 of RK4 */
} coin_priv_lengths;

/* The steps in tau of a call.  A stride is a tau times the rate. */
typedef struct coin_priv_pace {
    double stride; /* of the next step; any at first */
    double tau;    /* of the step made last */
} coin_priv_pace;

/* x^(1/28), or up to 6 % more, for any x >= 0: the exponent of a double and its
 * mantissa together are nearly a logarithm. */
COIN_PRIV_INLINE double coin_priv_root28(double x)
{
    const int64_t one = coin_priv_bits(1);
    return coin_priv_of_bits((coin_priv_bits(x) - one) / 28 + one);
}

COIN_PRIV_INLINE coin_priv_lengths coin_priv_lengths_of(double tol)
{
    const double r2 = sqrt(tol), r28 = coin_priv_root28(tol);
    const double rk8 = COIN_PRIV_LAST_RK8, rk4 = COIN_PRIV_LAST_RK4;
    const coin_priv_lengths r = {
        tol,
        coin_priv_lesser(COIN_PRIV_START * (r28 * r28), COIN_PRIV_LONGEST),
        coin_priv_lesser(rk8 * rk8 * sqrt(r2),
                         COIN_PRIV_LAST_MOST * COIN_PRIV_LAST_MOST),
        rk4 * rk4 * r2,
    };
    return r;
}

/* The square of the rate of lean and heading by tau, on the average of the tau
 * 2 half. */
COIN_PRIV_INLINE double coin_priv_turn2(const coin_priv_run *r, double half)
{
    const coin_priv_variables *y = &r->g.y;
    const coin_priv_field f = coin_priv_field_of(&r->b, half);
    const double wX = fabs(y->wX) + fabs(coin_priv_sundman_slope(&f, y));
    return wX * wX + y->wY * y->wY;
}

/* The next step in tau: `full`, or a shorter one that ends at rem.  The series
 * of coin_priv_tau_of() is accurate for about one step, so that it is not used
 * if rem is longer than two. */
COIN_PRIV_INLINE double coin_priv_next_tau(const coin_priv_run *r, double full,
                                           double rem)
{
    const double side = rem < 0 ? -1 : 1;
    if (!(fabs(rem) < 2 * full * r->g.y.cth))
        return side * full;
    const double tau = coin_priv_tau_of(&r->b, &r->g.y, rem);
    return fabs(tau) < full ? tau : side * full;
}

/* (rem W)^2. */
COIN_PRIV_INLINE double coin_priv_left2(const coin_priv_run *r, double rem)
{
    return rem * rem * coin_priv_rate2(r->b.g_a, &r->g.y);
}

/* Whether one step in t is accurate enough for all the time left. */
COIN_PRIV_INLINE int coin_priv_one_step_suffices(
    const coin_priv_run *r, const coin_priv_lengths *lengths, double rem)
{
    const double left2 = coin_priv_left2(r, rem), most2 = lengths->rk8_2;
    if (!(left2 <= most2))
        return 0;
    if ((1 + COIN_PRIV_TURN_WEIGHT) * left2 <= most2)
        return 1; /* w is hardly ever above W */
    const double tau = rem * r->g.y.q;
    const double turn2 = tau * tau * coin_priv_turn2(r, tau / 2);
    return left2 + COIN_PRIV_TURN_WEIGHT * turn2 <= most2;
}

/* A step in tau, shorter and shorter until its error is accepted.  *r stays
 * where it is if the coin is flat, phi or psi would leave their range, or the
 * step is one too many. */
COIN_PRIV_INLINE int32_t coin_priv_advance_by(coin_priv_run *r,
                                              const coin_priv_lengths *lengths,
                                              uint64_t last,
                                              coin_priv_pace *pace,
                                              coin_priv_sum *rem)
{
    const double unit = coin_priv_sundman_tau(&r->b, &r->g.y, 1);
    const double before = rem->sum;
    double most, error;
    int made;
    if (r->g.y.cth < COIN_PRIV_FLAT)
        return COIN_EFLAT;
    if (r->steps == last)
        return COIN_MORE;
    if (r->steps == 0) {
        const double u2 = unit * unit * coin_priv_turn2(r, unit / 2);
        pace->stride = lengths->stride / sqrt(1 + 3 * u2);
    }
    r->g.added.t = 0;
    do {
        pace->tau = coin_priv_next_tau(r, pace->stride * unit, before);
        const double stride = fabs(pace->tau) / unit;
        error = most = COIN_PRIV_ACCEPTED * lengths->tol / stride;
        made = coin_priv_extrapolate(r, pace->tau, &error);
        /* With the 14th root of an accepted step's, more would be refused. */
        const double root = coin_priv_root28(most / (COIN_PRIV_AIMED * error));
        const double by = error > most ? root * root : root;
        pace->stride = coin_priv_lesser(by * stride, lengths->stride);
    } while (error > most);
    if (!made)
        return COIN_ERANGE;
    coin_priv_add(rem, -r->g.added.t);
    return COIN_OK;
}

#endif
