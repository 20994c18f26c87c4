/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_REST_H
#define ROLLCOIN_REST_H

#include "precision.h"

#include <coin.h>

#include <float.h>
#include <math.h>

/* COIN_NEARLY_FLAT begins below this cos theta (coin.h). */
#define COIN_PRIV_NEARLY_FLAT 0.01

/* The last lean that coin_state_check() accepts: that of a coin at rest. */
#define COIN_PRIV_LAST_LEAN (COIN_PRIV_HALF_PI - COIN_PRIV_EPSILON)

/* Whether a coin lies flat. */
COIN_PRIV_INLINE int coin_priv_lies_flat(const coin_state *s)
{
    return FABS(s->theta) >= COIN_PRIV_LAST_LEAN && s->wY == 0 &&
           s->wX * s->theta >= 0;
}

#endif
