/* SPDX-License-Identifier: MIT */
#include "sundman8.h"

#include "sundman.h"

#define SLOPES coin_priv_sundman_slopes
#define POSE_SLOPES coin_priv_sundman_pose_slopes
#define EACH_POSE(F) F(phi) F(psi) F(x) F(z) F(t)
#include "rk8.t.h"

int sundman8_step(coin_priv_run *r, double tau)
{
    const coin_priv_field f = coin_priv_field_of(&r->b, tau);
    coin_priv_variables y;
    coin_priv_pose adds;
    const double least = rk8_sums(&y, &adds, &r->g.y, &f);
    adds.theta = 0;
    if (!(least > 0 && y.cth > 0))
        return 0;
    coin_priv_normalize(&y);
    return coin_priv_sundman_accept(r, &y, &adds);
}
