/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_RUN_H
#define ROLLCOIN_RUN_H

#include "stepper.h"

/* Checks everything, then computes what the steps share. */
int32_t coinf_priv_prepare(coinf_priv_plan *plan, const coinf_state *s,
                           const coinf_params *p, int32_t method, float dt);

#endif
