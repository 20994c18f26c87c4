/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_TESTS_VAST_H
#define ROLLCOIN_TESTS_VAST_H

#include <coin.h>

/* A coin so large that a few steps lead x and z out of the doubles: each step
 * of *dt is half a radius, 11 fit. */
coin_state vast_coin(coin_params *p, double heading, double *dt);

#endif
