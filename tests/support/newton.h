/* SPDX-License-Identifier: MIT */
/* A coin with Coulomb's friction, by Newton's and Euler's laws in the table's
 * frame.
 *
 * The forces are solutions of linear equations whose coefficients are these
 * laws evaluated, so that no formula of docs/physics.md beyond the angles of a
 * state is used, and none of lib/.  Steps are of RK4. */
#ifndef ROLLCOIN_TESTS_NEWTON_H
#define ROLLCOIN_TESTS_NEWTON_H

#include <coin.h>

/* How a motion ends: it rolls or slips at the end of the time; it lifts off; it
 * is nearly flat; or it takes too many steps. */
enum { NEWTON_ROLLS, NEWTON_SLIPS, NEWTON_LIFTS, NEWTON_FLAT, NEWTON_COSTLY };

/* Moves a slide by t.  M = a = g = 1.  A step is h of the time in which the
 * motion changes.  A slip should begin with little acceleration; the error is
 * at least of the second order in h.  *reached is the time at which the motion
 * ends. */
int newton(coin_body *d, const coin_params *p, const coin_table *f, double t,
           double h, double *reached);

#endif
