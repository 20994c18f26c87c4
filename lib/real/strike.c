/* SPDX-License-Identifier: MIT */
/* A blow on a body, and which side of it is up. */
#include "../motion/pinned.h"

#include "../motion/equations.h"

#include "coin_body.h"

int32_t coin_body_strike(coin_body *b, const coin_params *p, const double J[3],
                         const double r[3])
{
    coin_body to;
    coin_priv_coin c;
    coin_priv_constants of;
    double R[9];
    const int32_t status =
        J && r ? coin_priv_check_coin_body(&c, b, p, &of) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    to = *b;
    const double torque[3] = {r[1] * J[2] - r[2] * J[1],
                              r[2] * J[0] - r[0] * J[2],
                              r[0] * J[1] - r[1] * J[0]};
    const coin_priv_variables y = coin_priv_variables_of(&b->s);
    coin_priv_axes(&y, R);
    const double inertia[3] = {of.IX, of.IX, of.IZ};
    double rates[3];
    for (int i = 0; i < 3; ++i)
        rates[i] = (R[3 * i] * torque[0] + R[3 * i + 1] * torque[1] +
                    R[3 * i + 2] * torque[2]) /
                   inertia[i]; /* (129) */
    to.s.wX += rates[0];
    to.s.wY += rates[1];
    to.s.wZ += rates[2];
    to.vx += J[0] / of.M; /* (129) */
    to.vy += J[1] / of.M;
    to.vz += J[2] / of.M;
    if (!coin_priv_body_in_range(&to, of.a, sqrt(of.g_a)))
        return COIN_ESTATE;
    *b = to;
    return COIN_OK;
}

int32_t coin_body_face(const coin_body *b, const coin_params *p)
{
    coin_priv_coin c;
    coin_priv_constants of;
    const int32_t status = coin_priv_check_coin_body(&c, b, p, &of);
    if (status != COIN_OK)
        return status;
    if (fabs(c.th.s) <= c.half * c.th.c) /* leans less than where it balances */
        return COIN_EDGE;
    return b->s.theta < 0 ? COIN_HEADS : COIN_TAILS;
}
