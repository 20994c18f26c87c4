/* SPDX-License-Identifier: MIT */
#include "../motion/angles.h"
#include "../motion/state.h"

real COIN(energy)(const COIN(state) * s, const COIN(params) * p)
{
    PRIV(body) b;
    if (PRIV(check_inline)(s, p, &b) != COIN_OK)
        return NAN;
    const real wX = s->wX, wY = s->wY, wZ = s->wZ;
    const real cth = PRIV(sine_cosine)(s->theta).c;
    /* J = I_X + M a^2 and K = I_Z + M a^2 include the motion of the centre. */
    const real T = K(0.5) * (b.J * wX * wX + b.IX * wY * wY + b.K * wZ * wZ);
    return T + b.Mga * cth; /* (23) */
}
