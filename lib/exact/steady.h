/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_STEADY_H
#define ROLLCOIN_STEADY_H

#include "../motion/equations.h"
#include "../motion/state.h"

/* The usual checks, then COIN_EDOMAIN unless the motion is steady.  After
 * COIN_OK *b and *th hold the constants and sine and cosine of the lean. */
int32_t coin_priv_check_steady(const coin_state *s, const coin_params *p,
                               coin_priv_constants *b, coin_priv_sc *th);

#endif
