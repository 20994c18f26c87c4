/* SPDX-License-Identifier: MIT */
/* Coins that many tests use. */
#ifndef ROLLCOIN_TESTS_COINS_H
#define ROLLCOIN_TESTS_COINS_H

#include "table.h"

#include <coin.h>

/* Mass, radius and gravity 1. */
coin_params disc(void);
coin_params ring(double inner);

/* The state of a coin on a steady circle. */
coin_state circle(const coin_params *p, double theta, double wZ,
                  int32_t branch);

/* The eight columns of a row that are named as the members of a state. */
coin_state state_in_row(const struct table *t, size_t row);

/* The columns theta0, wX0, wY0, wZ0 of a row, pose 0. */
coin_state start_in_row(const struct table *t, size_t row);

/* W of Eq. (47), by libm. */
double fastest_rate(const coin_state *s, const coin_params *p);

/* The largest W from this state to a time t later or, if t < 0, before. */
double fastest_ahead(const coin_state *s, const coin_params *p, double t);

#endif
