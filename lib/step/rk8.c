/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

/* gcc would move the arithmetic of the step's end behind the branches that use
 * it, which costs 10 % of a step; in vectors of four it saves 2 %.  Scheduling
 * before allocation saves 7 % of a step of a run (make bench).  A spill slot
 * for each value saves 7 % of a run of one step, in the mean over eleven
 * addresses of the code. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__) &&         \
    defined(__x86_64__) && !defined(__AVX__)
#pragma GCC optimize("no-tree-sink", "no-tree-pre", "rename-registers",        \
                     "schedule-insns", "sched-pressure",                       \
                     "no-ira-share-spill-slots")
#endif

#include "loop.h"
#include "rk8.t.h"

COIN_PRIV_INLINE void step(coin_priv_step_end *end, coin_priv_variables *next,
                           const coin_priv_variables *y, const void *field)
{
    coin_priv_variables sums;
    end->least_cth =
        rk8_sums(&sums, &end->adds, y, (const coin_priv_field *)field);
    end->wX = sums.wX;
    end->wY = sums.wY;
    end->wZ = sums.wZ;
    *next = coin_priv_variables_after(y, end);
}

void coin_priv_rk8(coin_priv_run *r, uint64_t n)
{
    const coin_priv_field f = coin_priv_field_of(&r->b, r->dt);
    coin_priv_steps(r, n, step, &f);
}
