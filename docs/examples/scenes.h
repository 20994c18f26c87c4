/* SPDX-License-Identifier: MIT */
/* scenes.h: coins worth watching, each with the step that suits it. */
#ifndef EXAMPLE_SCENES_H
#define EXAMPLE_SCENES_H

#include <coin.h>
#include <stddef.h>

/* What a scene is measured in. */
typedef struct units {
    const char *given;         /* its numbers */
    const char *time, *length; /* what the reader sees */
    double shown;              /* how many of `length` in a unit of length */
} units;

static const units SI = {"in kg, m and s", "s", "cm", 100};

/* Mass, radius and gravity are 1: lengths are in radii, and a unit of time is
 * sqrt(radius/gravity). */
static const units NATURAL = {"in natural units", "sqrt(a/g)", "radii", 1};

typedef struct body {
    const units *in;
    double mass, radius, inner_radius, gravity;
} body;

static const body QUARTER = {&SI, 0.00567, 0.01213, 0, 9.80665};
static const body DISC = {&NATURAL, 1, 1, 0, 1};
static const body RING = {&NATURAL, 1, 1, 0.9, 1};
static const body HOOP = {&NATURAL, 1, 1, 1, 1};

typedef struct scene {
    const char *name;
    const body *body;
    coin_state start;
    double dt, duration;
    const char *story;
} scene;

/* Starts are theta, phi, psi, x, z, wX, wY, wZ. */
/* clang-format off */
static const scene SCENES[] = {
    {"quarter", &QUARTER, {0.3, 0, 0, 0, 0, 0, 5, 40}, 1e-3, 1.5,
     "A US quarter rolls round a circle, nodding as it goes"},
    {"flick", &QUARTER, {0.5, 0, 0, 0, 0, 10, 25, 30}, 5e-4, 2.5,
     "A US quarter, flicked sideways, weaves round a circle"},
    {"wobble", &DISC, {0.1, 0, 0, 0, 0, 0, 0, 1}, 0.02, 60,
     "Fast and almost upright, a coin sways along a wide circle"},
    {"generic", &DISC, {0.5, 0, 0, 0, 0, 0.1, 0.8, 1.2}, 0.02, 45,
     "A coin swings from one side through upright to the other"},
    {"circle", &DISC, {0.4, 0, 0, 0, 0, 0, 0.2550291587475191, 1}, 0.02, 20,
     "A steady circle: the lean never changes"},
    {"spin", &DISC, {0.6, 0, 0, 0, 0, 0, 1.8169596747420438, 0}, 0.02, 8,
     "A leaning coin spins, its centre at rest"},
    {"euler", &DISC, {1.45, 0, 0, 0, 0, 0, 0.8, 0}, 5e-3, 10,
     "Low and whirling: Euler's disk, if nothing slowed it down"},
    {"tumble", &DISC, {1e-3, 0, 0, 0, 0, 0, 0, 0.3}, 0.01, 48,
     "Too slow to stay up: it falls, turns round and gets up again"},
    {"nearflat", &DISC, {0.3, 0, 0, 0, 0, 0, 0.02, 0.02}, 1e-3, 10,
     "It falls almost flat, whirls round and gets up again"},
    {"ring", &RING, {0.5, 0, 0, 0, 0, 0.1, 0.8, 1.2}, 0.02, 60,
     "A ring with the start of generic takes a wider circle"},
    {"hoop", &HOOP, {0.2, 0, 0, 0, 0, -0.3, -0.5, 0.9}, 0.02, 60,
     "A hoop draws a flower on the table"},
    {"rosette", &QUARTER, {0.6, 0, 0, 0, -0.031196545458305875, 0,
      20.5578897295768, 20.160842194583619}, 1e-3, 2.3190176257309107,
     "A US quarter rolls a rosette that closes after seven swings"},
};
/* clang-format on */

enum { SCENE_COUNT = sizeof SCENES / sizeof SCENES[0] };

#endif
