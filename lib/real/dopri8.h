/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_DOPRI8_H
#define ROLLCOIN_DOPRI8_H

#include "gbs.h"

/* The most variables. */
#define COIN_PRIV_DOPRI8_MOST 14

/* The estimates of the error of each variable, of order 5 and of order 3. */
typedef struct coin_priv_estimates {
    double by5[COIN_PRIV_DOPRI8_MOST], by3[COIN_PRIV_DOPRI8_MOST];
} coin_priv_estimates;

/* One step h of the formula of rk8.t.h, for n <= COIN_PRIV_DOPRI8_MOST
 * variables y of any problem, from the slopes d of y. */
void coin_priv_dopri8(double *y, const double *d, size_t n,
                      coin_priv_gbs_slopes *slopes, const void *problem,
                      double h, coin_priv_estimates *error);

#endif
