/* SPDX-License-Identifier: MIT */
#include "../motion/methods.h"
#include "../motion/state.h"
#include "reaction.h"

int32_t coin_check(const coin_state *s, const coin_params *p, int32_t method,
                   number dt, number mu)
{
    coin_priv_constants b;
    const int32_t status = coin_priv_method_is_known(method) && mu >= 0
                               ? coin_priv_check_inline(s, p, &b)
                               : COIN_EARG;
    if (status != COIN_OK)
        return status;
    if (!coin_priv_time_in_range(dt, &b))
        return COIN_ESTEP;
    const coin_priv_variables y = coin_priv_variables_inline(s);
    const coin_force f = coin_priv_reaction(&b, &y);
    const number limit = coin_priv_reaches[method].coarse;
    int32_t bits = 0;
    if (!(f.normal > 0))
        bits |= COIN_LIFTS;
    else if (mu > 1 ? f.friction / mu > f.normal : f.friction > mu * f.normal)
        bits |= COIN_SLIPS; /* no product of a large mu may overflow */
    if (dt * dt * coin_priv_rate2(b.g_a, &y) > limit * limit)
        bits |= COIN_COARSE;
    if (y.cth < K(COIN_PRIV_NEARLY_FLAT))
        bits |= COIN_NEARLY_FLAT;
    return bits;
}
