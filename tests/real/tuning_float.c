/* SPDX-License-Identifier: MIT */
/* The counter of steps in floats: it needs other headers than tuning.c. */
#include "tuning.h"

#include "float/step.h"

int __real_coinf_priv_finish_step(coinf_state *s, coinf_state *next,
                                  const coinf_priv_plan *plan);
int __wrap_coinf_priv_finish_step(coinf_state *s, coinf_state *next,
                                  const coinf_priv_plan *plan);

int __wrap_coinf_priv_finish_step(coinf_state *s, coinf_state *next,
                                  const coinf_priv_plan *plan)
{
    ++counted[FLOAT_STEP];
    return __real_coinf_priv_finish_step(s, next, plan);
}
