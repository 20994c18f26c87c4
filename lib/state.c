/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "sincos.h"
#include "state.h"

#include <math.h>

int32_t coin_priv_check_members(const coin_state *s)
{
    /* x - x is 0 for finite x only, and a comparison with NaN is false. */
    const int good = fabs(s->theta) < COIN_PRIV_HALF_PI &&
                     fabs(s->phi) <= COIN_PRIV_ANGLE_MAX &&
                     fabs(s->psi) <= COIN_PRIV_ANGLE_MAX && s->x - s->x == 0 &&
                     s->z - s->z == 0 && s->wX - s->wX == 0 &&
                     s->wY - s->wY == 0 && s->wZ - s->wZ == 0 &&
                     COIN_PRIV_LOW_HOLDS(s);
    return good ? COIN_OK : COIN_ESTATE;
}

int32_t coin_priv_check_state(const coin_state *s, const coin_priv_body *b)
{
    const double w2 = s->wX * s->wX + s->wY * s->wY + s->wZ * s->wZ;
    return w2 <= b->w2_max ? coin_priv_check_members(s) : COIN_ESTATE;
}

int32_t coin_priv_check(const coin_state *s, const coin_params *p,
                        coin_priv_body *b)
{
    if (!s || !p)
        return COIN_EARG;
    if (coin_priv_body_of(b, p) != COIN_OK)
        return COIN_EPARAMS;
    return coin_priv_check_state(s, b);
}

int32_t coin_state_check(const coin_state *s, const coin_params *p)
{
    coin_priv_body b;
    return coin_priv_check(s, p, &b);
}
