/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "steady.h"

#include <math.h>

int32_t coin_stability(const coin_state *s, const coin_params *p,
                       double *lambda2)
{
    coin_priv_constants b;
    coin_priv_sc th;
    const int32_t status =
        lambda2 ? coin_priv_check_steady(s, p, &b, &th) : COIN_EARG;
    if (status == COIN_OK) {
        const coin_priv_variables y = coin_priv_variables_of(s);
        *lambda2 = coin_priv_fall_slope(&b, &y);
    }
    return status;
}

double coin_critical_roll(const coin_params *p)
{
    coin_priv_constants b;
    if (!p || coin_priv_check_params(&b, p) != COIN_OK)
        return NAN;
    return sqrt(b.Mga / b.K / b.k1); /* (45) */
}

double coin_critical_spin(const coin_params *p)
{
    coin_priv_constants b;
    if (!p || coin_priv_check_params(&b, p) != COIN_OK)
        return NAN;
    return sqrt(b.GJ); /* (46) */
}
