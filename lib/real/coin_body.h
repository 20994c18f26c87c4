/* SPDX-License-Identifier: MIT */
/* A coin_body as a coin under way begins and ends with it. */
#ifndef ROLLCOIN_COIN_BODY_H
#define ROLLCOIN_COIN_BODY_H

#include "../air/air.h"
#include "move.h"

/* A body touches the table up to this height above it, in radii: 16 u, more
 * than the rounding of height and cos theta.  From an eighth to eight times of
 * it no motion of make tuning changes. */
#define COIN_PRIV_TOUCH_GAP (8 * DBL_EPSILON)

/* Whether all members but reserved[] are in range, in units of these lengths
 * and rates. */
int coin_priv_members_hold(const coin_body *b, double length, double rate);

/* Scales a body to units in which lengths and rates are these times what they
 * were. */
void coin_priv_scale_body(coin_body *b, double length, double rate);

/* Sets *natural to *b in natural units, and its attitude: COIN_OK, or
 * COIN_ESTATE. */
int32_t coin_priv_natural_body(coin_body *natural, coin_priv_attitude *at,
                               const coin_body *b, const coin_priv_body *of);

/* The same after the checks of the pointers and the parameters, with the body
 * of the parameters: also COIN_EARG, COIN_EPARAMS, in this order. */
int32_t coin_priv_check_coin_body(coin_body *natural, coin_priv_attitude *at,
                                  const coin_body *b, const coin_params *p,
                                  coin_priv_body *of);

/* Whether a body lies flat.  It may slide and turn on its face. */
int coin_priv_body_lies(const coin_body *b);

/* The mode of a body in natural units, by the rule of touching in coin.h: 0,
 * COIN_PRIV_SLIPS, _AIR, _LIES or _RESTS.  A body whose lowest point is on the
 * table and has a normal speed is in the air: it hits the table or leaves it.
 * u: its slip velocity along e_X and e_h, 0 unless it slips. */
int coin_priv_body_mode(const coin_body *b, const coin_priv_attitude *at,
                        double u[2]);

/* Sets height and velocity to those of a coin of the radius a that rolls. */
void coin_priv_set_rolling(coin_body *b, const coin_priv_attitude *at,
                           double a);

#endif
