/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

/* gcc would move the arithmetic of the step's end behind the branches that use
 * it, which costs 10 % of a step; in vectors of four it saves 2 %.  Scheduling
 * before allocation saves 7 % of a step of a run (make bench).  Allocation of
 * the whole step as one region saves 2 % of its instructions. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__) &&         \
    defined(__x86_64__) && !defined(__AVX__)
#pragma GCC optimize("no-tree-sink", "no-tree-pre", "rename-registers",        \
                     "schedule-insns", "sched-pressure", "ira-region=one")
#endif

#include "../motion/vector.h"

/* The instructions of a call of one step nearly fill a processor's cache of
 * decoded instructions.  Without these two macros there are 3 % more, with gaps
 * between them, and a call takes 15 to 30 % longer at most addresses of the
 * code.  Compiled by clang, a call would take longer with them. */
#if COIN_PRIV_WIDTH && !defined(__clang__)
#define COIN_PRIV_TURN_BY_PAIRS
#define COIN_PRIV_BLOCKS_APART
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

COIN_PRIV_TOGETHER
void coin_priv_rk8(coin_priv_run *r, uint64_t n)
{
    const coin_priv_field f = coin_priv_field_of(&r->b, r->dt);
    coin_priv_steps(r, n, step, &f);
}
