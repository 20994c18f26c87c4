/* SPDX-License-Identifier: MIT */
/* A coin in the air and at an impact.
 *
 * All is in natural units, in which M = a = g = 1.  A coin_body is given in
 * them, and IX, IZ are I_X/(M a^2), I_Z/(M a^2). */
#ifndef ROLLCOIN_AIR_H
#define ROLLCOIN_AIR_H

#include "../motion/equations.h"
#include "../motion/state.h"

/* The sines and cosines of a coin's lean and heading. */
typedef struct coin_priv_attitude {
    coin_priv_sc th, ph;
} coin_priv_attitude;

coin_priv_attitude coin_priv_attitude_of(const coin_state *s);

/* What axes and velocities of a state with this attitude are computed from. */
coin_priv_variables coin_priv_attitude_variables(const coin_state *s,
                                                 const coin_priv_attitude *at);

/* A flight from a body: a free symmetric top, which turns about its axis at the
 * rate sigma while the axis turns about k. */
typedef struct coin_priv_flight {
    coin_priv_attitude at; /* of the start */
    double kX, kY, kZ;     /* a unit vector along the axes at the start */
    double rate;           /* of the precession about k */
    double sigma;          /* the rate about e_Z besides it */
    double y, vy;          /* of the centre at the start */
} coin_priv_flight;

void coin_priv_flight_of(coin_priv_flight *f, const coin_body *b,
                         const coin_priv_attitude *at, double IX, double IZ);

/* Moves the body that the flight begins with by t, and sets its attitude.  phi
 * and psi come to lie in [-pi, pi], to rounding.  Accuracy: 1e-15 (1 + (rate +
 * |sigma|) t) (test_flight), also where that angle is so large that nothing is
 * left of it: it is reduced to its rounding. */
void coin_priv_fly(coin_body *b, coin_priv_attitude *at,
                   const coin_priv_flight *f, double t);

/* What a search for a touch comes to. */
typedef struct coin_priv_touch {
    double t;    /* of the touch; else there is none up to here */
    int touches; /* whether it touches */
    int looks;   /* how often the gap has been computed */
} coin_priv_touch;

/* The first touch within t.  leaves: the lowest point of the rim is on the
 * table and moves up.  A search that is long ends before t. */
coin_priv_touch coin_priv_first_touch(const coin_priv_flight *f, double t,
                                      int leaves);

/* The velocity of the lowest point of the rim along e_X, e_h and e_y. */
typedef struct coin_priv_rim {
    double X, h, y;
} coin_priv_rim;

coin_priv_rim coin_priv_rim_of(const coin_body *b,
                               const coin_priv_attitude *at);

/* What the table does to a coin that hits it. */
typedef struct coin_priv_bounce {
    double restitution, mu_static, mu_kinetic;
} coin_priv_bounce;

/* The impact of a body that touches and whose lowest point moves down. */
void coin_priv_impact(coin_body *b, const coin_priv_attitude *at, double IX,
                      double IZ, const coin_priv_bounce *law);

#endif
