/* SPDX-License-Identifier: MIT */
#include "body.h"

int32_t COIN(params_check)(const COIN(params) * p)
{
    PRIV(body) b;
    return p ? PRIV(check_body)(&b, p) : COIN_EARG;
}

int32_t COIN(params_body)(COIN(params) * p, real mass, real radius,
                          real gravity, real inertia_X, real inertia_Z)
{
    const COIN(params) made = {
        mass, radius, gravity, inertia_X, inertia_Z, {0, 0, 0},
    };
    const int32_t status = p ? COIN(params_check)(&made) : COIN_EARG;
    if (status == COIN_OK)
        *p = made;
    return status;
}

int32_t COIN(params_ring)(COIN(params) * p, real mass, real radius,
                          real inner_radius, real gravity)
{
    const real M = mass, a = radius, b = inner_radius;
    const real IX = M * (a * a + b * b) / 4; /* (29) */
    if (p && !(b >= 0 && b <= a))
        return COIN_EPARAMS;
    return COIN(params_body)(p, M, a, gravity, IX, 2 * IX);
}

int32_t COIN(params_disc)(COIN(params) * p, real mass, real radius,
                          real gravity)
{
    return COIN(params_ring)(p, mass, radius, 0, gravity);
}
