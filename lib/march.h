/* SPDX-License-Identifier: MIT */
/* The loop around a Runge-Kutta step, and its guard. */
#ifndef ROLLCOIN_MARCH_H
#define ROLLCOIN_MARCH_H

#include "stepper.h"

/* Brings the pairs back to the unit circle, so that the angles alone tell the
 * state, and a run of n steps is n runs of one.  The lean's pair, which the
 * next step waits for, gets three terms of (1 - e)^(-1/2): the step left e =
 * O(h^5), and 5/16 e^3 remains, rounding for steps that are not coarse. */
COIN_PRIV_INLINE void coin_priv_renew(coin_priv_stage *y)
{
    const double q = 1 / y->cth;
    const double lean = 1 - (y->sth * y->sth + y->cth * y->cth);
    const double turn = 1 / sqrt(y->sph * y->sph + y->cph * y->cph);
    const double longer = 0.5 + 0.375 * lean;
    y->tth = y->sth * q;
    y->sth += (y->sth * lean) * longer;
    y->cth += (y->cth * lean) * longer;
    y->q = q - (q * lean) * (0.5 + 0.125 * lean);
    y->sph *= turn;
    y->cph *= turn;
}

/* Whether a step may end here: above the table all the way (lowest is the
 * least cos theta of its stages), in the range of coin_state_check(), W within
 * the limit.  Any NaN fails.  psi is the run's sum so far. */
COIN_PRIV_INLINE int coin_priv_sound(const coin_priv_moment *at, double psi,
                                     double lowest, double rate2, double most2)
{
    const double low = lowest < at->y.cth ? lowest : at->y.cth;
    return low > 0 && rate2 <= most2 &&
           fabs(at->pose.phi) <= COIN_PRIV_ANGLE_MAX &&
           fabs(psi + at->pose.psi) <= COIN_PRIV_ANGLE_MAX;
}

/* One step from *now to *next; returns the least cos theta of its stages. */
typedef double coin_priv_step(coin_priv_moment *next,
                              const coin_priv_moment *now,
                              const void *coefficients);

/* Up to n steps, as coin_priv_stepper says.  With lean set the results of
 * heading and pose are dropped, and with them all that computes them. */
COIN_PRIV_INLINE void coin_priv_march(coin_priv_carry *c, double g_a,
                                      coin_priv_limits *limits, uint64_t n,
                                      coin_priv_step *step,
                                      const void *coefficients, int lean)
{
    const double most2 = limits->most2;
    coin_priv_moment one = c->at, other = c->at, *now = &one, *next = &other;
    double rate2 = coin_priv_rate2(g_a, &c->at.y), worst2 = 0;
    const uint64_t end = c->steps + n;
    while (c->steps < end) {
        const double lowest = step(next, now, coefficients);
        if (lean) {
            next->y.sph = c->at.y.sph;
            next->y.cph = c->at.y.cph;
            next->pose = c->at.pose;
        }
        const double next2 = coin_priv_rate2(g_a, &next->y);
        const double step2 = rate2 > next2 ? rate2 : next2;
        if (!coin_priv_sound(next, c->psi.sum, lowest, step2, most2))
            break;
        worst2 = step2 > worst2 ? step2 : worst2;
        rate2 = next2;
        if (++c->steps % COIN_PRIV_SETTLE == 0 && !lean)
            coin_priv_settle(c, next);
        coin_priv_moment *const swapped = now;
        now = next;
        next = swapped;
    }
    if (worst2 > limits->coarse2)
        limits->warnings = COIN_COARSE;
    c->at = *now;
}

#endif
