/* SPDX-License-Identifier: MIT */
/* How long a step may be, by the estimate of its error. */
#ifndef ROLLCOIN_CONTROL_H
#define ROLLCOIN_CONTROL_H

#include "../step/run.h"

/* The first step of a call has a stride of FIRST_STRIDE tol^(1/8): most motions
 * admit it.  Half or twice that changes the number of steps by 0.3 % at most
 * (make tuning).
 *
 * No stride is longer than LONGEST_STRIDE.  Half of it takes up to 1.9 times as
 * many steps.  Twice is not stable: FRICTION of lossy.c would allow 8
 * relaxation times of friction, where the method is stable up to 6. */
#define COIN_PRIV_FIRST_STRIDE 4.0
#define COIN_PRIV_LONGEST_STRIDE 1.2

/* The estimate of a step's error may be ESTIMATE times tol times its time,
 * since the estimate is of order 8 and the error of order 9.  By this 995 of
 * 1000 launches err by less than tol per natural unit (test_settle).  Half or
 * twice halves or doubles the errors at small tol, for 3 % more or 2 % fewer
 * steps.  A step near flat takes hardly any time; the time of a step counts as
 * BRIEF natural units at least.  Half or twice that changes the steps by 2 %
 * and no error visibly (make tuning). */
#define COIN_PRIV_ESTIMATE 4.0
#define COIN_PRIV_BRIEF 0.03

/* Where |rem|/cos(theta) times the rate is at most this, one step with losses
 * ends the call.  Its tau is a series in rem: the first term left out is of
 * third order or higher, 1e-15 over that rate.  Ten times as much or a tenth
 * changes the number of steps by 0.04 % and no error (make tuning). */
#define COIN_PRIV_LAST_LOSSY 1e-5

/* The estimate of the error of a step of DOP853, which is proportional to h^8.
 * by5: the sum of the squares of its differences from a formula of order 5,
 * which are proportional to h^6.  by3: the same for order 3 and h^4.  The
 * factor 0.01 is that of DOP853 (Hairer, Norsett, Wanner). */
COIN_PRIV_INLINE double coin_priv_error_of(double by5, double by3)
{
    const double sum = by5 + 0.01 * by3;
    return sum > 0 ? by5 / sqrt(sum) : sum;
}

/* The same estimate, but no smaller than what a step with this by3 usually errs
 * by.  As h grows the estimate may pass through 0, which the error does not.
 * The error is proportional to h^9, and so is by3^(9/8).  size is the smaller
 * of two sizes: that of the variables, and that of their change in the step
 * plus 1000 times their rounding.  With a factor of 1 instead of 1000, fast
 * slips take many steps (test_slide_calls). */
COIN_PRIV_INLINE double coin_priv_guarded_error(double by5, double by3,
                                                double size)
{
    const double part = coin_priv_lesser(sqrt(by3) / size, 1);
    return coin_priv_larger(coin_priv_error_of(by5, by3),
                            size * (part * part * sqrt(sqrt(part))));
}

/* The largest estimate with which a step of so many natural units is accepted:
 * what tol allows, plus the estimate that rounding alone may cause.  That is 4
 * units of rounding of the rates and of an angle.  It matters only for tol near
 * 1e-13 and for fast coins. */
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
 * + 0.7 (most/error)^(1/8), which is 0.9 where the error is just allowed.  With
 * 0.1 + 0.8 the steps are the same within 0.5 %, with 0.2 + 0.6 up to 4 % more
 * for smaller errors (make tuning). */
COIN_PRIV_INLINE double coin_priv_stride_factor(double error, double most)
{
    const double least = 1e-9 * most; /* so that nothing divides by 0 */
    const double ratio = most / (error > least ? error : least);
    const double factor = 0.2 + 0.7 * sqrt(sqrt(sqrt(ratio)));
    return factor < 2 ? factor : 2;
}

/* A contact counts as stopped if it rolls at less than this part of the rates
 * of the fall.  Its roll is then left out, which would have turned the coin by
 * at most twice this part, in radians: by 4 tol.  A smaller part costs steps
 * while the roll decays: with half of it coin_settle() takes 16 % more at tol =
 * 1e-9.  `most` limits what is left out at tol above 5e-8.  A hundred times
 * that saves 2 % of the steps, a hundredth doubles them (make tuning). */
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
 * was `used`, and the largest error allowed.  An accepted step that was shorter
 * than `stride` for another reason does not lessen it.  0.999 tells such a step
 * from a full one, whose `used` is `stride` but for rounding. */
COIN_PRIV_INLINE double coin_priv_next_stride(double stride, double used,
                                              double error, double most)
{
    const double next = used * coin_priv_stride_factor(error, most);
    if (error <= most && !(next > stride) && !(used > 0.999 * stride))
        return stride;
    return next < COIN_PRIV_LONGEST_STRIDE ? next : COIN_PRIV_LONGEST_STRIDE;
}

#endif
