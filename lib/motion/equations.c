/* SPDX-License-Identifier: MIT */
#include "equations.h"

coin_priv_variables coin_priv_variables_of(const coin_state *s)
{
    return coin_priv_variables_inline(s);
}
