/* SPDX-License-Identifier: MIT */
/* How far a step of each method may go.  Beyond one limit of |dt| W, with W of
 * Eq. (47), a step is COIN_COARSE; beyond another one it is refused. */
#ifndef ROLLCOIN_METHODS_H
#define ROLLCOIN_METHODS_H

#include "equations.h"

/* Whether there is such a method; the functions below require it.  Floats have
 * RK4 alone. */
COIN_PRIV_INLINE int PRIV(method_is_known)(int32_t method)
{
#ifdef COIN_PRIV_FLOAT
    return method == COIN_RK4;
#else
    return method >= COIN_RK4 && method <= COIN_SYMPLECTIC4;
#endif
}

/* The limit of |dt| W beyond which a step is COIN_COARSE.  Up to it a step adds
 * errors of at most 5e-4 (RK4), 2e-4 (RK8), 3e-4 and 4e-6 (symplectic2 and 4),
 * in radians, radii and parts of W: docs/limits.md, test_step_law. */
COIN_PRIV_INLINE real PRIV(coarse_limit)(int32_t method)
{
    return method == COIN_RK4           ? K(0.35)
           : method == COIN_RK8         ? K(1)
           : method == COIN_SYMPLECTIC2 ? K(0.08)
                                        : K(0.16);
}

/* The limit of |dt| W beyond which a step is refused.  Beyond 1.2 a step of RK4
 * or RK8 may jump over a whole pass near flat.  Up to the limits of the
 * symplectic methods the series of their drift suffices (docs/limits.md). */
COIN_PRIV_INLINE real PRIV(refusal_limit)(int32_t method)
{
    return method == COIN_RK4 || method == COIN_RK8 ? K(1.2)
           : method == COIN_SYMPLECTIC2             ? K(1)
                                                    : K(1.4);
}

/* Limits of W^2 in a run: COIN_COARSE beyond coarse2, COIN_ESTEP beyond most2,
 * both compared where each step begins and ends. */
typedef struct PRIV(limits) {
    real coarse2, most2; /* coarse2 <= most2 */
    int32_t warnings;    /* COIN_COARSE once a step was */
} PRIV(limits);

/* The limits of steps of dt.  Pre: dt is finite. */
COIN_PRIV_INLINE PRIV(limits)
    PRIV(limits_of)(const PRIV(body) * b, int32_t method, real dt)
{
    const real most = PRIV(refusal_limit)(method);
    const real coarse = PRIV(coarse_limit)(method);
    const real size = FABS(dt);
    /* |dt| is clipped, so that 1/dt^2 neither overflows nor underflows.  At
     * DT_MOST the limit is below the W of any coin: a longer step is refused
     * too. */
    const real kept = size < COIN_PRIV_DT_LEAST  ? COIN_PRIV_DT_LEAST
                      : size > COIN_PRIV_DT_MOST ? COIN_PRIV_DT_MOST
                                                 : size;
    const real over = 1 / (kept * kept);
    const real most2 = PRIV(lesser)(most * most * over, b->w2_max);
    const PRIV(limits) limits = {
        PRIV(lesser)(coarse * coarse * over, most2),
        most2,
        COIN_OK,
    };
    return limits;
}

/* Notes COIN_COARSE if W^2 is beyond coarse2.  Returns 0, a refusal, if it is
 * beyond most2 or NaN. */
COIN_PRIV_INLINE int PRIV(admit_rate2)(PRIV(limits) * limits, real rate2)
{
    if (rate2 <= limits->coarse2)
        return 1;
    limits->warnings = COIN_COARSE;
    return rate2 <= limits->most2;
}

/* The most by which a step may turn lean or heading: a step that turns them
 * further has missed what happens on the way.  It is below pi/2, up to which
 * coin_priv_turned() is accurate. */
#define COIN_PRIV_TURN_MAX 1.5

/* admit_rate2() where a step ends.  The step is also refused if it turned lean
 * or heading by more than COIN_PRIV_TURN_MAX, or led through the table. */
COIN_PRIV_INLINE int PRIV(admit_step)(PRIV(limits) * limits, real g_a,
                                      const PRIV(step_end) * end,
                                      const PRIV(variables) * next)
{
    const int turn_holds = (FABS(end->adds.theta) <= K(COIN_PRIV_TURN_MAX)) &
                           (FABS(end->adds.phi) <= K(COIN_PRIV_TURN_MAX));
    /* For RK4 and RK8 these signs never decide: 285,000 runs ended with the
     * same bits without this test (docs/limits.md).  The symplectic methods
     * set least_cth to 0 where a drift cannot be done. */
    const int above = (end->least_cth > 0) & (next->cth > 0);
    return turn_holds && above &&
           PRIV(admit_rate2)(limits, PRIV(rate2)(g_a, next));
}

#endif
