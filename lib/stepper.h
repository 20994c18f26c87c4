/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_STEPPER_H
#define ROLLCOIN_STEPPER_H

#include "motion.h"

/* What a run carries from step to step.  The pairs hold the angles: theta, and
 * phi up to whole turns, which pose.phi counts; x, z and t begin at 0. */
typedef struct coin_priv_carry {
    coin_priv_stage y;
    coin_priv_pose pose;
    double theta, p; /* of the symplectic methods: theta, wY cos theta */
    uint64_t steps;  /* since the run began */
} coin_priv_carry;

coin_priv_carry coin_priv_carry_of(const coin_state *s);

/* Where a run from *start has come to.  A run of no steps is where it began,
 * to the bit. */
coin_state coin_priv_state_of(const coin_priv_carry *c, const coin_priv_body *b,
                              const coin_state *start);

/* phi from the pair that the steps turned; pose.phi is within half a turn of
 * it, and tells which. */
double coin_priv_heading(const coin_priv_carry *c);

/* How far a run may go: COIN_COARSE beyond coarse2, COIN_ESTEP beyond most2,
 * both compared with W^2, Eq. (47), where each step begins and ends. */
typedef struct coin_priv_limits {
    double coarse2, most2;
    int32_t warnings; /* COIN_COARSE once a step was */
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
