/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_METHOD_H
#define ROLLCOIN_METHOD_H

#include "stepper.h"

/* Whether there is such a method: what the others require. */
static inline int coinf_priv_method_known(int32_t method)
{
    return method == COIN_RK4 || method == COIN_SYMPLECTIC2;
}

/* |dt| W beyond which a step is coarse, and beyond which it is refused: as in
 * lib/method.c. */
static inline float coinf_priv_method_coarse(int32_t method)
{
    return method == COIN_RK4 ? 0.35f : 0.08f;
}
static inline float coinf_priv_method_most(int32_t method)
{
    return method == COIN_RK4 ? 1.2f : 1.0f;
}

#endif
