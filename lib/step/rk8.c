/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

/* gcc would move the arithmetic of the step's end behind the branches that use
 * it, which is slower but in vectors of four.  The other options schedule
 * before allocation, and allocate the whole step as one region. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__) &&         \
    defined(__x86_64__) && !defined(__AVX__)
#pragma GCC optimize("no-tree-sink", "no-tree-pre", "rename-registers",        \
                     "schedule-insns", "sched-pressure", "ira-region=one")
#endif

#include "../motion/vector.h"

/* The instructions of a call of one step nearly fill a processor's cache of
 * decoded instructions.  Without this macro there are more, with gaps between
 * them.  Compiled by clang, a call would take longer with it. */
#if COIN_PRIV_WIDTH && !defined(__clang__)
#define COIN_PRIV_TURN_BY_PAIRS
#endif

#include "rk8.h"
#include "rk8.t.h"

void coin_priv_rk8(coin_priv_run *r, uint64_t n)
{
    const coin_priv_field f = coin_priv_field_of(&r->b, r->dt);
    coin_priv_steps(r, n, coin_priv_rk8_step, &f);
}
