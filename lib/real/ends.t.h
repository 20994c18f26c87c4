/* SPDX-License-Identifier: MIT */
/* Numbers at the begin and at the end of a stretch of motion, side by side in a
 * vector, if the compiler has vectors.  Otherwise the code runs twice, once for
 * each end:
 *     for (int which = 0; which < 2; which += LANES)
 * where `which` is 0 for the begin, 1 for the end. */
#include "../motion/vector.h"

#if COIN_PRIV_WIDTH
#define LANES 2
#else
#define LANES 1
#endif
#include "../motion/vector.t.h"

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
