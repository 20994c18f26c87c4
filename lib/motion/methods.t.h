/* SPDX-License-Identifier: MIT */
/* How far a step of each method may go.  Beyond one limit of |dt| W, with W of
 * Eq. (47), a step is COIN_COARSE; beyond another one it is refused. */
#include "equations.h"

#include "kind.h"

/* Limits of W^2 in a run: COIN_COARSE beyond coarse2, COIN_ESTEP beyond most2,
 * both compared where each step begins and ends.  And what the limit of its
 * path needs: the radius, and where the path starts. */
typedef struct PRIV(limits) {
    real g_a, coarse2, most2; /* coarse2 <= most2 */
    real a, x, z;
    whole coarse; /* all ones once a step was COIN_COARSE */
} PRIV(limits);

#ifndef COIN_PRIV_ABREAST
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

/* The limits of steps of dt from *s.  All steps are refused if dt is not
 * finite.
 */
COIN_PRIV_INLINE PRIV(limits)
    PRIV(limits_of)(const PRIV(body) * b, int32_t method, real dt)
{
    const real most = PRIV(refusal_limit)(method);
    const real coarse = PRIV(coarse_limit)(method);
    const real size = FABS(dt);
    const real kept = size < COIN_PRIV_DT_LEAST ? COIN_PRIV_DT_LEAST : size;
    const real over = 1 / (kept * kept);
    const PRIV(limits) limits = {
        b->g_a, coarse * coarse * over, most * most * over, b->a, 0, 0, 0,
    };
    return limits;
}
#endif

/* Whether W^2 allows a step from *y.  Notes if the step is COIN_COARSE.  NaN
 * allows none. */
COIN_PRIV_INLINE whole PRIV(admit_start)(PRIV(limits) * limits,
                                         const PRIV(variables) * y)
{
    const real rate2 = PRIV(rate2)(limits->g_a, y);
    limits->coarse |= ~PRIV(truth)(rate2 <= limits->coarse2);
    return PRIV(truth)(rate2 <= limits->most2);
}

/* Whether a step is made, by what is known where it ends.  It is refused if
 * admit_start() refuses the next one from there, or if it turned lean or
 * heading by more than COIN_PRIV_TURN_MAX.  A step through the table needs no
 * test: if it begins at |dt| W = r, it ends near r/(r - 1), beyond the limit.
 */
COIN_PRIV_INLINE whole PRIV(admit_step)(PRIV(limits) * limits,
                                        const PRIV(step_end) * end,
                                        const PRIV(variables) * next)
{
    const real turn = PRIV(magnitude)(end->adds.theta);
    const real heading = PRIV(magnitude)(end->adds.phi);
    return PRIV(truth)(turn <= K(COIN_PRIV_TURN_MAX)) &
           PRIV(truth)(heading <= K(COIN_PRIV_TURN_MAX)) &
           PRIV(admit_start)(limits, next);
}

/* Whether a step is made for every coin.  One that ends with a W within the
 * coarse limit turns lean and heading by at most 1.2 rad, and stays above the
 * table: W is all that is computed then (test_step_law). */
COIN_PRIV_INLINE int PRIV(admit_each)(PRIV(limits) * limits,
                                      const PRIV(step_end) * end,
                                      const PRIV(variables) * next)
{
    const real rate2 = PRIV(rate2)(limits->g_a, next);
    return PRIV(every)(rate2 <= limits->coarse2) ||
           PRIV(every)(PRIV(admit_step)(limits, end, next) != 0);
}
