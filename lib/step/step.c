/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

/* gcc would move the arithmetic of the step's end behind the branches that use
 * it. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__)
#pragma GCC optimize("no-tree-sink", "no-tree-pre")
#endif

#include "../motion/methods.h"
#include "../motion/state.h"

#include "rk4.h"

int32_t coin_step(coin_state *s, const coin_params *p, double dt)
{
    coin_priv_constants b;
    const int32_t status = coin_priv_check(s, p, &b);
    if (status != COIN_OK)
        return status;
    if (dt == 0)
        return COIN_OK;
    const coin_priv_variables y = coin_priv_variables_inline(s);
    coin_priv_limits limits = coin_priv_limits_of(&b, COIN_RK4, dt);
    if (COIN_PRIV_RARELY(!coin_priv_admit_start(&limits, &y)))
        /* So is every dt out of range. */
        return coin_priv_time_in_range(dt, &b) ? coin_priv_refusal(s, b.a)
                                               : COIN_ESTEP;
    const coin_priv_rk4_fields k = coin_priv_rk4_fields_of(&b, dt);
    coin_priv_step_end end;
    const coin_priv_sc lean = coin_priv_rk4_to(&end, &y, &k);
    const coin_priv_sc before = {y.sph, y.cph}; /* no check reads the heading */
    const coin_priv_variables next = coin_priv_variables_at(&end, lean, before);
    /* coin_run() adds all but theta to sums that begin at 0, so that -0
     * becomes 0.  The same here gives the same bits. */
    const coin_priv_pose none = {0, 0, 0, 0, 0, 0};
    const coin_priv_pose adds = coin_priv_pose_plus(&none, 1, &end.adds);
    const coin_state to = {
        coin_priv_lean_clamped(s->theta + end.adds.theta),
        s->phi + adds.phi,
        s->psi + adds.psi,
        s->x + b.a * adds.x,
        s->z + b.a * adds.z,
        end.wX,
        end.wY,
        end.wZ,
    };
    if (!coin_priv_admit_each(&limits, &end, &next))
        return coin_priv_refusal(s, b.a);
    if (!coin_priv_state_in_range(&to, &b))
        return COIN_ERANGE;
    *s = to;
    return (int32_t)(limits.coarse & COIN_COARSE);
}
