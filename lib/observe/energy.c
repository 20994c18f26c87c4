/* SPDX-License-Identifier: MIT */
#include "../motion/angles.h"
#include "../motion/state.h"

number coin_energy(const coin_state *s, const coin_params *p)
{
    coin_priv_constants b;
    if (coin_priv_check_inline(s, p, &b) != COIN_OK)
        return NAN;
    const number wX = s->wX, wY = s->wY, wZ = s->wZ;
    const number cth = coin_priv_sine_cosine(s->theta).c;
    /* J = I_X + M a^2 and K = I_Z + M a^2 include the motion of the centre. */
    const number T = K(0.5) * (b.J * wX * wX + b.IX * wY * wY + b.K * wZ * wZ);
    return T + b.Mga * cth; /* (23) */
}
