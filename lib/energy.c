/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "sincos.h"
#include "state.h"

#include <math.h>

double coin_energy(const coin_state *s, const coin_params *p)
{
    coin_priv_body b;
    if (coin_priv_check(s, p, &b) != COIN_OK)
        return NAN;
    const double wX = s->wX, wY = s->wY, wZ = s->wZ;
    const double cth = coin_priv_sincos(s->theta).c;
    /* J = I_X + M a^2 and K = I_Z + M a^2 gather the terms of the source. */
    const double T = 0.5 * (b.J * wX * wX + b.IX * wY * wY + b.K * wZ * wZ);
    return T + b.Mga * cth; /* (23) */
}
