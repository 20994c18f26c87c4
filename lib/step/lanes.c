/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

/* With this pragma gcc schedules instructions before it allocates registers,
 * and renames them after.  RK4 is 4 to 6 % faster by the one, RK8 7 % by the
 * other, with the same bits. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__)
#pragma GCC optimize("schedule-insns", "sched-pressure", "rename-registers")
#endif

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

typedef coin_lanes_integer mask;

/* A vector with x in every lane.  A difference: 0 + x would turn -0 into 0. */
COIN_PRIV_INLINE coin_lanes all(double x)
{
    const coin_lanes none = {0};
    return x - none;
}

COIN_PRIV_INLINE coin_lanes_field field_of(const coin_priv_body *b, double h)
{
    const coin_priv_field f = coin_priv_field_of(b, h);
    const coin_lanes_field of_all = {
        all(f.h), all(f.GJ), all(f.KJ), all(f.XJ), all(f.k1), all(f.k2),
    };
    return of_all;
}

/* What the coins of a batch share. */
struct shared {
    const coin_priv_body *b;
    coin_priv_limits limits;
    double dt;
    uint64_t steps;
    int32_t method;
};

/* A group of coins side by side. */
struct group {
    coin_state *coin[COIN_PRIV_LANES]; /* null where the lane is empty */
    int32_t status[COIN_PRIV_LANES];   /* where the coin has left its lane */
    int size;                          /* coins in lanes */
    coin_lanes_progress g;
    coin_lanes_limits limits;
    uint64_t steps; /* done so far */
};

/* Fewer coins than this go one by one, which takes less time. */
enum { ENOUGH = (COIN_PRIV_LANES + 2) / 4 + 1 };

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

/* Puts the next coins into lanes, but for those that are no state.  In an empty
 * lane a coin stands upright at rest: a step that is too long for it is too
 * long for every coin. */
COIN_PRIV_INLINE void gather(struct group *c, coin_state *s, size_t left,
                             const struct shared *shared)
{
    static const coin_state standing = {0, 0, 0, 0, 0, 0, 0, 0};
    const coin_state *from[COIN_PRIV_LANES];
    c->size = 0;
    for (size_t k = 0; k < COIN_PRIV_LANES; ++k) {
        const int runs = k < left && coin_priv_state_holds(&s[k], shared->b);
        c->coin[k] = runs ? &s[k] : NULL;
        from[k] = runs ? &s[k] : &standing;
        c->status[k] = COIN_ESTATE;
        c->size += runs;
    }
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

/* The coin of lane k completes its run by itself, from where it is, and leaves
 * its lane empty. */
static void leave(struct group *c, int k, const struct shared *shared)
{
    enum { NUMBERS = sizeof(coin_priv_progress) / sizeof(double) };
    const coin_priv_variables upright = {0, 0, 0, 0, 1, 1, 0, 0, 1};
    coin_lanes *const lanes = (coin_lanes *)&c->g;
    coin_state *const s = c->coin[k];
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
    c->status[k] =
        coin_priv_run_to_end(&r, shared->method, shared->steps, s, NULL);
    coin_priv_progress_begin(&r.g, &upright, 0, 0, 0);
    for (int i = 0; i < NUMBERS; ++i)
        lanes[i][k] = ((const double *)&r.g)[i];
    c->limits.coarse[k] = 0;
    c->coin[k] = NULL;
    --c->size;
}

/* The coins leave whose lanes are 0 in `stay`. */
static void keep(struct group *c, mask stay, const struct shared *shared)
{
    for (int k = 0; k < COIN_PRIV_LANES; ++k)
        if (c->coin[k] && !stay[k])
            leave(c, k, shared);
}

/* Writes the states at the end.  A coin with a rate out of range, or whose lean
 * is rounded to flat, leaves instead. */
static void store(struct group *c, const struct shared *shared)
{
    const coin_lanes_pose to = coin_lanes_pose_of(&c->g, all(shared->b->a));
    const coin_lanes s[8] = {
        to.theta,           to.phi,    to.psi,    c->limits.x + to.x,
        c->limits.z + to.z, c->g.y.wX, c->g.y.wY, c->g.y.wZ,
    };
    keep(c,
         (coin_lanes_magnitude(s[THETA]) < COIN_PRIV_HALF_PI) &
             (s[WX] * s[WX] <= shared->b->w2_max) &
             (s[WY] * s[WY] <= shared->b->w2_max) &
             (s[WZ] * s[WZ] <= shared->b->w2_max),
         shared);
    for (int k = 0; k < COIN_PRIV_LANES; ++k)
        if (c->coin[k]) {
            for (int i = 0; i < 8; ++i)
                ((double *)c->coin[k])[i] = s[i][k];
            c->status[k] = (int32_t)(c->limits.coarse[k] & COIN_COARSE);
        }
}

/* Steps side by side until all are done, or too few coins are left.  A coin
 * leaves before a step that is refused for it. */
COIN_PRIV_INLINE void run_group(struct group *c, const struct shared *shared,
                                coin_lanes_step *step, const void *coefficients)
{
    const mask none = {0};
    keep(c, coin_lanes_admit_start(&c->limits, &c->g.y), shared);
    while (c->size >= ENOUGH && c->steps < shared->steps)
        keep(c,
             coin_lanes_block(&c->g, &c->limits, &c->steps,
                              shared->steps - c->steps, step, coefficients),
             shared);
    if (c->size >= ENOUGH)
        store(c, shared);
    else
        keep(c, none, shared);
}

/* The same by a method. */
typedef void run_of_group(struct group *c, const struct shared *shared,
                          const void *coefficients);

static void rk4(struct group *c, const struct shared *shared,
                const void *fields)
{
    run_group(c, shared, coin_lanes_rk4_step, fields);
}

static void rk8(struct group *c, const struct shared *shared, const void *field)
{
    run_group(c, shared, coin_lanes_rk8_step, field);
}

static void run(coin_priv_batch *batch, const struct shared *shared,
                run_of_group *by_method, const void *coefficients)
{
    struct group c;
    for (size_t i = 0; i < batch->count; i += COIN_PRIV_LANES) {
        const size_t left = batch->count - i;
        gather(&c, &batch->s[i], left, shared);
        by_method(&c, shared, coefficients);
        for (size_t k = 0; k < COIN_PRIV_LANES && k < left; ++k)
            coin_priv_note(batch, i + k, c.status[k]);
    }
}

int coin_priv_run_abreast(coin_priv_batch *batch, const coin_priv_body *b,
                          int32_t method, double dt, uint64_t steps)
{
    const struct shared shared = {
        b, coin_priv_limits_of(b, method, dt), dt, steps, method,
    };
    const coin_lanes_rk4_fields k = {
        field_of(b, dt / 2),
        field_of(b, dt),
        field_of(b, dt / 6),
    };
    if (method == COIN_RK4)
        run(batch, &shared, rk4, &k);
    else if (method == COIN_RK8)
        run(batch, &shared, rk8, &k.full);
    else
        return 0;
    return 1;
}

#else

int coin_priv_run_abreast(coin_priv_batch *batch, const coin_priv_body *b,
                          int32_t method, double dt, uint64_t steps)
{
    (void)batch, (void)b, (void)method, (void)dt, (void)steps;
    return 0;
}

#endif
