/* SPDX-License-Identifier: MIT */
/* Coins that slip. */
#ifndef ROLLCOIN_TESTS_SLIDES_H
#define ROLLCOIN_TESTS_SLIDES_H

#include "random.h"

#include <coin.h>

/* Calls on a body that touches the table, whatever its y and vy: these become
 * those of touching.  Losses may be null; they are put on the table.  A tol
 * below the least one becomes that. */
int32_t slide(coin_body *d, const coin_params *p, const coin_table *f,
              const coin_losses *l, double t, double tol, double *reached);
double slide_energy(const coin_body *d, const coin_params *p);
int32_t slide_velocity(const coin_body *d, const coin_params *p, double u[2]);
int32_t slide_reaction(const coin_body *d, const coin_params *p,
                       const coin_table *f, const coin_losses *l,
                       coin_force *out);

/* A body at phi whose centre moves by vX along e_X and vh along e_h. */
coin_body slide_at(const coin_state *s, double vX, double vh);

/* A launch in natural units: |theta| < 1.4, rates to 1.5; half of them roll. */
coin_body random_launch(struct random *r, const coin_params *p);

/* How far two bodies are apart: states as states_apart(), velocities in
 * natural units. */
double slides_apart(const coin_body *a, const coin_body *b,
                    const coin_params *p);

/* Whether a coin that rolls at first slips within t, by the energy that the
 * slip takes: more than a slip whose friction is mu_kinetic N must take after
 * the largest F/N of the motion that rolls.  1 if it lifts off. */
int slips_as_it_must(const coin_params *p, const coin_state *s,
                     const coin_table *f, double t, double tol);

/* The speed of the slip. */
double slip_speed(const coin_body *d, const coin_params *p);

#endif
