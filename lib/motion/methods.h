/* SPDX-License-Identifier: MIT */
/* The methods by which a coin is stepped. */
#ifndef ROLLCOIN_METHODS_H
#define ROLLCOIN_METHODS_H

#include "equations.h"

/* The most by which a step may turn lean or heading: a step that turns them
 * further has missed what happens on the way.  It is below pi/2, up to which
 * coin_priv_turned() is accurate. */
#define COIN_PRIV_TURN_MAX 1.5

#include "methods.t.h"

/* Whether there is such a method; the functions below require it.  Floats have
 * RK4 alone. */
COIN_PRIV_INLINE int PRIV(method_is_known)(int32_t method)
{
#ifdef COIN_PRIV_FLOAT
    return method == COIN_RK4;
#else
    return method >= COIN_RK4 && method <= COIN_SYMPLECTIC4;
#endif
}

#endif
