/* SPDX-License-Identifier: MIT */
#include "../motion/equations.h"
#include "../motion/state.h"

int32_t coin_state_from_landing(coin_state *s, const coin_params *p,
                                const double q[4], const double omega[3],
                                const double v[3], double x, double z)
{
    coin_state made;
    int32_t status =
        s && v ? coin_state_from_motion(&made, p, q, omega, x, z) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const coin_priv_body b = coin_priv_body_of(p);
    double R[9];
    const coin_priv_variables y = coin_priv_variables_of(&made);
    coin_priv_axes(&y, R);
    const double vX = v[0] * R[0] + v[1] * R[1] + v[2] * R[2];
    const double vZ = v[0] * R[6] + v[1] * R[7] + v[2] * R[8];
    made.wX += b.m / b.J * (vZ / b.a - made.wX); /* (91) */
    made.wZ -= b.k2 * (vX / b.a + made.wZ);      /* (91) */
    status = coin_state_check(&made, p);
    if (status == COIN_OK)
        *s = made;
    return status;
}
