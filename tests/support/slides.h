/* SPDX-License-Identifier: MIT */
/* Coins that slip. */
#ifndef ROLLCOIN_TESTS_SLIDES_H
#define ROLLCOIN_TESTS_SLIDES_H

#include "random.h"

#include <coin.h>

/* A slide at phi whose centre moves by vX along e_X and vh along e_h. */
coin_slide slide_at(const coin_state *s, double vX, double vh);

/* A launch in natural units: |theta| < 1.4, rates to 1.5; half of them roll. */
coin_slide random_launch(struct random *r, const coin_params *p);

/* How far two slides are apart: states as states_apart(), velocities in
 * natural units. */
double slides_apart(const coin_slide *a, const coin_slide *b,
                    const coin_params *p);

/* Checks that a coin that rolls at first slips within t, by the energy that the
 * slip takes: more than a slip whose friction is mu_kinetic N must take after
 * the largest F/N of the motion that rolls. */
void check_slips(const coin_params *p, const coin_state *s,
                 const coin_friction *f, double t, double tol);

/* The speed of the slip. */
double slip_speed(const coin_slide *d, const coin_params *p);

#endif
