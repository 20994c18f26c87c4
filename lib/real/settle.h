/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_SETTLE_H
#define ROLLCOIN_SETTLE_H

#include <coin.h>

/* settle.c: coin_settle() by at most *tries trials of steps, which are taken
 * from *tries. */
int32_t coin_priv_settle(coin_state *s, const coin_params *p,
                         const coin_losses *l, double t, double tol, int *tries,
                         double *reached);

#endif
