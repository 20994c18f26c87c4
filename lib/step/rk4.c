/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

/* With ira-loop-pressure gcc counts the registers that the loop needs before it
 * moves anything out of it.  Renamed registers let the processor start the next
 * stage sooner.  Scheduling before allocation lets the sine and cosine of the
 * early turn, rk4.t.h, start in time.  Measured: options in
 * tests/studies/tables.md, as those of other files. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__)
#pragma GCC optimize("ira-loop-pressure", "rename-registers",                  \
                     "schedule-insns", "sched-pressure")
#endif

#include "rk4.h"

void coin_priv_rk4(coin_priv_run *r, uint64_t n)
{
    const coin_priv_rk4_fields k = coin_priv_rk4_fields_of(&r->b, r->dt);
    coin_priv_steps(r, n, coin_priv_rk4_step, &k);
}
