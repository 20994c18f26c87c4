/* SPDX-License-Identifier: MIT */
/* Several coins abreast, as many as a vector of the processor holds doubles. */
#ifndef ROLLCOIN_LANES_H
#define ROLLCOIN_LANES_H

#include "stepper.h"
#include "width.h"

#define COIN_PRIV_LANES (COIN_PRIV_WIDTH ? COIN_PRIV_WIDTH / 8 : 1)

/* n steps of dt of COIN_PRIV_LANES coins, without a guard: sound[k] says
 * whether each stage of coin k was above high[k], and NaN is not.  A coin of
 * which it was not stays where it is. */
typedef void coin_priv_abreast(coin_priv_moment *const *at, int *sound,
                               const double *high, const coin_priv_body *b,
                               double dt, uint64_t n);

/* That of a method, or null if there is none. */
coin_priv_abreast *coin_priv_method_abreast(int32_t method);

#endif
