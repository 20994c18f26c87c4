/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_PROGRESS_H
#define ROLLCOIN_PROGRESS_H

#include "../motion/state.h"

#include "progress.t.h"

/* Steps of a block; blocks are counted from the start of a run, so that its
 * bits do not depend on where it is looked at. */
#define COIN_PRIV_BLOCK 64

/* The state that a run from *start has come to. */
COIN_PRIV_INLINE COIN(state)
    PRIV(state_of)(const PRIV(progress) * g, const COIN(state) * start, real a)
{
    const PRIV(pose) to = PRIV(pose_of)(g, a);
    const real most = COIN_PRIV_HALF_PI - COIN_PRIV_EPSILON;
    const COIN(state) s = {
        to.theta > most    ? most
        : to.theta < -most ? -most
                           : to.theta,
        to.phi,
        to.psi,
        start->x + to.x,
        start->z + to.z,
        g->y.wX,
        g->y.wY,
        g->y.wZ COIN_PRIV_NO_LOW,
    };
    return s;
}

#endif
