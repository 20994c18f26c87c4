/* SPDX-License-Identifier: MIT */
#include "state.h"

int32_t PRIV(check)(const COIN(state) * s, const COIN(params) * p,
                    PRIV(body) * b)
{
    return PRIV(check_inline)(s, p, b);
}

int32_t COIN(state_check)(const COIN(state) * s, const COIN(params) * p)
{
    PRIV(body) b;
    return PRIV(check)(s, p, &b);
}
