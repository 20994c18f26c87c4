/* SPDX-License-Identifier: MIT */
/* Bodies in the air, in natural units. */
#ifndef ROLLCOIN_TESTS_THROWN_H
#define ROLLCOIN_TESTS_THROWN_H

#include "random.h"
#include "table.h"

#include <coin.h>

enum { BODY_NUMBERS = 12 };

/* M = a = g = 1. */
coin_params thrown_params(double IX, double IZ);

/* The columns theta ... wZ, y, vx, vy, vz of a row, with a suffix. */
coin_body body_in_row(const struct table *t, size_t row, const char *suffix);

/* The largest difference of their numbers; phi and psi up to whole turns. */
double bodies_apart(const coin_body *a, const coin_body *b);

/* A disc, a ring or any body with I_Z <= 2 I_X. */
coin_params random_body(struct random *r);

/* In the air: the lowest point 0 to `high` above the table, spins up to
 * `spin`. */
coin_body random_throw(struct random *r, double high, double spin);

/* A table with friction, restitution and losses of a real coin. */
coin_table random_table(struct random *r, const coin_params *p);

/* How high the lowest point is, by the C library's cosine. */
double gap(const coin_body *b);

#endif
