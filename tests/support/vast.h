/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_TESTS_VAST_H
#define ROLLCOIN_TESTS_VAST_H

#include <coin.h>

/* A coin so large that x and z overflow after a few steps: each step of *dt
 * moves it by half a radius, and after 11 it is still in range. */
coin_state vast_coin(coin_params *p, double heading, double *dt);

#endif
