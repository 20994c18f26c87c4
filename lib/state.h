/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_STATE_H
#define ROLLCOIN_STATE_H

#include "params.h"

/* The checks that nearly every public function begins with: COIN_EARG,
 * COIN_EPARAMS, COIN_ESTATE in this order.  After COIN_OK *b holds the body,
 * and no energy, force or rate of this state overflows. */
int32_t coin_priv_check(const coin_state *s, const coin_params *p,
                        coin_priv_body *b);

/* The last of them, of a body that is known. */
int32_t coin_priv_check_state(const coin_state *s, const coin_priv_body *b);

/* What can be said without parameters: COIN_OK or COIN_ESTATE.  s is not null.
 */
int32_t coin_priv_check_members(const coin_state *s);

#endif
