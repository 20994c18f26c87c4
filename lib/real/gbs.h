/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_GBS_H
#define ROLLCOIN_GBS_H

#include <stddef.h>

/* The most variables. */
#define COIN_PRIV_GBS_MOST 8

/* d/dx of the n variables y of a problem. */
typedef void coin_priv_slopes(double *dy, const double *y, const void *problem);

/* One step h of the modified midpoint rule, extrapolated to order 14 (Gragg,
 * Bulirsch and Stoer); n <= COIN_PRIV_GBS_MOST.  Returns the largest
 * difference to order 12, relative where a variable is above 1; NaN where
 * slopes are. */
double coin_priv_gbs(double *y, size_t n, coin_priv_slopes *slopes,
                     const void *problem, double h);

#endif
