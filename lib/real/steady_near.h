/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_STEADY_NEAR_H
#define ROLLCOIN_STEADY_NEAR_H

#include "../motion/state.h"

/* Makes *s the stable steady motion that it swings about, which has the same
 * two linear integrals: COIN_OK, or COIN_EDOMAIN where none is found, and *s
 * untouched.  s has passed coin_priv_check_state(). */
int32_t coin_priv_steady_near(coin_state *s, const coin_priv_body *b);

#endif
