/* SPDX-License-Identifier: MIT */
#include "equations.h"

PRIV(variables) PRIV(variables_of)(const COIN(state) * s)
{
    return PRIV(variables_inline)(s);
}
