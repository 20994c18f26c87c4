/* SPDX-License-Identifier: MIT */
/* LANES numbers of type double side by side, in a file that defines LANES
 * first: at most COIN_PRIV_LANES, 1 for a plain number.  Each gets the bits
 * that it would get alone. */
#include "vector.h"

#if LANES > 1
typedef double lanes COIN_PRIV_VECTOR(8 * LANES);
typedef double in_memory
    __attribute__((vector_size(8 * LANES), aligned(8), may_alias));
#else
typedef double lanes;
typedef double in_memory;
#endif

/* make msan defines it: the memory sanitizer sees no arithmetic. */
#ifndef COIN_PRIV_READS
#define COIN_PRIV_READS(from, bytes) ((void)0)
#endif

COIN_PRIV_INLINE lanes load(const double *from)
{
    COIN_PRIV_READS(from, sizeof(lanes));
    return *(const in_memory *)from;
}

COIN_PRIV_INLINE void store(double *to, lanes value)
{
    *(in_memory *)to = value;
}
