/* SPDX-License-Identifier: MIT */
/* Bodies in the air, in natural units. */
#ifndef ROLLCOIN_TESTS_THROWN_H
#define ROLLCOIN_TESTS_THROWN_H

#include "random.h"
#include "table.h"

#include <coin_body.h>

enum { BODY_NUMBERS = 12 };

/* M = a = g = 1. */
coin_params thrown_params(double IX, double IZ);

/* A body in natural units as a coin under way, and back. */
coin_priv_coin coin_of(const coin_body *b, double half);
coin_body body_of(const coin_priv_coin *c);

/* The columns theta ... wZ, y, vx, vy, vz of a row, with a suffix. */
coin_body body_in_row(const struct table *t, size_t row, const char *suffix);

/* The largest difference of their numbers; phi and psi up to whole turns. */
double bodies_apart(const coin_body *a, const coin_body *b);

/* A disc, a ring or any body with I_Z <= 2 I_X. */
coin_params random_body(struct random *r);

/* A cylinder with M = a = g = 1, half of it `half` thick. */
coin_params cylinder(double half);

/* A cylinder of any thickness with half of it from low to high. */
coin_params random_cylinder(struct random *r, double low, double high);

/* A body on the table, which rolls, in natural units. */
coin_body rolling(const coin_state *s, const coin_params *p);

/* In the air: the lowest point 0 to `high` above the table, spins up to
 * `spin`; of a thin coin. */
coin_body random_throw(struct random *r, double high, double spin);

/* The same of a coin with a thickness. */
coin_body random_toss(struct random *r, const coin_params *p, double high,
                      double spin);

/* A table with friction, restitution and losses of a real coin. */
coin_table random_table(struct random *r, const coin_params *p);

/* How high the lowest point is, by the C library's cosine; the second of a coin
 * with a thickness. */
double gap(const coin_body *b);
double rim_gap(const coin_body *b, const coin_params *p);

#endif
