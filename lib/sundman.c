/* SPDX-License-Identifier: MIT */
#include "pinned.h"

/* gcc 12 tuned for newer processors spills vectors through integer registers,
 * a fifth of a step's time; tuned for this one it does not. */
#if defined(__AVX512F__) && defined(__GNUC__) && !defined(__clang__)
#pragma GCC target("tune=icelake-server")
#endif

#define FIELD coin_priv_sundman
#define DRIFT coin_priv_sundman_drift
#define EACH_POSE(F) F(phi) F(psi) F(x) F(z) F(t)
#include "dop8.h"
#include "march.h"
#include "sundman.h"

#include <math.h>

/* The rate at which things change in tau.  The weights of wY and wZ follow
 * Eq. (44), the coin's own frequency, and make the error of a step of given
 * length most nearly the same for every motion.  For bodies with I_Z far below
 * I_X that frequency is low, and the slope of wX, Eq. (14), decides: without it
 * they erred by 1e5 tol.  For rings it never does. */
static double sundman_rate(const coin_priv_body *b, const coin_priv_stage *y)
{
    const double wX = y->wX, wY = y->wY, cwZ = y->cth * y->wZ;
    const double rate2 = wX * wX + 1.5 * (wY * wY) +
                         b->KJ * b->k1 * (cwZ * cwZ) + y->cth * b->g_a;
    const double slope2 = 3 * b->KJ * fabs(wY * cwZ);
    return sqrt(slope2 > rate2 ? slope2 : rate2);
}

double coin_priv_sundman_tau(const coin_priv_body *b, const coin_priv_stage *y,
                             double stride)
{
    return stride / sundman_rate(b, y);
}

int coin_priv_sundman_step(coin_priv_carry *c, const coin_priv_body *b,
                           double tau)
{
    const coin_priv_field f = coin_priv_field_of(b, tau);
    coin_priv_moment next;
    coin_priv_copy(&next, &c->at, sizeof next);
    const double lowest = dop8_step(&next, &c->at, &f);
    if (!(lowest > 0 && next.y.cth > 0) ||
        !coin_priv_angles_hold(&next, c->psi.sum, 0))
        return 0;
    if (++c->steps % COIN_PRIV_SETTLE == 0)
        coin_priv_settle(c, &next);
    coin_priv_copy(&c->at, &next, sizeof next);
    return 1;
}
