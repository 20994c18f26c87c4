/* SPDX-License-Identifier: MIT */
#include "../motion/equations.h"
#include "../motion/state.h"

int32_t coin_rates(const coin_state *s, const coin_params *p, coin_state *out)
{
    coin_priv_constants b;
    const int32_t status = out ? coin_priv_check(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const coin_priv_field field = coin_priv_field_of(&b, 1);
    const coin_priv_variables y = coin_priv_variables_of(s);
    const coin_priv_variables d = coin_priv_slopes_at(&field, &y);
    const coin_priv_pose v = coin_priv_pose_slopes(&field, &y);
    number path[3];
    coin_priv_velocity_of(path, b.a, &y);
    const coin_state rates = {
        s->wX,   v.phi, v.psi, path[0],
        path[2], d.wX,  d.wY,  d.wZ COIN_PRIV_NO_LOW,
    };
    *out = rates;
    return COIN_OK;
}

number coin_fastest_rate(const coin_state *s, const coin_params *p)
{
    coin_priv_constants b;
    if (coin_priv_check(s, p, &b) != COIN_OK)
        return NAN;
    const coin_priv_variables y = coin_priv_variables_of(s);
    return SQRT(coin_priv_rate2(b.g_a, &y));
}
