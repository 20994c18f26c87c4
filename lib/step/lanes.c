/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

/* With this pragma gcc schedules instructions before it allocates registers.
 * RK4 is 4 to 6 % faster by that, with the same bits. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__)
#pragma GCC optimize("schedule-insns", "sched-pressure")
#endif

#include "lanes.h"

#if COIN_PRIV_WIDTH

#define COIN_PRIV_ABREAST
#include "../motion/number.t.h"

#include "../motion/angles.t.h"

#include "../motion/equations.t.h"

#include "progress.t.h"

#include "rk4.t.h"
#include "rk8.t.h"
#undef COIN_PRIV_ABREAST
#include "../motion/kind.h"

typedef coin_lanes_whole mask;

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

/* Coins side by side: where they started, and how far they are. */
struct coins {
    coin_lanes start[8]; /* in the order of coin_state */
    coin_lanes_progress g;
};

enum { THETA, PHI, PSI, X, Z, WX, WY, WZ };

/* Each vector is complete before it is stored: a wide load would wait for
 * narrow stores to the same place. */
COIN_PRIV_INLINE void load(struct coins *c, coin_state *const *where)
{
    for (int i = 0; i < 8; ++i) {
        coin_lanes of_all = {0};
        for (int k = 0; k < COIN_PRIV_LANES; ++k)
            of_all[k] = ((const double *)where[k])[i];
        c->start[i] = of_all;
    }
}

/* coin_priv_pose_holds() for each lane; 0 for NaN.  The rates are not tested:
 * those too large for a state are beyond every limit of a step. */
static mask pose_holds(const coin_lanes *s)
{
    return (coin_lanes_magnitude(s[THETA]) < COIN_PRIV_HALF_PI) &
           (coin_lanes_magnitude(s[PHI]) <= COIN_PRIV_ANGLE_MAX) &
           (coin_lanes_magnitude(s[PSI]) <= COIN_PRIV_ANGLE_MAX) &
           (coin_lanes_magnitude(s[X]) <= COIN_PRIV_LARGEST) &
           (coin_lanes_magnitude(s[Z]) <= COIN_PRIV_LARGEST);
}

static void begin(struct coins *c)
{
    const coin_lanes *s = c->start;
    const coin_lanes_sc th = coin_lanes_sine_cosine(s[THETA]);
    const coin_lanes_sc ph = coin_lanes_sine_cosine(s[PHI]);
    const coin_lanes q = 1 / th.c;
    const coin_lanes_variables y = {
        s[WX], s[WY], s[WZ], th.s, th.c, q, q * th.s, ph.s, ph.c,
    };
    coin_lanes_progress_begin(&c->g, &y, s[THETA], s[PHI], s[PSI]);
}

/* One step; a lane of *sound becomes 0 if coin_run() would take that step in
 * another way. */
typedef void lanes_step(coin_lanes_step_end *end, coin_lanes_variables *next,
                        mask *sound, const coin_lanes_variables *y,
                        const void *coefficients);

COIN_PRIV_INLINE void rk4_step(coin_lanes_step_end *end,
                               coin_lanes_variables *next, mask *sound,
                               const coin_lanes_variables *y,
                               const void *fields)
{
    coin_lanes_rk4_lean lean;
    const coin_lanes_sc heading = {y->sph, y->cph};
    *end = coin_lanes_rk4_end(&lean, y, (const coin_lanes_rk4_fields *)fields);
    *sound &= coin_lanes_magnitude(lean.late) <= COIN_PRIV_LITTLE_TURN;
    *next = coin_lanes_variables_at(end, lean.th,
                                    coin_lanes_turned(heading, end->adds.phi));
}

COIN_PRIV_INLINE void rk8_step(coin_lanes_step_end *end,
                               coin_lanes_variables *next, mask *sound,
                               const coin_lanes_variables *y, const void *field)
{
    coin_lanes_variables sums;
    (void)sound;
    end->least_cth =
        rk8_sums(&sums, &end->adds, y, (const coin_lanes_field *)field);
    end->wX = sums.wX;
    end->wY = sums.wY;
    end->wZ = sums.wZ;
    *next = coin_lanes_variables_after(y, end);
}

/* What all coins share. */
struct shared {
    const coin_params *p;
    const coin_priv_body *b;
    double dt, coarse2;
    uint64_t steps;
    int32_t method;
};

/* What coin_priv_steps() computes before a block of steps, lane by lane: the
 * cos theta that every stage has to stay above, or 2, and whether phi and psi
 * cannot leave their range. */
static coin_lanes safe_cosine(mask *sound, const struct coins *c,
                              const coin_priv_body *b, double coarse2)
{
    coin_lanes safe = {0};
    for (int k = 0; k < COIN_PRIV_LANES; ++k) {
        const coin_lanes_variables *y = &c->g.y;
        const coin_priv_variables of = {
            y->wX[k], y->wY[k], y->wZ[k], 0, y->cth[k], 0, 0, 0, 0,
        };
        safe[k] = coin_priv_safe_cosine(b, coarse2, &of);
    }
    const double most = COIN_PRIV_ANGLE_MAX - COIN_PRIV_BLOCK_TURN;
    *sound &= (coin_lanes_magnitude(c->g.phi.sum + c->g.added.phi) <= most) &
              (coin_lanes_magnitude(c->g.psi.sum + c->g.added.psi) <= most);
    return safe;
}

/* Whether a single step from *y was safe.  For one step, W^2 is cheaper than
 * the bound for a block. */
COIN_PRIV_INLINE mask one_step_holds(const struct shared *of,
                                     const coin_lanes_variables *y,
                                     const coin_lanes_variables *next,
                                     const coin_lanes_pose *adds)
{
    const coin_lanes g_a = all(of->b->g_a);
    return (coin_lanes_rate2(g_a, y) <= of->coarse2) &
           (coin_lanes_rate2(g_a, next) <= of->coarse2) &
           (coin_lanes_magnitude(adds->theta) <= COIN_PRIV_TURN_MAX) &
           (coin_lanes_magnitude(adds->phi) <= COIN_PRIV_TURN_MAX);
}

/* Does a block of n steps; returns for which coins all of them were safe. */
COIN_PRIV_INLINE mask block_of_steps(struct coins *c, const struct shared *of,
                                     uint64_t n, lanes_step *step,
                                     const void *coefficients)
{
    const int single = of->steps == 1;
    coin_lanes_variables y = c->g.y, next = y;
    coin_lanes_pose added = c->g.added;
    coin_lanes_step_end end;
    coin_lanes safe = all(0);
    mask sound = y.cth > safe;
    if (!single) {
        safe = safe_cosine(&sound, c, of->b, of->coarse2);
        sound &= y.cth > safe;
    }
    for (; n > 0; --n) {
        y = next;
        step(&end, &next, &sound, &y, coefficients);
        sound &= coin_lanes_lesser(end.least_cth, next.cth) > safe;
        added = coin_lanes_pose_plus(&added, 1, &end.adds);
    }
    if (single)
        sound &= one_step_holds(of, &y, &next, &added);
    c->g.y = next;
    c->g.added = added;
    return sound;
}

/* Runs coin k by itself, from where it is in *from, after `done` steps. */
static int32_t go_on(coin_state *s, const struct coins *from, int k,
                     const struct shared *of, uint64_t done)
{
    coin_priv_run r;
    r.b = *of->b;
    coin_priv_run_from(&r, s, of->method, of->dt);
    for (size_t i = 0; i < sizeof r.g / sizeof(double); ++i)
        ((double *)&r.g)[i] = ((const coin_lanes *)&from->g)[i][k];
    r.steps = done;
    return coin_priv_run_to_end(&r, of->method, of->steps, s, NULL);
}

static int32_t alone(coin_state *s, const struct shared *of)
{
    return coin_run(s, of->p, of->method, of->dt, of->steps, NULL);
}

/* Writes the states of the coins that are still in their lanes.  A coin whose
 * path overflowed repeats its run by itself. */
static void store(coin_state *const *where, int32_t *status,
                  const struct coins *c, mask in, const struct shared *of)
{
    const coin_lanes_pose to = coin_lanes_pose_of(&c->g, all(of->b->a));
    const coin_lanes s[8] = {
        to.theta,           to.phi,    to.psi,    c->start[X] + to.x,
        c->start[Z] + to.z, c->g.y.wX, c->g.y.wY, c->g.y.wZ,
    };
    const mask holds = pose_holds(s);
    for (int k = 0; k < COIN_PRIV_LANES; ++k) {
        for (int i = 0; in[k] && holds[k] && i < 8; ++i)
            ((double *)where[k])[i] = s[i][k];
        if (in[k])
            status[k] = holds[k] ? COIN_OK : alone(where[k], of);
    }
}

/* Blocks of steps, each from where the last one ended; *in becomes 0 for a coin
 * that left its lane, and status[k] what coin_run() returns for it. */
COIN_PRIV_INLINE void blocks(coin_state *const *where, int32_t *status,
                             struct coins *c, mask *in, const struct shared *of,
                             lanes_step *step, const void *coefficients)
{
    struct coins from;
    int some = 1;
    for (uint64_t done = 0; some && done < of->steps;) {
        if (done > 0)
            from = *c;
        const uint64_t rest = of->steps - done;
        const uint64_t n = rest < COIN_PRIV_BLOCK ? rest : COIN_PRIV_BLOCK;
        const mask sound = block_of_steps(c, of, n, step, coefficients);
        some = 0;
        for (int k = 0; k < COIN_PRIV_LANES; ++k) {
            if ((*in)[k] && !sound[k])
                status[k] = done > 0 ? go_on(where[k], &from, k, of, done)
                                     : alone(where[k], of);
            some |= (*in)[k] && sound[k];
        }
        *in &= sound;
        done += n;
        if (n == COIN_PRIV_BLOCK)
            coin_lanes_end_block(&c->g);
    }
}

COIN_PRIV_INLINE void run(coin_state *const *where, int32_t *status,
                          const struct shared *of, lanes_step *step,
                          const void *coefficients)
{
    struct coins c;
    load(&c, where);
    mask in = pose_holds(c.start);
    for (int k = 0; k < COIN_PRIV_LANES; ++k)
        if (!in[k])
            status[k] = alone(where[k], of);
    begin(&c);
    blocks(where, status, &c, &in, of, step, coefficients);
    store(where, status, &c, in, of);
}

static struct shared shared_of(const coin_params *p, const coin_priv_body *b,
                               int32_t method, double dt, uint64_t steps)
{
    const double coarse2 = coin_priv_limits_of(b, method, dt).coarse2;
    const struct shared of = {p, b, dt, coarse2, steps, method};
    return of;
}

static void rk4(coin_state *const *where, int32_t *status, const coin_params *p,
                const coin_priv_body *b, double dt, uint64_t steps)
{
    const struct shared of = shared_of(p, b, COIN_RK4, dt, steps);
    const coin_lanes_rk4_fields k = {
        field_of(b, dt / 2),
        field_of(b, dt),
        field_of(b, dt / 6),
    };
    run(where, status, &of, rk4_step, &k);
}

static void rk8(coin_state *const *where, int32_t *status, const coin_params *p,
                const coin_priv_body *b, double dt, uint64_t steps)
{
    const struct shared of = shared_of(p, b, COIN_RK8, dt, steps);
    const coin_lanes_field f = field_of(b, dt);
    run(where, status, &of, rk8_step, &f);
}

coin_priv_lanes_run *coin_priv_lanes_run_of(int32_t method)
{
    return method == COIN_RK4 ? rk4 : method == COIN_RK8 ? rk8 : NULL;
}

#else

coin_priv_lanes_run *coin_priv_lanes_run_of(int32_t method)
{
    (void)method;
    return NULL;
}

#endif
