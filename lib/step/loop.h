/* SPDX-License-Identifier: MIT */
/* A run of one coin by steps of a fixed dt. */
#ifndef ROLLCOIN_LOOP_H
#define ROLLCOIN_LOOP_H

#include "../motion/methods.h"
#include "../motion/state.h"

#include "progress.t.h"

/* A run by steps of dt. */
typedef struct coin_priv_run {
    coin_state start;
    coin_priv_body b;
    coin_priv_limits limits;
    double dt;
    coin_priv_progress g;
    uint64_t steps; /* done so far */
} coin_priv_run;

/* A run from *s by steps of dt; r->b is the body. */
void coin_priv_run_from(coin_priv_run *r, const coin_state *s, int32_t method,
                        double dt);

/* A run from *s by steps whose lengths are chosen one by one: r->dt is 0. */
void coin_priv_run_unlimited(coin_priv_run *r, const coin_state *s);

/* The state that a run from *start has come to. */
COIN_PRIV_INLINE coin_state coin_priv_state_of(const coin_priv_progress *g,
                                               const coin_state *start,
                                               double a)
{
    const coin_priv_pose to = coin_priv_pose_of(g, a);
    const coin_state s = {
        coin_priv_lean_within(to.theta),
        to.phi,
        to.psi,
        start->x + to.x,
        start->z + to.z,
        g->y.wX,
        g->y.wY,
        g->y.wZ,
    };
    return s;
}

/* Up to n steps of a run.  It ends early where a step is refused, and is then
 * as the last step left it. */
COIN_PRIV_INLINE void coin_priv_steps(coin_priv_run *r, uint64_t n,
                                      coin_priv_step *step,
                                      const void *coefficients)
{
    const uint64_t end = r->steps + n;
    int64_t sound = coin_priv_admit_start(&r->limits, &r->g.y);
    while (sound && r->steps < end)
        sound = coin_priv_block(&r->g, &r->limits, &r->steps, end - r->steps,
                                step, coefficients);
}

/* Up to n steps by each method. */
typedef void coin_priv_method(coin_priv_run *r, uint64_t n);
coin_priv_method coin_priv_rk4, coin_priv_rk8;
coin_priv_method coin_priv_symplectic2, coin_priv_symplectic4;

#endif
