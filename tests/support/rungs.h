/* SPDX-License-Identifier: MIT */
/* Random scenes, and the errors of each model (a rung) in them. */
#ifndef ROLLCOIN_TESTS_RUNGS_H
#define ROLLCOIN_TESTS_RUNGS_H

#include "random.h"

/* Kinds of scenes; distances, horizons and tolerances are log-uniform. */
enum {
    NEAR_STABLE,   /* 1e-10 to 0.1 off a stable steady motion */
    NEAR_UNSTABLE, /* as far off an unstable one */
    GENERIC,
    SEPARATRIX,  /* on its way from an unstable steady motion */
    NEARLY_FLAT, /* falls, with a spin of 1e-8 to 0.1 */
    KINDS_OF_SCENES,
    UNSTABLE = KINDS_OF_SCENES /* on an unstable circle, or up to 1e-6 off it,
                                  for as long as rounding takes to grow to the
                                  tolerance: not among the kinds */
};
extern const char *const kinds_of_scenes[KINDS_OF_SCENES];

struct rung_scene {
    coin_params params;
    coin_state start;
    double horizon, tol;
};

/* Horizons are 0.1 to longest natural units, tolerances 1e-7 to 0.1. */
struct rung_scene random_scene(struct random *r, int kind, double longest);

/* What coin_model_needed() returns for a scene, and the largest error of the
 * pose by each model at the times compared, against coin_advance() at 1e-13;
 * infinite if a model gives no state.  If wanted < 0, the errors are not set.
 */
struct rungs {
    int32_t wanted;
    double error[COIN_MODEL_STEPS]; /* of steady, wobble, orbit */
};
struct rungs climb(const struct rung_scene *scene, struct random *r, int looks);

/* The same against a motion in long double, for the model `named` and at
 * `looks` times. */
double named_error(const struct rung_scene *scene, int32_t named, int looks);

#endif
