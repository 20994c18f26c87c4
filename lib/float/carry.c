/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "stepper.h"

#define PART
#define TRUTH int
#include "carry.h"

int coinf_priv_land(coinf_state *s, coinf_state *next,
                    const coinf_priv_plan *plan)
{
    if (!holds(next, plan))
        return 0;
    if (fabsf(next->phi) > PI)
        take_turns_off(&next->phi, &next->low[1]);
    if (fabsf(next->psi) > PI)
        take_turns_off(&next->psi, &next->low[2]);
    *s = *next;
    return 1;
}
