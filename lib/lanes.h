/* SPDX-License-Identifier: MIT */
/* Several coins abreast, as many as a vector of the processor holds doubles. */
#ifndef ROLLCOIN_LANES_H
#define ROLLCOIN_LANES_H

#include "stepper.h"

#if !defined(__GNUC__) || defined(__TINYC__) || defined(double)
#define COIN_PRIV_LANES 1
#elif defined(__AVX512F__)
#define COIN_PRIV_LANES 8
#elif defined(__AVX__)
#define COIN_PRIV_LANES 4
#elif defined(__SSE2__) || defined(__aarch64__) || defined(__VSX__)
#define COIN_PRIV_LANES 2
#else
#define COIN_PRIV_LANES 1
#endif

/* n steps of dt of COIN_PRIV_LANES coins, without a guard: sound[k] says
 * whether each stage of coin k was above high[k], and NaN is not. */
typedef void coin_priv_abreast(coin_priv_moment *at, int *sound,
                               const double *high, const coin_priv_body *b,
                               double dt, uint64_t n);

/* That of a method, or null if there is none. */
coin_priv_abreast *coin_priv_method_abreast(int32_t method);

#endif
