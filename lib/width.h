/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_WIDTH_H
#define ROLLCOIN_WIDTH_H

/* Bytes of the processor's vectors, 0 if it has none or the compiler cannot
 * write them as arithmetic. */
#if !defined(__GNUC__) || defined(__TINYC__) || defined(double)
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

#endif
