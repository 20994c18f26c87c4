/* SPDX-License-Identifier: MIT */
#include "reaction.h"
#include "../motion/equations.h"
#include "../motion/state.h"

int32_t COIN(reaction)(const COIN(state) * s, const COIN(params) * p,
                       COIN(force) * out)
{
    PRIV(body) b;
    const int32_t status = out ? PRIV(check_inline)(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const PRIV(variables) y = PRIV(variables_inline)(s);
    *out = PRIV(reaction)(&b, &y);
    return COIN_OK;
}
