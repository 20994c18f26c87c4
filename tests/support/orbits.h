/* SPDX-License-Identifier: MIT */
/* Orbits, of coins that have one. */
#ifndef ROLLCOIN_TESTS_ORBITS_H
#define ROLLCOIN_TESTS_ORBITS_H

#include "random.h"
#include "table.h"

/* The scene of a row of orbits.csv. */
const char *far_scene(const struct table *t, size_t row);

coin_orbit orbit_of(const coin_state *s, const coin_params *p);

/* The orbit of a random coin, which is drawn again if it has none. */
coin_orbit random_orbit(struct random *r, coin_params *p, coin_state *s);

/* The error of an angle at t that the docstring of coin_orbit_at() admits, for
 * a motion whose largest W this is. */
double orbit_error(const coin_orbit *o, double t, double W);

/* Checks that the pose at t is within that error of the pose wanted.  For the
 * path the error is 1 plus the annulus' radius, in radii of the coin, times as
 * large. */
void check_pose(const coin_orbit *o, double t, double W, const coin_state *want,
                const coin_params *p);

#endif
