/* SPDX-License-Identifier: MIT */
/* The processor's vectors, where the compiler has arithmetic for them. */
#ifndef ROLLCOIN_VECTOR_H
#define ROLLCOIN_VECTOR_H

#include "pinned.h"

#include <stdint.h>

/* Bytes of the processor's vectors, 0 if it has none. */
#if !defined(__GNUC__) || defined(__TINYC__)
#define COIN_PRIV_WIDTH 0
#elif defined(__AVX512F__)
#define COIN_PRIV_WIDTH 64
#elif defined(__AVX__)
#define COIN_PRIV_WIDTH 32
#elif defined(__SSE2__) || defined(__aarch64__) || defined(__VSX__)
#define COIN_PRIV_WIDTH 16
#else
#define COIN_PRIV_WIDTH 0
#endif

/* Doubles that a vector holds, 1 if there are none. */
#define COIN_PRIV_LANES (COIN_PRIV_WIDTH ? COIN_PRIV_WIDTH / 8 : 1)

#if COIN_PRIV_WIDTH
#define COIN_PRIV_VECTOR(bytes) __attribute__((vector_size(bytes)))
typedef double coin_pair COIN_PRIV_VECTOR(16);
typedef int64_t coin_pair_integer COIN_PRIV_VECTOR(16);
COIN_PRIV_INLINE coin_pair coin_pair_of(double a, double b)
{
    const coin_pair both = {a, b};
    return both;
}
/* (-s, c): the pair (c, s) after a right angle. */
COIN_PRIV_INLINE coin_pair coin_pair_normal(double s, double c)
{
    const coin_pair_integer sign = {INT64_MIN, 0};
    return (coin_pair)((coin_pair_integer)coin_pair_of(s, c) ^ sign);
}
typedef double coin_lanes COIN_PRIV_VECTOR(COIN_PRIV_WIDTH);
typedef int64_t coin_lanes_integer COIN_PRIV_VECTOR(COIN_PRIV_WIDTH);
#endif

#endif
