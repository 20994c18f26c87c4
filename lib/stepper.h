/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_STEPPER_H
#define ROLLCOIN_STEPPER_H

#include "motion.h"

#include <math.h>

/* What a run carries from step to step.  The pairs hold the angles: theta, and
 * phi up to whole turns, which pose.phi counts; x and z begin at 0. */
typedef struct coin_priv_carry {
    coin_priv_stage y;
    coin_priv_pose pose;
} coin_priv_carry;

/* How far a run may go: COIN_COARSE beyond coarse2, COIN_ESTEP beyond most2,
 * both compared with W^2, Eq. (47), where each step begins and ends. */
typedef struct coin_priv_limits {
    double coarse2, most2;
    int32_t warnings; /* COIN_COARSE once a step was */
} coin_priv_limits;

/* Whether a step may end here: above the table all the way (lowest is the
 * least cos theta of its stages), in the range of coin_state_check(), W within
 * the limit.  Any NaN fails: comparisons choose it, phi's reaches psi. */
static inline int coin_priv_sound(const coin_priv_carry *c, double lowest,
                                  double rate2, double most2)
{
    const double phi = fabs(c->pose.phi), psi = fabs(c->pose.psi);
    const double low = lowest < c->y.cth ? lowest : c->y.cth;
    const double angle = phi > psi ? phi : psi;
    return low > 0 && rate2 <= most2 && angle <= COIN_PRIV_ANGLE_MAX;
}

/* Up to n steps of dt; returns how many were done.  After fewer than n *c is
 * as the last good step left it.  Pre: *c is sound. */
typedef uint64_t coin_priv_stepper(coin_priv_carry *c, const coin_priv_body *b,
                                   coin_priv_limits *limits, double dt,
                                   uint64_t n);

coin_priv_stepper coin_priv_rk4;

#endif
