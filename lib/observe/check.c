/* SPDX-License-Identifier: MIT */
#include "../motion/methods.h"
#include "../motion/rest.h"
#include "../motion/state.h"
#include "reaction.h"

int32_t COIN(check)(const COIN(state) * s, const COIN(params) * p,
                    int32_t method, real dt, real mu)
{
    PRIV(body) b;
    const int32_t status = PRIV(method_is_known)(method) && mu >= 0
                               ? PRIV(check_inline)(s, p, &b)
                               : COIN_EARG;
    if (status != COIN_OK)
        return status;
    if (!PRIV(time_holds)(dt, &b))
        return COIN_ESTEP;
    const PRIV(variables) y = PRIV(variables_inline)(s);
    const COIN(force) f = PRIV(reaction)(&b, &y);
    const real limit = PRIV(coarse_limit)(method);
    int32_t bits = 0;
    if (!(f.normal > 0))
        bits |= COIN_LIFTS;
    else if (mu > 1 ? f.friction / mu > f.normal : f.friction > mu * f.normal)
        bits |= COIN_SLIPS; /* no product of a large mu may overflow */
    if (dt * dt * PRIV(rate2)(b.g_a, &y) > limit * limit)
        bits |= COIN_COARSE;
    if (y.cth < K(COIN_PRIV_NEARLY_FLAT))
        bits |= COIN_NEARLY_FLAT;
    return bits;
}
