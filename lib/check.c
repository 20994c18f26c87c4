/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "method.h"
#include "reaction.h"
#include "state.h"

#include <math.h>

#define NEARLY_FLAT 0.01

int32_t coin_check(const coin_state *s, const coin_params *p, int32_t method,
                   double dt, double mu)
{
    coin_priv_body b;
    const int32_t status = coin_priv_method_known(method) && mu >= 0
                               ? coin_priv_check(s, p, &b)
                               : COIN_EARG;
    if (status != COIN_OK)
        return status;
    if (!(dt - dt == 0))
        return COIN_ESTEP;
    const coin_priv_stage y = coin_priv_stage_of(s);
    const coin_force f = coin_priv_reaction(&b, &y);
    const double W = sqrt(coin_priv_rate2(b.g_a, &y)); /* (47) */
    int32_t bits = 0;
    if (!(f.normal > 0))
        bits |= COIN_LIFTS;
    else if (f.friction > mu * f.normal)
        bits |= COIN_SLIPS;
    if (fabs(dt) * W > coin_priv_method_coarse(method))
        bits |= COIN_COARSE;
    if (y.cth < NEARLY_FLAT)
        bits |= COIN_NEARLY_FLAT;
    return bits;
}
