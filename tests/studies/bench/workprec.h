/* SPDX-License-Identifier: MIT */
/* Work against precision: walks a solver down a ladder of steps or tolerances
 * on every scene and writes a line of CSV for each rung. */
#ifndef WORKPREC_H
#define WORKPREC_H

#include "scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One way to move a coin.  It holds one coin at a time. */
typedef struct solver {
    const char *name;
    int which;       /* for the solver's own use */
    double slopes;   /* right-hand sides per step; 0: it takes a tolerance */
    double first;    /* the ladder, from its coarsest rung, in natural */
    double factor;   /* units of time if it is of steps */
    double last;     /* to its finest */
    double patience; /* how long a run may take [ns] */
    int wraps;       /* phi and psi come without their whole turns */
    /* Puts the coin at the scene's start. */
    void (*begin)(const struct solver *self, const scene *c, double setting);
    /* Moves it by t, in the scene's unit, in so many steps if that is what the
     * setting means.  0, a warning > 0, or < 0: the solver says it failed. */
    int (*go)(double t, unsigned long steps);
    coin_state (*state)(void);
} solver;

/* main() of a program of solvers: argv[1] names the build, further arguments
 * choose scenes. */
int workprec(const solver *list, int count, int argc, char **argv);

#ifdef __cplusplus
}
#endif

#endif
