/* SPDX-License-Identifier: MIT */
/* Orbits that there are. */
#ifndef ROLLCOIN_TESTS_ORBITS_H
#define ROLLCOIN_TESTS_ORBITS_H

#include "random.h"
#include "table.h"

coin_orbit orbit_of(const coin_state *s, const coin_params *p);

/* A random coin that has one, as nearly all have. */
coin_orbit random_orbit(struct random *r, coin_params *p, coin_state *s);

/* The columns theta0, wX0, wY0, wZ0 of a row, pose 0. */
coin_state start_in_row(const struct table *t, size_t row);

/* By how much coin_orbit_at() says that an angle at t may be off, of a motion
 * that is W at its fastest. */
double orbit_error(const coin_orbit *o, double t, double W);

/* Whether its pose at t is so near to a wanted one: the path as many times less
 * near as the annulus has radii, and one more. */
void check_pose(const coin_orbit *o, double t, double W, const coin_state *want,
                const coin_params *p);

#endif
