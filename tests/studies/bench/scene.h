/* SPDX-License-Identifier: MIT */
#ifndef SCENE_H
#define SCENE_H

#include <coin.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A scene of tests/reference: the start, and where the coin truly is later. */
typedef struct scene {
    const char *name;
    coin_params p;
    double unit; /* sqrt(a/g), the natural unit of time */
    int rows;
    struct scene_row {
        double t, amp; /* amp: how the motion has amplified rounding by t */
        coin_state s;
    } row[16]; /* row[0] is the start */
} scene;

/* The rows up to t = until, in the scene's units.  Exits if there is no such
 * scene. */
void scene_load(scene *c, const char *name, double until);

/* How far s is from the truth: the largest error of theta, phi, psi, x/a, z/a.
 * NaN if any is.  With wraps set phi and psi may be off by whole turns. */
double scene_error(const scene *c, const coin_state *s, const coin_state *truth,
                   int wraps);

/* The start in natural units, theta phi psi x z wX wY wZ, and back to the
 * scene's own: for solvers with absolute tolerances. */
void scene_to_natural(const scene *c, double y[8]);
coin_state scene_from_natural(const scene *c, const double y[8]);

#ifdef __cplusplus
}
#endif

#endif
