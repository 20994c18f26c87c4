/* SPDX-License-Identifier: MIT */
/* d/dt of anything along a motion, by differences: a route that knows none of
 * the formulas but the step. */
#ifndef ROLLCOIN_TESTS_DIFFERENCE_H
#define ROLLCOIN_TESTS_DIFFERENCE_H

#include "observable.h"

/* Central differences of order 6 over 3/256 natural units to either side.
 * With rates up to 2 and |theta| <= 1 in natural units the seventh derivative
 * is below 1e5, which leaves 1e-12; rounding leaves 1e-13 and the steps, 8
 * between two points, less. */
void difference_along(const coin_state *s, const coin_params *p,
                      values_of *values, size_t count,
                      double out[OBSERVABLE_MAX]);

/* Bound for the above, in natural units: 100 times what is expected. */
#define DIFFERENCE_BOUND 1e-10

#endif
