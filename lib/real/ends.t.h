/* SPDX-License-Identifier: MIT */
/* A number at the begin of a stretch of motion and one at its end, side by side
 * in a vector where there is one.  Else they take turns: which of them is meant
 * is then 0 or 1, counted by EACH_END. */
#include "../motion/vector.h"

#if COIN_PRIV_WIDTH
#define LANES 2
#else
#define LANES 1
#endif
#include "../motion/lanes.t.h"

#define EACH_END(which) (int which = 0; which < 2; which += LANES)

COIN_PRIV_INLINE lanes at_ends(double begin, double end, int which)
{
#if LANES > 1
    const lanes both = {begin, end};
    (void)which;
    return both;
#else
    return which ? end : begin;
#endif
}
