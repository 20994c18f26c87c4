/* SPDX-License-Identifier: MIT */
#include "state.h"

int32_t PRIV(check)(const COIN(state) * s, const COIN(params) * p,
                    PRIV(body) * b)
{
    return PRIV(check_inline)(s, p, b);
}

/* No step turns phi or psi by 16 rad, or moves the centre by 16 radii. */
int32_t PRIV(refusal)(const COIN(state) * s, real a)
{
    const real last = COIN_PRIV_ANGLE_MAX - 16;
    const real far = (COIN_PRIV_PLACE_MAX - 16) * a;
    const int at_edge = FABS(s->phi) > last || FABS(s->psi) > last ||
                        FABS(s->x) > far || FABS(s->z) > far;
    return at_edge ? COIN_ERANGE : COIN_ESTEP;
}

int32_t COIN(state_check)(const COIN(state) * s, const COIN(params) * p)
{
    PRIV(body) b;
    return PRIV(check)(s, p, &b);
}
