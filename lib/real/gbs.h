/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_GBS_H
#define ROLLCOIN_GBS_H

#include "../motion/number.h"

#include <stddef.h>

/* The most variables. */
#define COIN_PRIV_GBS_MOST 8

/* The right-hand side of a problem's equations: d/dx of its variables y. */
typedef void PRIV(right_hand_side)(real *dy, const real *y,
                                   const void *problem);

/* One step h of the modified midpoint rule, extrapolated (Gragg, Bulirsch and
 * Stoer); n <= COIN_PRIV_GBS_MOST.  Returns an estimate of the error: the
 * largest difference from the result whose order is lower by 2, relative for
 * variables above 1; NaN if all slopes are NaN. */
real PRIV(gbs)(real *y, size_t n, PRIV(right_hand_side) * slopes,
               const void *problem, real h);

#endif
