/* SPDX-License-Identifier: MIT */
/* How long a step may be, by the estimate of its error. */
#ifndef ROLLCOIN_CONTROL_H
#define ROLLCOIN_CONTROL_H

#include "../step/run.h"

/* The first step of a call has a stride of FIRST_STRIDE tol^(1/8): most motions
 * admit it.  No stride is longer than LONGEST_STRIDE: beyond that the estimate
 * of the error is poor. */
#define COIN_PRIV_FIRST_STRIDE 4.0
#define COIN_PRIV_LONGEST_STRIDE 1.2

/* The estimate of a step's error may be ESTIMATE times tol times its time,
 * since the estimate is of order 8 and the error of order 9.  Measured so that
 * the error stays below tol per natural unit of time (test_settle).  A step
 * near flat takes hardly any time; the time of a step counts as BRIEF natural
 * units at least. */
#define COIN_PRIV_ESTIMATE 4.0
#define COIN_PRIV_BRIEF 0.03

/* Where |rem| times the fastest rate is at most this, one step with losses ends
 * the call.  Its tau is a series in rem of second order. */
#define COIN_PRIV_LAST_LOSSY 1e-5

/* The estimate of the error of a step of DOP853, which is proportional to h^8.
 * by5: the sum of the squares of its differences from a formula of order 5,
 * which are proportional to h^6.  by3: the same for order 3 and h^4. */
COIN_PRIV_INLINE double coin_priv_error_of(double by5, double by3)
{
    const double sum = by5 + 0.01 * by3;
    return sum > 0 ? by5 / sqrt(sum) : sum;
}

/* The largest estimate with which a step of so many natural units is accepted:
 * what tol allows, plus the estimate that rounding alone may cause. */
COIN_PRIV_INLINE double coin_priv_allowed_in(const coin_priv_run *r, double tol,
                                             double units)
{
    const coin_priv_variables *y = &r->g.y;
    const double w0 = sqrt(r->b.g_a);
    const double rates = (fabs(y->wX) + fabs(y->wY) + fabs(y->wZ)) / w0;
    return COIN_PRIV_ESTIMATE * tol * units + 4 * DBL_EPSILON * (1 + rates);
}

/* The same of a step of the time t. */
COIN_PRIV_INLINE double coin_priv_allowed(const coin_priv_run *r, double tol,
                                          double t)
{
    const double units = fabs(t) * sqrt(r->b.g_a), brief = COIN_PRIV_BRIEF;
    return coin_priv_allowed_in(r, tol, units > brief ? units : brief);
}

/* The factor from the length of a step to that of the next, from 0.2 to 2: 0.2
 * + 0.7 (most/error)^(1/8), which is 0.9 where the error is just allowed. */
COIN_PRIV_INLINE double coin_priv_stride_factor(double error, double most)
{
    const double least = 1e-9 * most; /* so that nothing divides by 0 */
    const double ratio = most / (error > least ? error : least);
    const double factor = 0.2 + 0.7 * sqrt(sqrt(sqrt(ratio)));
    return factor < 2 ? factor : 2;
}

/* A contact counts as stopped if it rolls at less than this part of the rates
 * of the fall.  Its roll is then left out, which would have turned the coin by
 * at most twice this part, in radians. */
COIN_PRIV_INLINE double coin_priv_stopped(double tol)
{
    const double part = 2 * tol, most = 1e-7;
    return part < most ? part : most;
}

/* The first stride of a call. */
COIN_PRIV_INLINE double coin_priv_first_stride(double tol)
{
    const double first = COIN_PRIV_FIRST_STRIDE * sqrt(sqrt(sqrt(tol)));
    return first < COIN_PRIV_LONGEST_STRIDE ? first : COIN_PRIV_LONGEST_STRIDE;
}

/* The stride of the next step, from the error of the step tried, whose stride
 * was `used`.  An accepted step that was shorter than `stride` for another
 * reason does not lessen it. */
COIN_PRIV_INLINE double coin_priv_next_stride(double stride, double used,
                                              double error)
{
    const double next = used * coin_priv_stride_factor(error, 1);
    if (error <= 1 && !(next > stride) && !(used > 0.999 * stride))
        return stride;
    return next < COIN_PRIV_LONGEST_STRIDE ? next : COIN_PRIV_LONGEST_STRIDE;
}

#endif
