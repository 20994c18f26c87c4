/* SPDX-License-Identifier: MIT */
#include "../motion/equations.h"
#include "../motion/state.h"

int32_t COIN(rates)(const COIN(state) * s, const COIN(params) * p,
                    COIN(state) * out)
{
    PRIV(body) b;
    const int32_t status = out ? PRIV(check)(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const PRIV(field) field = PRIV(field_of)(&b, 1);
    const PRIV(variables) y = PRIV(variables_of)(s);
    const PRIV(variables) d = PRIV(slopes_at)(&field, &y);
    const PRIV(pose) v = PRIV(pose_slopes)(&field, &y);
    real path[3];
    PRIV(velocity_of)(path, b.a, &y);
    const COIN(state) rates = {
        s->wX,   v.phi, v.psi, path[0],
        path[2], d.wX,  d.wY,  d.wZ COIN_PRIV_NO_LOW,
    };
    *out = rates;
    return COIN_OK;
}
