/* SPDX-License-Identifier: MIT */
#include "reaction.h"
#include "../motion/equations.h"
#include "../motion/state.h"

int32_t coin_reaction(const coin_state *s, const coin_params *p,
                      coin_force *out)
{
    coin_priv_constants b;
    const int32_t status = out ? coin_priv_check_inline(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const coin_priv_variables y = coin_priv_variables_inline(s);
    *out = coin_priv_reaction(&b, &y);
    return COIN_OK;
}
