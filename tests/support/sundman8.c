/* SPDX-License-Identifier: MIT */
#include "sundman8.h"

#include "sundman.h"

/* h d/dtau of the pose and of the time. */
static coin_priv_pose pose_slopes(const coin_priv_field *f,
                                  const coin_priv_variables *y)
{
    const double hwY = f->h * y->wY, hc = f->h * y->cth, hcwZ = hc * y->wZ;
    coin_priv_pose d = {0};
    d.phi = hwY;
    d.psi = hcwZ + hwY * y->sth;
    coin_priv_path_rates(&d.x, &d.z, hc * (y->cth * y->wX), hcwZ, y);
    d.t = hc;
    return d;
}

#define SLOPES coin_priv_sundman_slopes
#define POSE_SLOPES pose_slopes
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
