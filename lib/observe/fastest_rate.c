/* SPDX-License-Identifier: MIT */
#include "../motion/equations.h"
#include "../motion/state.h"

real COIN(fastest_rate)(const COIN(state) * s, const COIN(params) * p)
{
    PRIV(body) b;
    if (PRIV(check)(s, p, &b) != COIN_OK)
        return NAN;
    const PRIV(variables) y = PRIV(variables_of)(s);
    return SQRT(PRIV(rate2)(b.g_a, &y));
}
