/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_GBS_H
#define ROLLCOIN_GBS_H

#include "../motion/number.h"

#include <stddef.h>

/* The most variables. */
#define COIN_PRIV_GBS_MOST 8

/* d/dx of the n variables y of a problem. */
typedef void PRIV(gbs_slopes)(real *dy, const real *y, const void *problem);

/* One step h of the modified midpoint rule, extrapolated (Gragg, Bulirsch and
 * Stoer); n <= COIN_PRIV_GBS_MOST.  Returns the largest difference to the order
 * that is less by 2, relative where a variable is above 1; NaN where slopes
 * are. */
real PRIV(gbs)(real *y, size_t n, PRIV(gbs_slopes) * slopes,
               const void *problem, real h);

#endif
