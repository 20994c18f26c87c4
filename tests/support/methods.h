/* SPDX-License-Identifier: MIT */
/* Any method along a named scene, held against its reference. */
#ifndef ROLLCOIN_TESTS_METHODS_H
#define ROLLCOIN_TESTS_METHODS_H

#include "scene.h"

enum { METHODS = 4 };

/* The row of time t, or the last row if t is infinite. */
size_t scene_row(const struct scene *scene, double t);

/* How far a run of so many equal steps to a row ends from it; infinite if a
 * step is refused. */
double method_error(const struct scene *scene, int32_t method, size_t row,
                    uint64_t steps);

/* How far coin_advance() in one call ends from a row; infinite if it fails. */
double advance_error(const struct scene *scene, size_t row, double tol);

/* log2 of the error of so many steps over that of twice as many. */
double measured_order(const struct scene *scene, int32_t method, size_t row,
                      uint64_t steps);

/* How far the poses of two states are apart: of the angles, and of x and z in
 * radii, the largest difference. */
double path_apart(const coin_state *a, const coin_state *b,
                  const coin_params *p);

/* And of the whole states: of the rates, in natural units, too. */
double states_apart(const coin_state *a, const coin_state *b,
                    const coin_params *p);

#endif
