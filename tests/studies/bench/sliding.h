/* SPDX-License-Identifier: MIT */
/* A coin that slips, as others move it: friction regularised, or time stepped.
 * Natural units, M = a = g = 1; no sine in a step. */
#ifndef SLIDING_H
#define SLIDING_H

#include <coin.h>

/* The velocity of the centre is vX along e_X and vh along e_h = (sin phi, 0,
 * cos phi); sin and cos of theta and phi go with the angles. */
enum { WX, WY, WZ, VX, VH, STH, CTH, SPH, CPH, PHI, PSI, AT_X, AT_Z, SLIDING };

/* Friction is f(u/delta) N at a slip speed u: f rises to mu_s at 1 and falls to
 * mu_k, 2 s/(1 + s^2) times mu_s up to 1, and the square of that beyond. */
struct sliding {
    double IX, IZ, mu_s, mu_k, delta;
};

void sliding_start(double y[SLIDING], const coin_body *d);
coin_state sliding_state(const double y[SLIDING]);

/* Slopes by t, friction regularised. */
void sliding_slopes(double d[SLIDING], const double y[SLIDING],
                    const struct sliding *of);

/* So many steps of h by time stepping, of order 1: velocities without
 * friction, then the impulse that stops the slip, or as much of it as friction
 * gives, then the pose. */
void sliding_stepping(double y[SLIDING], const struct sliding *of, double h,
                      long steps);

#endif
