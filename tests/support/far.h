/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_TESTS_FAR_H
#define ROLLCOIN_TESTS_FAR_H

#include <coin.h>

/* A disc that rolls upright, just before x or z leaves its range: each step of
 * *dt moves it by half a radius, and after 11 it is still in range. */
coin_state far_coin(coin_params *p, double heading, double *dt);

#endif
