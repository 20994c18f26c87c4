/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_DOPRI8_H
#define ROLLCOIN_DOPRI8_H

#include "gbs.h"

/* The number of variables, and how many of them slopes may read: the first. */
#define COIN_PRIV_DOPRI8_SIZE 14
#define COIN_PRIV_DOPRI8_READ 9

/* The differences of the variables that are read from formulas of order 5 and
 * of order 3. */
typedef struct coin_priv_estimates {
    double by5[COIN_PRIV_DOPRI8_READ], by3[COIN_PRIV_DOPRI8_READ];
} coin_priv_estimates;

/* One step h of the formula of rk8.t.h, with its estimates, for any problem.
 * `slopes` computes the slopes of the variables; d are those of y, at the
 * start. */
void coin_priv_dopri8(double *y, const double *d,
                      coin_priv_right_hand_side *slopes, const void *problem,
                      double h, coin_priv_estimates *error);

#endif
