/* SPDX-License-Identifier: MIT */
#include "../motion/equations.h"
#include "../motion/state.h"

number coin_fastest_rate(const coin_state *s, const coin_params *p)
{
    coin_priv_body b;
    if (coin_priv_check(s, p, &b) != COIN_OK)
        return NAN;
    const coin_priv_variables y = coin_priv_variables_of(s);
    return SQRT(coin_priv_rate2(b.g_a, &y));
}
