/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

/* With this pragma gcc schedules instructions before it allocates registers,
 * which RK4 gains from, and renames them after, which RK8 does. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__)
#pragma GCC optimize("schedule-insns", "sched-pressure", "rename-registers")
#endif

#include "coin_run.h"
#include "lanes.h"

#if COIN_PRIV_WIDTH

#define COIN_PRIV_ABREAST
#include "../motion/number.t.h"

#include "../motion/angles.t.h"

#include "../motion/equations.t.h"

#include "../motion/methods.t.h"

#include "progress.t.h"

#include "rk4.t.h"
#include "rk8.t.h"
#undef COIN_PRIV_ABREAST
#include "../motion/kind.h"

/* A vector with x in every lane.  A difference: 0 + x would turn -0 into 0. */
COIN_PRIV_INLINE coin_lanes all(double x)
{
    const coin_lanes none = {0};
    return x - none;
}

COIN_PRIV_INLINE coin_lanes_field field_of(const coin_priv_constants *b,
                                           double h)
{
    const coin_priv_field f = coin_priv_field_of(b, h);
    const coin_lanes_field of_all = {
        all(f.h), all(f.GJ), all(f.KJ), all(f.XJ), all(f.k1), all(f.k2),
    };
    return of_all;
}

/* What the coins of a batch share. */
struct shared {
    const coin_priv_constants *b;
    coin_priv_limits limits;
    double dt;
    uint64_t steps;
    int32_t method;
    coin_lanes_rk4_fields fields; /* fields.full is RK8's */
};

/* A group of coins side by side. */
struct group {
    coin_lanes_progress g;
    coin_lanes_limits limits;
    uint64_t steps; /* done so far */
};

enum { THETA, PHI, PSI, X, Z, WX, WY, WZ };

/* A member of all states.  Not an array of vectors: a wide load would wait for
 * narrow stores to the same place. */
COIN_PRIV_INLINE coin_lanes member(const coin_state *const *from, int i)
{
    coin_lanes of_all = {0};
    for (int k = 0; k < COIN_PRIV_LANES; ++k)
        of_all[k] = ((const double *)from[k])[i];
    return of_all;
}

/* Puts coins into lanes. */
COIN_PRIV_INLINE void gather(struct group *c, const coin_state *const *from,
                             const struct shared *shared)
{
    const coin_lanes_limits limits = {
        all(shared->limits.g_a),
        all(shared->limits.coarse2),
        all(shared->limits.most2),
        all(shared->b->a),
        member(from, X),
        member(from, Z),
        {0},
    };
    const coin_lanes theta = member(from, THETA), phi = member(from, PHI);
    const coin_lanes_sc th = coin_lanes_sine_cosine(theta);
    const coin_lanes_sc ph = coin_lanes_sine_cosine(phi);
    const coin_lanes q = 1 / th.c;
    const coin_lanes_variables y = {
        member(from, WX),
        member(from, WY),
        member(from, WZ),
        th.s,
        th.c,
        q,
        q * th.s,
        ph.s,
        ph.c,
    };
    coin_lanes_progress_begin(&c->g, &y, theta, phi, member(from, PSI));
    c->limits = limits;
    c->steps = 0;
}

/* Steps side by side until all are done, or the next one is refused for one of
 * the coins. */
COIN_PRIV_INLINE void run_group(struct group *c, const struct shared *shared,
                                coin_lanes_step *step, const void *coefficients)
{
    coin_lanes_integer sound = coin_lanes_admit_start(&c->limits, &c->g.y);
    while (coin_lanes_every(sound != 0) && c->steps < shared->steps)
        sound = coin_lanes_block(&c->g, &c->limits, &c->steps,
                                 shared->steps - c->steps, step, coefficients);
}

/* A function for each method, with registers of its own. */
COIN_PRIV_NOINLINE void rk4(struct group *c, const struct shared *shared)
{
    run_group(c, shared, coin_lanes_rk4_step, &shared->fields);
}

COIN_PRIV_NOINLINE void rk8(struct group *c, const struct shared *shared)
{
    run_group(c, shared, coin_lanes_rk8_step, &shared->fields.full);
}

/* Completes the run of lane k outside the lanes, from where its coin is. */
COIN_PRIV_NOINLINE int32_t complete(const struct group *c, size_t k,
                                    const struct shared *shared, coin_state *s)
{
    enum { NUMBERS = sizeof(coin_priv_progress) / sizeof(double) };
    const coin_lanes *const lanes = (const coin_lanes *)&c->g;
    coin_priv_run r;
    coin_priv_copy_state(&r.start, s);
    r.b = *shared->b;
    r.limits = shared->limits;
    r.limits.x = s->x;
    r.limits.z = s->z;
    r.limits.coarse = c->limits.coarse[k];
    r.dt = shared->dt;
    r.steps = c->steps;
    for (int i = 0; i < NUMBERS; ++i)
        ((double *)&r.g)[i] = lanes[i][k];
    return coin_priv_run_to_end(&r, shared->method, shared->steps, s, NULL);
}

/* Writes the state that lane k has come to, if it is in range. */
COIN_PRIV_INLINE int store(coin_state *s, const coin_lanes *members, size_t k,
                           const coin_priv_constants *b)
{
    coin_state end;
    for (int i = 0; i < 8; ++i)
        ((double *)&end)[i] = members[i][k];
    if (!coin_priv_state_in_range(&end, b))
        return 0;
    coin_priv_copy_state(s, &end);
    return 1;
}

/* Runs the coins of one group, the first of which is the i-th of the batch.  In
 * the lane of one that is no state, and in an empty one, a coin stands upright
 * at rest: a step that is too long for it is too long for every coin. */
static void run(coin_priv_batch *batch, size_t i, const struct shared *shared)
{
    static const coin_state standing = {0, 0, 0, 0, 0, 0, 0, 0};
    const coin_state *from[COIN_PRIV_LANES];
    coin_state *const s = &batch->s[i];
    const size_t left = batch->count - i;
    struct group c;
    int coins = 0;
    for (size_t k = 0; k < COIN_PRIV_LANES; ++k) {
        const int runs = k < left && coin_priv_state_in_range(&s[k], shared->b);
        from[k] = runs ? &s[k] : &standing;
        coins += runs;
    }
    gather(&c, from, shared);
    if (coins > 0 && shared->method == COIN_RK4)
        rk4(&c, shared);
    else if (coins > 0)
        rk8(&c, shared);
    const coin_lanes_pose to = coin_lanes_pose_of(&c.g, all(shared->b->a));
    const coin_lanes members[8] = {
        to.theta,          to.phi,   to.psi,   c.limits.x + to.x,
        c.limits.z + to.z, c.g.y.wX, c.g.y.wY, c.g.y.wZ,
    };
    const int done = c.steps == shared->steps;
    for (size_t k = 0; k < COIN_PRIV_LANES && k < left; ++k) {
        int32_t status = (int32_t)(c.limits.coarse[k] & COIN_COARSE);
        if (from[k] == &standing)
            status = COIN_ESTATE;
        else if (!done || !store(&s[k], members, k, shared->b))
            status = complete(&c, k, shared, &s[k]);
        coin_priv_note(batch, i + k, status);
    }
}

int coin_priv_run_abreast(coin_priv_batch *batch, const coin_priv_constants *b,
                          int32_t method, double dt, uint64_t steps)
{
    const struct shared shared = {
        b,      coin_priv_limits_of(b, method, dt),
        dt,     steps,
        method, {field_of(b, dt / 2), field_of(b, dt), field_of(b, dt / 6)},
    };
    if (method != COIN_RK4 && method != COIN_RK8)
        return 0;
    for (size_t i = 0; i < batch->count; i += COIN_PRIV_LANES)
        run(batch, i, &shared);
    return 1;
}

#else

int coin_priv_run_abreast(coin_priv_batch *batch, const coin_priv_constants *b,
                          int32_t method, double dt, uint64_t steps)
{
    (void)batch, (void)b, (void)method, (void)dt, (void)steps;
    return 0;
}

#endif
