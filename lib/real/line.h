/* SPDX-License-Identifier: MIT */
/* A coin with a thickness that stands, rolls or slides on its side: theta = 0,
 * wX = 0, and both rims touch the table. */
#ifndef ROLLCOIN_LINE_H
#define ROLLCOIN_LINE_H

#include "move.h"

/* Why coin_priv_move_on_line() returns. */
enum {
    COIN_PRIV_LINE_GOES,    /* no time, or no trials, are left */
    COIN_PRIV_LINE_CHANGES, /* a rim has begun or ceased to slip, or will now */
    COIN_PRIV_LINE_TIPS,    /* over a rim */
    COIN_PRIV_LINE_RESTS    /* all its velocities are 0 */
};

/* Moves the coin g->c, which is on the line, until one of these.  The call has
 * begun: the time moved is added to g->moved.  Returns COIN_OK, or COIN_ERANGE.
 * *over: the rim over which the coin tips, +1 or -1, or 0.  It holds even where
 * coin_priv_tips() says 0 of the coin at the end, which is rounded. */
int32_t coin_priv_move_on_line(coin_priv_moving *g, int *why, int *over);

/* The rim of a coin on the line over which it tips: +1, the one on the side of
 * +Z; -1; 0: it stays. */
int coin_priv_tips(const coin_priv_coin *c, const coin_priv_law *l);

/* What a coin on the line does: COIN_PRIV_SLIPS, a rim slips, or begins to;
 * _RESTS; 0. */
int coin_priv_line_mode(const coin_priv_coin *c, const coin_priv_law *l);

/* The force on a coin on the line, of both rims. */
coin_priv_push coin_priv_line_push(const coin_priv_coin *c,
                                   const coin_priv_law *l);

#endif
