/* SPDX-License-Identifier: MIT */
/* A coin_body as a coin under way begins and ends with it. */
#ifndef ROLLCOIN_COIN_BODY_H
#define ROLLCOIN_COIN_BODY_H

#include "move.h"

/* A coin touches the table up to this height above it, in radii, times 1 + h:
 * 16 u, more than the rounding of height and cos theta.  Measured:
 * COIN_PRIV_TOUCH_GAP in tables.md. */
#define COIN_PRIV_TOUCH_GAP (8 * DBL_EPSILON)

/* The height of the lowest point above the table. */
COIN_PRIV_INLINE double coin_priv_gap(const coin_priv_coin *c)
{
    return c->y - coin_priv_height(c);
}

COIN_PRIV_INLINE int coin_priv_is_low(const coin_priv_coin *c)
{
    return coin_priv_gap(c) <= COIN_PRIV_TOUCH_GAP * (1 + c->half);
}

/* Whether a coin lies flat, with wY = 0.  It may slide and turn on its face. */
COIN_PRIV_INLINE int coin_priv_lies(const coin_priv_coin *c)
{
    return c->th.c < 2 * DBL_EPSILON && c->wX == 0;
}

/* Whether all members but reserved[] of a body in units of these lengths and
 * rates are in range. */
int coin_priv_body_in_range(const coin_body *b, double length, double rate);

/* The same of a coin under way, but for phi: a contact looks at that itself,
 * and nothing else takes it out of its range. */
int coin_priv_coin_in_range(const coin_priv_coin *c);

/* Turns the axes of a coin whose face is horizontal, and the coin back, so that
 * the lowest point is the one that goes down fastest: wY = 0, wX sin(theta) <=
 * 0.  Its pose and its motion stay. */
void coin_priv_turn_axes(coin_priv_coin *c);

/* Sets *c to a body of a coin with these constants, after the checks of the
 * parameters: COIN_OK, or COIN_ESTATE. */
int32_t coin_priv_coin_of(coin_priv_coin *c, const coin_body *b,
                          const coin_priv_constants *of, double half);

/* The same with all checks, which set *of: also COIN_EARG, COIN_EPARAMS. */
int32_t coin_priv_check_coin_body(coin_priv_coin *c, const coin_body *b,
                                  const coin_params *p,
                                  coin_priv_constants *of);

/* Sets *b, but for reserved[], to a coin. */
void coin_priv_body_of(coin_body *b, const coin_priv_coin *c,
                       const coin_priv_constants *of);

/* Sets height and velocity of a body of the radius a on the table to what its
 * other members, which have been rounded, say, as coin_velocity(): of one that
 * does not slip; or, but for vx and vz, of one that slips.  tips: the place of
 * the rim over which it is about to tip, where neither is lower; or 0. */
void coin_priv_set_on_table(coin_body *b, double a, double half, double tips,
                            int slips);

/* What a coin does on a table, by the rule of touching in coin.h: 0,
 * COIN_PRIV_SLIPS, _AIR, _LINE, _LIES or _RESTS.  A coin whose lowest point is
 * on the table and has a normal speed is in the air: it hits the table or
 * leaves it.  u: its slip velocity along e_X and e_h, 0 unless it slips. */
int coin_priv_coin_mode(const coin_priv_coin *c, const coin_priv_law *l,
                        double u[2]);

/* The mode of a coin on both rims that begins to tip over the rim at eta: 0 if
 * that rim rolls, COIN_PRIV_SLIPS if it slips.  u: set to the velocity of its
 * lowest point along e_X and e_h. */
int coin_priv_tip_mode(const coin_priv_coin *c, double eta, double u[2]);

#endif
