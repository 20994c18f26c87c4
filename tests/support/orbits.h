/* SPDX-License-Identifier: MIT */
/* Orbits that there are. */
#ifndef ROLLCOIN_TESTS_ORBITS_H
#define ROLLCOIN_TESTS_ORBITS_H

#include "random.h"

coin_orbit orbit_of(const coin_state *s, const coin_params *p);

/* A random coin that has one: one in a hundred comes too near to flat. */
coin_orbit random_orbit(struct random *r, coin_params *p, coin_state *s);

#endif
