/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_LANES_H
#define ROLLCOIN_LANES_H

#include "run.h"

/* A run of COIN_PRIV_LANES coins side by side, one in each lane of a vector:
 * *where[k] gets the bits that coin_run() would give it, and status[k] becomes
 * what coin_run() returns.  *b is their body, dt is finite and not 0.
 * A coin whose steps need a closer look leaves its lane and goes on by
 * itself. */
typedef void coin_priv_lanes_run(coin_state *const *where, int32_t *status,
                                 const coin_params *p, const coin_priv_body *b,
                                 double dt, uint64_t steps);

/* That of a method, or null if it has none, or this processor has no vectors.
 */
coin_priv_lanes_run *coin_priv_lanes_run_of(int32_t method);

#endif
