/* SPDX-License-Identifier: MIT */
/* The named scenes of tests/reference: NAME.csv holds a trajectory. */
#ifndef ROLLCOIN_TESTS_SCENE_H
#define ROLLCOIN_TESTS_SCENE_H

#include "table.h"

#include <coin.h>

struct scene {
    const char *name;
    coin_params params;
    double inertia_error; /* of params against the file's, in u: 0 if exact */
    struct table rows;
};

enum { SCENES = 12 };
extern const char *const scene_names[SCENES];

void scene_load(struct scene *scene, const char *name);

double scene_at(const struct scene *scene, size_t row, const char *column);

/* Row 0 is exact; the others are the reference rounded to double. */
coin_state scene_state(const struct scene *scene, size_t row);

/* Runs a coin by RK4 from row 0 to the time of a row. */
coin_state scene_run(const struct scene *scene, size_t row, uint64_t steps);

/* The distance of a state from a row: the largest difference of the angles, and
 * of x and z in radii. */
double scene_error(const struct scene *scene, size_t row, const coin_state *s);

#endif
