/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "stepper.h"

#include "rk4.h"

/* A last stage that is too fast is near the table, long before one could be
 * below. */
int coinf_priv_rk4(coinf_state *s, coinf_priv_plan *plan,
                   const coinf_priv_stage *y)
{
    struct slope first, rest;
    coinf_priv_stage last;
    slopes(&first, &rest, &last, plan, y);
    if (!coinf_priv_within(plan, &last))
        return 0;
    coinf_state next = *s;
    change(&next, &first, &rest);
    return coinf_priv_land(s, &next, plan);
}
