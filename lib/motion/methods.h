/* SPDX-License-Identifier: MIT */
/* The methods by which a coin is stepped. */
#ifndef ROLLCOIN_METHODS_H
#define ROLLCOIN_METHODS_H

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
