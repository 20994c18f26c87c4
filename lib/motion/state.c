/* SPDX-License-Identifier: MIT */
#include "state.h"

int32_t coin_priv_check(const coin_state *s, const coin_params *p,
                        coin_priv_constants *b)
{
    return coin_priv_check_inline(s, p, b);
}

/* No step turns phi or psi by 16 rad, or moves the centre by 16 radii. */
int32_t coin_priv_refusal(const coin_state *s, number a)
{
    const number last = COIN_PRIV_ANGLE_MAX - 16;
    const number far = (COIN_PRIV_PLACE_MAX - 16) * a;
    const int at_edge = FABS(s->phi) > last || FABS(s->psi) > last ||
                        FABS(s->x) > far || FABS(s->z) > far;
    return at_edge ? COIN_ERANGE : COIN_ESTEP;
}

int32_t coin_state_check(const coin_state *s, const coin_params *p)
{
    coin_priv_constants b;
    if (!s || !p)
        return COIN_EARG;
    const int32_t status = coin_priv_check_thick(&b, p);
    return status != COIN_OK || coin_priv_state_in_range(s, &b) ? status
                                                                : COIN_ESTATE;
}
