/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "steady.h"

#include <math.h>

double coin_priv_stability(const coin_state *s, const coin_priv_body *b,
                           const coin_priv_sc *th)
{
    const double wY = s->wY, wZ = s->wZ, wYT = wY * (th->s / th->c);
    const double IX = b->IX, IZ = b->IZ, m = b->m;
    /* clang-format off */
    const double L = b->Mga * th->c                           /* (44) */
                   - IX * (wY * wY + 3 * (wYT * wYT)) - m * (wY * wY)
                   - (3 * IZ + m) * (wYT * wZ)
                   - b->k1 * b->K * (wZ * wZ);
    /* clang-format on */
    return L / b->J;
}

int32_t coin_stability(const coin_state *s, const coin_params *p,
                       double *lambda2)
{
    coin_priv_body b;
    coin_priv_sc th;
    const int32_t status =
        lambda2 ? coin_priv_check_steady(s, p, &b, &th) : COIN_EARG;
    if (status == COIN_OK)
        *lambda2 = coin_priv_stability(s, &b, &th);
    return status;
}

double coin_critical_roll(const coin_params *p)
{
    coin_priv_body b;
    if (!p || coin_priv_check_body(&b, p) != COIN_OK)
        return NAN;
    return sqrt(b.Mga / b.K / b.k1); /* (45) */
}

double coin_critical_spin(const coin_params *p)
{
    coin_priv_body b;
    if (!p || coin_priv_check_body(&b, p) != COIN_OK)
        return NAN;
    return sqrt(b.GJ); /* (46) */
}
