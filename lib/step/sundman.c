/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

/* gcc 12 tuned for newer processors spills vectors through integer registers,
 * a fifth of a step's time; tuned for this one it does not. */
#if defined(__AVX512F__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC target("tune=icelake-server")
#endif

#include "sundman.h"

#define RATES coin_priv_sundman_rates
#define POSE_RATES coin_priv_sundman_pose_rates
#define EACH_POSE(F) F(phi) F(psi) F(x) F(z) F(t)
#include "rk8.t.h"

/* The weights of wY and wZ follow Eq. (44), the coin's own frequency, and make
 * the error of a step of given length most nearly the same for every motion.
 * For bodies with I_Z far below I_X that frequency is low, and the slope of wX,
 * Eq. (14), decides: without it they erred by 1e5 tol.  For rings it never
 * does. */
double coin_priv_sundman_tau(const coin_priv_body *b,
                             const coin_priv_variables *y, double stride)
{
    const double wX = y->wX, wY = y->wY, cwZ = y->cth * y->wZ;
    const double rate2 = wX * wX + 1.5 * (wY * wY) +
                         b->KJ * b->k1 * (cwZ * cwZ) + y->cth * b->g_a;
    const double slope2 = 3 * b->KJ * fabs(wY * cwZ);
    return stride / sqrt(slope2 > rate2 ? slope2 : rate2);
}

int coin_priv_sundman_accept(coin_priv_run *r, const coin_priv_variables *y,
                             const coin_priv_pose *adds)
{
    coin_priv_progress *const g = &r->g;
    coin_priv_pose added = coin_priv_pose_plus(&g->added, 1, adds);
    added.t = g->added.t + adds->t;
    if (!coin_priv_angles_hold(g, &added, 0))
        return 0;
    g->y = *y;
    g->added = added;
    if (++r->steps % COIN_PRIV_BLOCK == 0) {
        coin_priv_add_block(g);
        const coin_priv_sc ph = coin_priv_angle_pair(g->phi);
        g->y.sph = ph.s;
        g->y.cph = ph.c;
    }
    return 1;
}

int coin_priv_sundman_step(coin_priv_run *r, double tau)
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

void coin_priv_read_lean(coin_priv_progress *g)
{
    const coin_priv_sc th = {g->y.sth, g->y.cth};
    const coin_priv_sum theta = {coin_priv_angle(th), 0};
    g->theta = theta;
    g->added.theta = 0;
}
