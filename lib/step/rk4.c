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

void coin_priv_rk4(coin_priv_run *r, uint64_t n)
{
    const coin_priv_rk4_fields k = coin_priv_rk4_fields_of(&r->b, r->dt);
    coin_priv_steps(r, n, coin_priv_rk4_step, &k);
}
