/* SPDX-License-Identifier: MIT */
/* A step in single precision.
 *
 * Each addition to a float loses up to 6e-8 of it, and a firmware loop adds
 * thousands of steps.  So a state keeps what the rounding of its members left
 * out, and a step computes changes instead of values.  A step takes its sines
 * and cosines anew from the angles.  So a run of n steps is n runs of one step,
 * to the bit. */
#ifndef ROLLCOIN_FLOAT_STEP_H
#define ROLLCOIN_FLOAT_STEP_H

#include "floats.h"

#include "../motion/methods.h"
#include "../motion/state.h"

#include "step.t.h"

/* Checks everything, then computes what the steps share. */
int32_t coinf_priv_plan_of(coinf_priv_plan *plan, const coinf_state *s,
                           const coinf_params *p, int32_t method, float dt);

/* One step of *s, whose variables are *y.  Returns 0 and leaves *s untouched if
 * the step is refused.  *warnings becomes COIN_COARSE if the step was coarse.
 */
typedef int coinf_priv_step_function(coinf_state *s, int32_t *warnings,
                                     const coinf_priv_plan *plan,
                                     const coinf_priv_variables *y);

coinf_priv_step_function coinf_priv_step_rk4, coinf_priv_step_symplectic2;

/* Notes COIN_COARSE if W^2 is beyond coarse2.  Returns 0, a refusal, if it is
 * beyond most2 or NaN. */
COIN_PRIV_INLINE int coinf_priv_admit_rate(int32_t *warnings,
                                           const coinf_priv_plan *plan,
                                           const coinf_priv_variables *y)
{
    const float rate2 = coinf_priv_rate2(plan->g_a, y);
    if (!(rate2 <= plan->coarse2))
        *warnings = COIN_COARSE;
    return rate2 <= plan->most2;
}

/* One step of *s by a method; 0 if it is refused. */
int coinf_priv_step_by(coinf_state *s, int32_t *warnings,
                       const coinf_priv_plan *plan,
                       coinf_priv_step_function *method);

/* Ends a step.  If *next is a sound state, *s becomes *next, with heading and
 * roll brought within half a turn.  Else returns 0 and leaves *s untouched. */
int coinf_priv_finish_step(coinf_state *s, coinf_state *next,
                           const coinf_priv_plan *plan);

#endif
