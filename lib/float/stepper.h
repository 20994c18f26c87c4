/* SPDX-License-Identifier: MIT */
/* A step in single precision.
 *
 * Each addition to a float loses up to 6e-8 of it, and a firmware loop adds
 * thousands of steps.  So a state keeps what its sums left out, a step computes
 * changes instead of values, and takes its sines and cosines anew from the
 * angles: a run of n steps is n runs of one step, to the bit.
 *
 * What theta, phi, psi, x, z, wX, wY, wZ left out is low[0] to low[7]. */
#ifndef ROLLCOIN_STEPPER_H
#define ROLLCOIN_STEPPER_H

#include "change.h"
#include "stage.h"

/* One step of *s, whose stage is *y; 0 if it would not be sound, and *s is then
 * untouched. */
typedef int coinf_priv_stepper(coinf_state *s, coinf_priv_plan *plan,
                               const coinf_priv_stage *y);

coinf_priv_stepper coinf_priv_rk4, coinf_priv_symplectic2;

/* What the rounding of a b leaves out, to the bit. */
float coinf_priv_residue(float a, float b);

/* Sine and cosine of an angle and its remainder. */
coinf_priv_sc coinf_priv_pair(float angle, float low);

/* A state as the equations read it. */
void coinf_priv_stage_at(coinf_priv_stage *y, const coinf_state *s);

/* Whether W is within the limit; notes if it is beyond that of full accuracy.
 * NaN is not. */
COINF_PRIV_INLINE int coinf_priv_within(coinf_priv_plan *plan,
                                        const coinf_priv_stage *y)
{
    const float rate2 = coinf_priv_rate2(plan->g_a, y);
    if (!(rate2 <= plan->coarse2))
        plan->warnings = COIN_COARSE;
    return rate2 <= plan->most2;
}

/* Ends a step: *s becomes *next, its heading and roll within half a turn, if
 * that is a sound state. */
int coinf_priv_land(coinf_state *s, coinf_state *next,
                    const coinf_priv_plan *plan);

#endif
