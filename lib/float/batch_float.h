/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_BATCH_FLOAT_H
#define ROLLCOIN_BATCH_FLOAT_H

#include "step.h"

#include "../step/batch.h"

/* n steps of up to COINF_PRIV_LANES coins whose states have been checked:
 * *coin[k] gets the bits that coinf_run() would give it, and status[k] becomes
 * what that returns. */
typedef void coinf_priv_group_run(coinf_state *const *coin, int32_t *status,
                                  int count, const coinf_priv_plan *plan,
                                  uint64_t n);

/* The function for a method, or null if there is none. */
coinf_priv_group_run *coinf_priv_group_run_of(int32_t method);

#endif
