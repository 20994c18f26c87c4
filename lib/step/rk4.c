/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

/* By default gcc allocates registers loop by loop, and spills them between the
 * loops.  Renamed registers let the processor start the next stage sooner.
 * Scheduling before allocation lets the sine and cosine of the early turn,
 * rk4.t.h, start in time.  All three save 10 % of a step. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__)
#pragma GCC optimize("ira-region=all", "rename-registers", "schedule-insns",   \
                     "sched-pressure")
#endif

#include "loop.h"
#include "rk4.h"

COIN_PRIV_INLINE void step(coin_priv_step_end *end, coin_priv_variables *next,
                           const coin_priv_variables *y, const void *fields)
{
    const coin_priv_sc heading = {y->sph, y->cph};
    const coin_priv_sc lean =
        coin_priv_rk4_to(end, y, (const coin_priv_rk4_fields *)fields);
    *next = coin_priv_variables_at(end, lean,
                                   coin_priv_turned(heading, end->adds.phi));
}

void coin_priv_rk4(coin_priv_run *r, uint64_t n)
{
    const coin_priv_rk4_fields k = coin_priv_rk4_fields_of(&r->b, r->dt);
    coin_priv_steps(r, n, step, &k);
}
