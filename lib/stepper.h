/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_STEPPER_H
#define ROLLCOIN_STEPPER_H

#include "stage.h"

/* A sum and what its rounding left out. */
typedef struct coin_priv_sum {
    double sum, low;
} coin_priv_sum;

/* A run under way.  What a few steps added to psi, x and z is in the pose, the
 * rest in sums: a steady motion adds the same again and again, and to a long
 * sum it would always round alike. */
typedef struct coin_priv_carry {
    coin_priv_moment at;
    coin_priv_sum psi, x, z; /* x, z: contact less starting centre, in radii */
    uint64_t steps;          /* since the run began */
} coin_priv_carry;

/* A run from a state on. */
void coin_priv_carry_begin(coin_priv_carry *c, const coin_state *s);

/* Where a run from *start has come to.  A run of no steps is where it began,
 * to the bit. */
coin_state coin_priv_state_of(const coin_priv_carry *c, const coin_priv_body *b,
                              const coin_state *start);

/* theta of its pair: below pi/2 for cos theta > 0, however small. */
double coin_priv_lean(double sth, double cth);

/* phi of its pair in *y, of whose values phi is within half a turn. */
double coin_priv_heading(const coin_priv_stage *y, double phi);

/* Adds a part, by Knuth's exact sum. */
static inline void coin_priv_add(coin_priv_sum *to, double part)
{
    const double y = part + to->low, sum = to->sum + y;
    const double of_y = sum - to->sum;
    to->low = (to->sum - (sum - of_y)) + (y - of_y);
    to->sum = sum;
}

/* A sum with a part that is not in it yet. */
static inline double coin_priv_total(coin_priv_sum so_far, double part)
{
    coin_priv_add(&so_far, part);
    return so_far.sum;
}

/* To be done every COIN_PRIV_SETTLE steps, counted from the start of the run,
 * so that its bits do not depend on where it is looked at: adds the pose of
 * *at to the sums of *c, and sets pose.phi to its pair's angle.  In so few
 * steps the sum of phi's rates, and the pair that the same rates turn, cannot
 * come half a turn apart: RK4 turns a pair by z - z^5/120 for z, and no step
 * has z > 1.2. */
#define COIN_PRIV_SETTLE 64
void coin_priv_settle(coin_priv_carry *c, coin_priv_moment *at);

/* How far a run may go: COIN_COARSE beyond coarse2, COIN_ESTEP beyond most2,
 * both compared with W^2, Eq. (47), where each step begins and ends. */
typedef struct coin_priv_limits {
    double coarse2, most2; /* coarse2 <= most2 */
    int32_t warnings;      /* COIN_COARSE once a step was */
} coin_priv_limits;

/* Up to n steps of dt.  It ends early where a step would not be sound, and *c
 * is then as the last good step left it.  Pre: *c is sound. */
typedef void coin_priv_stepper(coin_priv_carry *c, const coin_priv_body *b,
                               coin_priv_limits *limits, double dt, uint64_t n);

coin_priv_stepper coin_priv_rk4, coin_priv_rk8;
coin_priv_stepper coin_priv_symplectic2, coin_priv_symplectic4;

/* The same for who asks for no path: heading and pose stay as they are. */
coin_priv_stepper coin_priv_rk4_lean, coin_priv_rk8_lean;

#endif
