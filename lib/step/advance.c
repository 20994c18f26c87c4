/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/rest.h"

#include "approach.h"
#include "extrapolation.h"

/* Natural units of time beyond which a step would change nothing of t. */
#define TOO_LONG 1e15

/* The most steps of a call: 0.2 s. */
#define STEPS_MAX (UINT64_C(1) << 20)

/* Moves *r until *rem, the time still to go, is short, or the coin is flat, or
 * a step fails or is one too many.  Each time that a step goes too far the next
 * may go only half as far: however bad the series, that ends. */
static int32_t approach(coin_priv_run *r, const coin_priv_reach *reach,
                        coin_priv_sum *rem)
{
    double stride = reach->stride;
    while (!(coin_priv_left2(r, rem->sum) <= reach->rk8 * reach->rk8)) {
        const double before = rem->sum;
        const double tau = coin_priv_next_tau(&r->b, &r->g.y, stride, before);
        if (r->g.y.cth < COIN_PRIV_FLAT)
            return COIN_EFLAT;
        if (r->steps == STEPS_MAX)
            return COIN_ESTEP;
        r->g.added.t = 0;
        if (!coin_priv_extrapolate(r, tau))
            return COIN_ESTEP;
        coin_priv_add(rem, -r->g.added.t);
        if ((rem->sum < 0) != (before < 0))
            stride /= 2;
    }
    return COIN_OK;
}

int32_t coin_advance(coin_state *s, const coin_params *p, double t, double tol,
                     double *reached)
{
    coin_priv_body b;
    int32_t status =
        tol >= 1e-13 && tol <= 1e-2 ? coin_priv_check(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    if (!(fabs(t) * sqrt(b.g_a) <= TOO_LONG))
        return COIN_ESTEP;
    if (t >= 0 && coin_priv_rests(s)) {
        if (reached)
            *reached = 0;
        return COIN_EFLAT;
    }
    coin_priv_run r;
    coin_priv_sum rem = {t, 0};
    const coin_priv_reach reach = coin_priv_reach_of(tol);
    r.b = b;
    coin_priv_run_from(&r, s, COIN_RK4, 0);
    r.limits.coarse2 = r.limits.most2 = (double)INFINITY;
    status = approach(&r, &reach, &rem);
    if (r.steps > 0)
        coin_priv_read_lean(&r.g);
    if (status == COIN_OK)
        status = coin_priv_land(&r, &reach, &rem);
    const coin_state end = coin_priv_run_state(&r);
    /* A path so long that x or z overflowed counts as none, as in a run. */
    const int lost = !coin_priv_pose_holds(&end);
    if (!lost)
        coin_priv_copy_state(s, &end);
    if (reached)
        *reached = lost ? 0 : t - rem.sum;
    return lost ? COIN_ESTEP : status;
}
