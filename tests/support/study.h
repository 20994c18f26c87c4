/* SPDX-License-Identifier: MIT */
/* Random runs of every method, from states and with steps of every kind. */
#ifndef ROLLCOIN_TESTS_STUDY_H
#define ROLLCOIN_TESTS_STUDY_H

#include <coin.h>

enum study_family {
    STUDY_GENERIC,
    STUDY_NEARFLAT, /* dropped with little spin or none: passes and falls */
    STUDY_UNSTABLE, /* rolling or spinning upright about the critical rate */
    STUDY_STEADY,   /* circles and spins, nudged */
    STUDY_FAST,     /* up to a thousand radians per natural unit */
    STUDY_FAMILIES
};
extern const char *const study_families[STUDY_FAMILIES];

enum study_method {
    STUDY_RK4 = COIN_RK4,
    STUDY_RK8 = COIN_RK8,
    STUDY_SYMPLECTIC2 = COIN_SYMPLECTIC2,
    STUDY_SYMPLECTIC4 = COIN_SYMPLECTIC4,
    STUDY_ADVANCE,
    STUDY_METHODS
};
extern const char *const study_methods[STUDY_METHODS];

struct study_run {
    enum study_family family;
    enum study_method method;
    coin_params p;
    coin_state s;
    double dt, tol; /* tol: of coin_advance(), over dt * steps */
    uint64_t steps;
};

/* One of the runs.  |dt| is between 1e-6 and 10 natural units.  A run
 * has at most most_steps steps, and turns the coin by at most most_turn
 * radians. */
struct study_run study_draw(uint64_t seed, uint64_t which, double most_steps,
                            double most_turn);

#endif
