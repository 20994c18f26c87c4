/* SPDX-License-Identifier: MIT */
#include "params.h"

int32_t coin_params_check(const coin_params *p)
{
    coin_priv_constants b;
    return p ? coin_priv_check_thick(&b, p) : COIN_EARG;
}

int32_t coin_params_body(coin_params *p, number mass, number radius,
                         number gravity, number inertia_X, number inertia_Z)
{
    const coin_params made = {
        mass, radius, gravity, inertia_X, inertia_Z, 0, {0, 0},
    };
    const int32_t status = p ? coin_params_check(&made) : COIN_EARG;
    if (status == COIN_OK)
        *p = made;
    return status;
}

int32_t coin_params_ring(coin_params *p, number mass, number radius,
                         number inner_radius, number gravity)
{
    const number M = mass, a = radius, b = inner_radius;
    const number IX = M * (a * a + b * b) / 4; /* (29) */
    if (p && !(b >= 0 && b <= a))
        return COIN_EPARAMS;
    return coin_params_body(p, M, a, gravity, IX, 2 * IX);
}

int32_t coin_params_disc(coin_params *p, number mass, number radius,
                         number gravity)
{
    return coin_params_ring(p, mass, radius, 0, gravity);
}
