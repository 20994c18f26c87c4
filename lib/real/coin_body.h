/* SPDX-License-Identifier: MIT */
/* A coin_body as a coin under way begins and ends with it. */
#ifndef ROLLCOIN_COIN_BODY_H
#define ROLLCOIN_COIN_BODY_H

#include "move.h"

/* A body touches the table up to this height above it, in radii: 16 u. */
#define COIN_PRIV_TOUCHES (8 * DBL_EPSILON)

/* Whether all members are in range. */
int coin_priv_members_hold(const coin_body *b, const coin_priv_body *of);

/* COIN_OK and *of, or COIN_EARG, COIN_EPARAMS, COIN_ESTATE in this order. */
int32_t coin_priv_check_coin_body(const coin_body *b, const coin_params *p,
                                  coin_priv_body *of);

/* The mode of a body that was checked, by the rule of touching in coin.h: 0,
 * COIN_PRIV_SLIPS, _AIR, _LIES or _RESTS.  A body whose contact approaches the
 * table is in the air.  u: its slip velocity along e_X and e_h in natural
 * units, 0 unless it slips. */
int coin_priv_body_mode(const coin_body *b, const coin_priv_body *of,
                        double u[2]);

/* Sets height and velocity to those of a coin that rolls. */
void coin_priv_set_rolling(coin_body *b, const coin_priv_body *of);

#endif
