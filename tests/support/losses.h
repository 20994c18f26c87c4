/* SPDX-License-Identifier: MIT */
/* Coins with losses. */
#ifndef ROLLCOIN_TESTS_LOSSES_H
#define ROLLCOIN_TESTS_LOSSES_H

#include "random.h"
#include "table.h"

#include <coin.h>

/* A start of a disc whose contact never turns round: a spin with a nutation. */
extern const coin_state spun;

/* The losses that stop a coin, one at a time. */
enum { DRY, VISCOUS, LAYER, GAP, ROLLING, DAMPING, ANGULAR, LAWS };
extern const char *const loss_names[LAWS];
coin_losses one_loss(int law, double m);

/* A spin at an angle from flat, with the wX of the quasi-steady motion: the
 * losses hardly make it swing. */
coin_state slow_spin(const coin_params *p, const coin_losses *l, double angle);

/* Losses and state of natural units in others: mass M, length L, time T. */
coin_losses losses_in(const coin_losses *l, double M, double L, double T);
coin_state state_in(const coin_state *s, double L, double T);

/* Calls a check for each row of tests/reference/losses/NAME.csv, in natural
 * units and in those of a quarter: unit has the mass, the length and the time.
 * The note tells the row; `scene` is passed on. */
typedef void row_check(const void *scene, const struct table *t, size_t row,
                       const double unit[3]);
void check_losses_rows(const char *name, row_check *check_row,
                       const void *scene);

/* Some of the terms, each up to `most` in natural units, and not spin alone. */
coin_losses random_losses(struct random *r, const coin_params *p, double most);

/* coin_settle() for 1e6 natural units, down to the least `flat`. */
int32_t settle(coin_state *s, const coin_params *p, const coin_losses *l,
               double tol, double *when);

#endif
