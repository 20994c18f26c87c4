/* SPDX-License-Identifier: MIT */
/* Any method along a named scene, compared with its reference. */
#ifndef ROLLCOIN_TESTS_METHODS_H
#define ROLLCOIN_TESTS_METHODS_H

#include "scene.h"

enum { METHODS = 4 };

/* The row of time t, or the last row if t is infinite. */
size_t scene_row(const struct scene *scene, double t);

/* The distance from a row of the end of a run that has `steps` equal steps to
 * its time; infinite if a step is refused. */
double method_error(const struct scene *scene, int32_t method, size_t row,
                    uint64_t steps);

/* The distance from a row of the end of one coin_advance(); infinite if that
 * fails. */
double advance_error(const struct scene *scene, size_t row, double tol);

/* log2 of the error with `steps` steps over that with twice as many. */
double measured_order(const struct scene *scene, int32_t method, size_t row,
                      uint64_t steps);

/* The distance of the poses of two states: the largest difference of the
 * angles, and of x and z in radii. */
double path_apart(const coin_state *a, const coin_state *b,
                  const coin_params *p);

/* The same with the rates, in natural units. */
double states_apart(const coin_state *a, const coin_state *b,
                    const coin_params *p);

#endif
