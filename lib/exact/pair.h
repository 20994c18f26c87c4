/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_PAIR_H
#define ROLLCOIN_PAIR_H

#include "../motion/pinned.h"

/* Two numbers with the same operations.  gcc and clang compute both by one
 * instruction, to the same bits. */
#if defined(__GNUC__) && !defined(__TINYC__)
typedef double coin_priv_pair __attribute__((vector_size(16)));
#define COIN_PRIV_ELEMENT(pair, i) (pair)[i]
/* sum + a b. */
COIN_PRIV_INLINE coin_priv_pair coin_priv_pair_add_product(coin_priv_pair sum,
                                                           coin_priv_pair a,
                                                           coin_priv_pair b)
{
    return sum + a * b;
}
typedef double coin_priv_doubles
    __attribute__((vector_size(16), aligned(8), may_alias));
COIN_PRIV_INLINE coin_priv_pair coin_priv_pair_load(const double *from)
{
    return *(const coin_priv_doubles *)from;
}
#else
typedef struct coin_priv_pair {
    double v[2];
} coin_priv_pair;
#define COIN_PRIV_ELEMENT(pair, i) (pair).v[i]
COIN_PRIV_INLINE coin_priv_pair coin_priv_pair_add_product(coin_priv_pair sum,
                                                           coin_priv_pair a,
                                                           coin_priv_pair b)
{
    sum.v[0] = sum.v[0] + a.v[0] * b.v[0];
    sum.v[1] = sum.v[1] + a.v[1] * b.v[1];
    return sum;
}
static inline coin_priv_pair coin_priv_pair_load(const double *from)
{
    const coin_priv_pair p = {{from[0], from[1]}};
    return p;
}
#endif

COIN_PRIV_INLINE coin_priv_pair coin_priv_pair_make(double a, double b)
{
    coin_priv_pair p;
    COIN_PRIV_ELEMENT(p, 0) = a;
    COIN_PRIV_ELEMENT(p, 1) = b;
    return p;
}

COIN_PRIV_INLINE coin_priv_pair coin_priv_pair_both(double a)
{
    return coin_priv_pair_make(a, a);
}

#endif
