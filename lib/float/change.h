/* SPDX-License-Identifier: MIT */
/* What a step changes a state by, and how that is added. */
#ifndef ROLLCOIN_CHANGE_H
#define ROLLCOIN_CHANGE_H

#include "motion.h"
#include "number.h"

#include <stdint.h>

/* What the steps of a run share: the equations of motion times dt, and the
 * limits on W^2, Eq. (47), where a step begins and ends. */
typedef struct coinf_priv_plan {
    coinf_priv_field f;
    float KJ_low; /* (KJ + KJ_low)/GJ is K/(M g a), beyond a float's digits */
    float a, g_a, k1, k2;
    float coarse2, most2; /* coarse2 <= most2 */
    int32_t warnings;     /* COIN_COARSE once a step was */
} coinf_priv_plan;

/* Adds a part, and a small one that its digits could not hold, to a sum and
 * what that has left out so far. */
COINF_PRIV_INLINE void coinf_priv_add(float *sum, float *low, float part,
                                      float small)
{
    const float large = *sum + part, of_part = large - *sum;
    const float off = (*sum - (large - of_part)) + (part - of_part);
    const float rest = (*low + small) + off;
    *sum = large + rest;
    *low = rest - (*sum - large);
}

/* h d(wX)/dt, Eq. (14), beyond what coinf_priv_motion() makes of it. */
static inline float coinf_priv_fall_low(const coinf_priv_plan *plan,
                                        const coinf_priv_stage *y)
{
    return -(plan->KJ_low * y->wZ * y->wY);
}

#endif
