/* SPDX-License-Identifier: MIT */
/* d/dt of any values along a motion, by differences.  It uses the step, but no
 * other formula of the library. */
#ifndef ROLLCOIN_TESTS_DIFFERENCE_H
#define ROLLCOIN_TESTS_DIFFERENCE_H

#include "observable.h"

/* Central differences of order 6 over 3/256 natural units to either side.
 * With rates up to 2 and |theta| <= 1 in natural units the seventh derivative
 * is below 1e5, which gives an error of 1e-12.  Rounding gives 1e-13, and the
 * steps, 8 between two points, less. */
void difference_along(const coin_state *s, const coin_params *p,
                      values_of *values, size_t count,
                      double out[OBSERVABLE_MAX]);

/* Bound for the above, in natural units: 100 times what is expected. */
#define DIFFERENCE_BOUND 1e-10

#endif
