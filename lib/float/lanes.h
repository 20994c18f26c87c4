/* SPDX-License-Identifier: MIT */
/* Several coins abreast, as many as a vector of the processor holds floats. */
#ifndef ROLLCOIN_LANES_H
#define ROLLCOIN_LANES_H

#include "stepper.h"
#include "width.h"

#define COINF_PRIV_LANES (COINF_PRIV_WIDTH ? COINF_PRIV_WIDTH / 4 : 1)

/* n steps of up to COINF_PRIV_LANES coins, whose states are sound: *coin[k]
 * goes where it would go alone, and status[k] becomes what coinf_run() returns.
 */
typedef void coinf_priv_abreast(coinf_state *const *coin, int32_t *status,
                                int count, const coinf_priv_plan *plan,
                                uint64_t n);

/* That of a method, or null if there is none. */
coinf_priv_abreast *coinf_priv_method_abreast(int32_t method);

#endif
