/* SPDX-License-Identifier: MIT */
/* A move by any time: steps in tau until the time left is short, then one step
 * in t. */
#ifndef ROLLCOIN_ADVANCE_H
#define ROLLCOIN_ADVANCE_H

#include "extrapolation.h"
#include "sundman.h"

/* The most steps of a call.  They take 0.2 s. */
#define COIN_PRIV_STEPS_MAX (UINT64_C(1) << 20)

/* One step in t ends the call where |rem| W is at most LAST_RK8 tol^(1/8), and
 * at most LAST_MOST.  It is a step of RK4 where |rem| W is at most LAST_RK4
 * tol^(3/16).  Both factors are measured: the error of the step stays below
 * tol/10.  LAST_MOST leaves room to 0.9, from where on some steps would lead
 * through the table. */
#define COIN_PRIV_LAST_RK8 1.6
#define COIN_PRIV_LAST_RK4 0.6
#define COIN_PRIV_LAST_MOST 0.5

/* Where the first step of a call is its last, a step of RK8 may be longer if
 * lean and heading turn by less than ONLY_TURN_RK8 tol^(1/8) in it: |rem| W may
 * be ONLY_RK8 tol^(1/8), but at most 1.  The error of that step is proportional
 * to rem (rem W)^8, so that W has a limit too, FASTEST in natural units.  The
 * numbers are measured: the error stays below 0.6 tol per unit. */
#define COIN_PRIV_ONLY_RK8 4.7
#define COIN_PRIV_ONLY_TURN_RK8 0.5
#define COIN_PRIV_FASTEST 3.0

/* RK4 may be the only step of a call where W (rem W)^4 is at most ONLY_RK4 tol,
 * W in natural units: measured so that its error stays below 0.65 tol per
 * unit. */
#define COIN_PRIV_ONLY_RK4 16.0

/* The tau of a step is STRIDE tol^(1/14), but at most LONGEST, divided by the
 * rate of sundman.h.  Both are measured: the error of the step stays below tol
 * per natural unit of time (docs/accuracy.md). */
#define COIN_PRIV_STRIDE 3.0
#define COIN_PRIV_LONGEST 1.65

/* Where the first step in tau would be the last of a call, it may be ONLY
 * strides long if lean and heading turn by less than ONLY_TURN in it.  LONGEST
 * remains the limit.  Both are measured as ONLY_RK8 is. */
#define COIN_PRIV_ONLY 1.75
#define COIN_PRIV_ONLY_TURN 0.1

/* How far a call may step. */
typedef struct coin_priv_lengths {
    double stride;    /* of a step in tau: tau times the rate */
    double rk8, rk4;  /* the most |rem| W of a last step */
    double only_rk8;  /* the same if the first step of a call is its last */
    double only_turn; /* by how much lean and heading may turn in that step */
    double only_rk4;  /* the most W (rem W)^4 if the first step is the last */
} coin_priv_lengths;

/* tol^(1/14) from x = tol^(1/16): a parabola in place of x^(8/7), which errs by
 * less than 0.6 % for tol >= 1e-14. */
COIN_PRIV_INLINE double coin_priv_root14(double x)
{
    return (0.2127 * x + 0.8261) * x - 0.014;
}

COIN_PRIV_INLINE coin_priv_lengths coin_priv_lengths_of(double tol)
{
    const double r8 = sqrt(sqrt(sqrt(tol))), r16 = sqrt(r8);
    const double stride = COIN_PRIV_STRIDE * coin_priv_root14(r16);
    const coin_priv_lengths r = {
        stride < COIN_PRIV_LONGEST ? stride : COIN_PRIV_LONGEST,
        coin_priv_lesser(COIN_PRIV_LAST_RK8 * r8, COIN_PRIV_LAST_MOST),
        COIN_PRIV_LAST_RK4 * r8 * r16,
        coin_priv_lesser(COIN_PRIV_ONLY_RK8 * r8, 1),
        COIN_PRIV_ONLY_TURN_RK8 * r8,
        COIN_PRIV_ONLY_RK4 * tol,
    };
    return r;
}

/* Whether in the time rem the heading turns by less than `angle`, and the lean
 * by less than that times cos theta.  Always 0 after the first step of a call.
 */
COIN_PRIV_INLINE int coin_priv_turns_little(const coin_priv_run *r, double rem,
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

/* The next step in tau: a full one, or a shorter one that ends at rem.  The
 * series of coin_priv_tau_of() is accurate for about one step, so that it is
 * not used if rem is longer than two. */
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
    const int suffices =
        fabs(tau) < only && coin_priv_turns_little(r, rem, COIN_PRIV_ONLY_TURN);
    return suffices ? tau : side * full;
}

/* (rem W)^2, whose limits are the squares of rk8, only_rk8 and rk4. */
COIN_PRIV_INLINE double coin_priv_left2(const coin_priv_run *r, double rem)
{
    return rem * rem * coin_priv_rate2(r->b.g_a, &r->g.y);
}

/* Whether one step in t is accurate enough for all the time left. */
COIN_PRIV_INLINE int coin_priv_one_step_suffices(
    const coin_priv_run *r, const coin_priv_lengths *lengths, double rem)
{
    const double left2 = coin_priv_left2(r, rem);
    const double most2 = COIN_PRIV_FASTEST * COIN_PRIV_FASTEST * r->b.g_a;
    return left2 <= lengths->rk8 * lengths->rk8 ||
           (left2 <= lengths->only_rk8 * lengths->only_rk8 &&
            left2 <= rem * rem * most2 &&
            coin_priv_turns_little(r, rem, lengths->only_turn));
}

/* A step of tau.  If it passes the end of the time, it halves *stride, so that
 * the steps come to an end even where coin_priv_tau_of() is poor.  *r stays
 * where it is if the coin is flat, or the step fails or is one too many. */
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
COIN_PRIV_INLINE int coin_priv_rk4_suffices(const coin_priv_run *r,
                                            const coin_priv_lengths *lengths,
                                            double rem)
{
    const double left2 = coin_priv_left2(r, rem);
    if (r->steps != 0)
        return left2 <= lengths->rk4 * lengths->rk4;
    const double error = lengths->only_rk4 * rem;
    return left2 * left2 * left2 * left2 * left2 <= error * error * r->b.g_a;
}

/* One step in t over the time left, which is not 0. */
COIN_PRIV_INLINE int32_t coin_priv_last_step(coin_priv_run *r,
                                             const coin_priv_lengths *lengths,
                                             coin_priv_sum *rem)
{
    const uint64_t before = r->steps;
    r->dt = rem->sum;
    if (coin_priv_rk4_suffices(r, lengths, rem->sum))
        coin_priv_rk4(r, 1);
    else
        coin_priv_rk8(r, 1);
    if (r->steps == before)
        return COIN_ESTEP;
    rem->sum = 0;
    return COIN_OK;
}

/* coin_priv_last_step(), unless no time is left. */
COIN_PRIV_INLINE int32_t coin_priv_step_to_end(coin_priv_run *r,
                                               const coin_priv_lengths *lengths,
                                               coin_priv_sum *rem)
{
    return rem->sum == 0 ? COIN_OK : coin_priv_last_step(r, lengths, rem);
}

/* The part of t that has passed if *rem is left.  Its low part counts where t
 * is far longer. */
COIN_PRIV_INLINE double coin_priv_passed(double t, const coin_priv_sum *rem)
{
    return rem->sum == 0 ? t : (t - rem->sum) - rem->low;
}

/* Ends a call that was to move *s by the time t, of which *rem is left.  If a
 * rate has left its range, *s stays as it was and *reached becomes 0, as in a
 * run. */
COIN_PRIV_INLINE int32_t coin_priv_end_call(coin_state *s,
                                            const coin_priv_run *r,
                                            int32_t status, double t,
                                            const coin_priv_sum *rem,
                                            double *reached)
{
    const coin_state end = coin_priv_run_state(r);
    const int lost = !coin_priv_state_holds(&end, &r->b);
    if (!lost)
        coin_priv_copy_state(s, &end);
    if (reached)
        *reached = lost ? 0 : coin_priv_passed(t, rem);
    return lost || status == COIN_ESTEP ? coin_priv_refusal(s, r->b.a) : status;
}

#endif
