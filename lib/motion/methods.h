/* SPDX-License-Identifier: MIT */
/* The methods by which a coin is stepped. */
#ifndef ROLLCOIN_METHODS_H
#define ROLLCOIN_METHODS_H

/* Steps of a block; blocks are counted from the start of a run, so that its
 * bits do not depend on where it is looked at. */
#define COIN_PRIV_BLOCK 64

/* Twice what the 64 steps of a block can turn phi or psi by, and move the
 * centre by in radii.  A step turns phi by at most TURN_MAX, psi by at most
 * sqrt(2) |dt| W, and moves the centre by at most |dt| W: all by less than 2.
 */
#define COIN_PRIV_BLOCK_MOVES 256.0

#include "methods.t.h"

/* Whether there is such a method; the functions below require it.  Floats have
 * RK4 alone. */
COIN_PRIV_INLINE int coin_priv_method_is_known(int32_t method)
{
#ifdef COIN_PRIV_FLOAT
    return method == COIN_RK4;
#else
    return method >= COIN_RK4 && method <= COIN_SYMPLECTIC4;
#endif
}

#endif
