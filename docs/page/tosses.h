/* SPDX-License-Identifier: MIT */
/* tosses.h: scenes of the page beyond those of scenes.h: real coins that come
 * to rest, by pivoting friction too. */
#ifndef ROLLCOIN_TOSSES_H
#define ROLLCOIN_TOSSES_H

#include "../examples/scenes.h"

/* A scene of the page.  y > 0: the coin is thrown from there.  The losses are
 * in natural units; mu is infinite for an ideal coin. */
typedef struct staged {
    scene scene;
    double y, vx, vy, vz;
    double mu, restitution, dry, spin;
    double thickness; /* 0: thin to the library; drawn it always is */
} staged;

#define QUARTER_THICKNESS 0.00175 /* m */

static const body EULERS_DISK = {&SI, 0.4387, 0.03755, 0, 9.80665};

/* The last lean that the library takes, with heads up. */
#define HEADS_UP -1.5707963267948963

/* clang-format off */
static const staged TOSSES[] = {
    {{"toss", &QUARTER, {1.15, 0.3, 0, -0.02, 0, 47, 2, 3}, 1e-3, 3,
      "A US quarter is tossed: it flies, bounces, rolls and lies down"},
     0.05, 0.08, 2.1, -0.03, 0.3, 0.45, 2e-3, 1e-3, QUARTER_THICKNESS},
    {{"disk", &EULERS_DISK, {1.32, 0, 0, 0, 0, 0, 16.1, 0}, 1e-3, 60,
      "Euler's disk: the lower it sinks, the faster it whirls"},
     0, 0, 0, 0, 0.5, 0.3, 1.6e-4, 2e-6, 0},
    {{"whirl", &QUARTER, {0.1, 0, 0, 0, 0, 0, 55, 0}, 1e-3, 12,
      "A US quarter, spun on its edge, whirls ever lower and comes to rest"},
     0, 0, 0, 0, 0.3, 0.45, 1.1e-3, 1.5e-3, QUARTER_THICKNESS},
    {{"edge", &QUARTER, {0.16, 0, 0, 0, 0, 0, 2, 26}, 1e-3, 12,
      "A US quarter rolls on its edge, turns ever tighter and lies down"},
     0, 0, 0, 0, 0.3, 0.45, 3e-3, 1e-4, QUARTER_THICKNESS},
    {{"luck", &QUARTER, {HEADS_UP, 0, 0, 0, 0, 100, 0, 0}, 1e-3, 3,
      "How a US quarter ends that is let go heads up and spinning"},
     0.12, 0, 0, 0, 0.33, 0.5, 2e-3, 1e-3, QUARTER_THICKNESS},
};
/* clang-format on */

enum { TOSS_COUNT = sizeof TOSSES / sizeof TOSSES[0] };

#endif
