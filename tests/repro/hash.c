/* SPDX-License-Identifier: MIT */
/* Prints a hash of every bit of many motions: the reference scenes, a coin that
 * nearly falls flat and one that does, by each method, 2000 steps of 0.02
 * natural units of time; some of them in batches, and by coin_advance() forward
 * and back; the orbit; coins with losses to rest; coins that slip; and the
 * runs in single precision.  The same on every platform and compiler, whatever
 * the size or order of bytes: it takes the bits of each double from the lowest
 * to the highest.
 *
 * A processor that is emulated, or has no unit for doubles, or little memory,
 * takes a part, line by line the same: every SCENE_STRIDE-th scene;
 * WITHOUT_ORBIT, which takes 70 KiB, and without coin_move() then.  Needs sqrt,
 * memcpy and puts of the C library. */
#include "fnv.h"
#ifndef WITHOUT_ORBIT
#include "hash_move.h"
#endif

#include <coinf.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { STEPS = 2000, PER_SAMPLE = 100, SAMPLES = STEPS / PER_SAMPLE + 1 };

#ifndef SCENE_STRIDE
#define SCENE_STRIDE 1
#endif

typedef struct scene {
    const char *name;
    double mass, radius, inner_radius, gravity;
    double theta, wX, wY, wZ;
} scene;

/* The decimals are those of tests/reference; they read as the same doubles. */
static const scene scenes[] = {
    {"wobble", 1, 1, 0, 1, 0.1, 0, 0, 1},
    {"generic", 1, 1, 0, 1, 0.5, 0.1, 0.8, 1.2},
    {"spin", 1, 1, 0, 1, 0.6, 0, 1.8169596747420438, 0},
    {"circle", 1, 1, 0, 1, 0.4, 0, 0.2550291587475191, 1},
    {"tumble", 1, 1, 0, 1, 0.001, 0, 0, 0.3},
    {"nearflat", 1, 1, 0, 1, 0.3, 0, 0.02, 0.02},
    {"ring", 1, 1, 0.9, 1, 0.5, 0.1, 0.8, 1.2},
    {"quarter", 0.00567, 0.01213, 0, 9.80665, 0.3, 0, 5, 40},
    {"flat3", 1, 1, 0, 1, 0.5, 0, -0.2947, 0.3},
    {"ring_b05", 1, 1, 0.5, 1, 0.2, -0.3, -0.5, 0.9},
    {"negative", 1, 1, 0, 1, -0.4, 0.2, 0.6, -1.5},
    {"si_washer", 0.0123, 0.02, 0.008, 9.81, 0.25, -2, 6, 30},
    {"drop", 1, 1, 0, 1, 0.3, 0, 1e-13, 1e-13},
    {"fall", 1, 1, 0.5, 1, -0.3, -0.1, 0, 0},
};

/* A scene's beginning. */
typedef struct start {
    coin_params p;
    coin_state s;
    double unit;
} start;

static start start_of(const scene *a)
{
    start b;
    const coin_state s = {a->theta, 0, 0, 0, 0, a->wX, a->wY, a->wZ};
    coin_params_ring(&b.p, a->mass, a->radius, a->inner_radius, a->gravity);
    b.s = s;
    b.unit = sqrt(a->radius / a->gravity);
    return b;
}

/* A scene by a method: the samples on the way, then one run to the end.  A
 * refused step is part of the picture: status and progress count too. */
static uint64_t hash_run(const scene *a, int32_t method)
{
    start b = start_of(a);
    coin_state out[SAMPLES];
    const double dt = 0.02 * b.unit;
    uint64_t steps = 0, h = hash_status(FNV_OFFSET, coin_params_check(&b.p));
    size_t i, done = 0;

    h = hash_status(h, coin_sample(&b.s, &b.p, method, dt, PER_SAMPLE, SAMPLES,
                                   out, &done));
    h = hash_u64(h, done);
    for (i = 0; i < done; ++i)
        h = hash_state(h, &out[i]);
    h = hash_status(h, coin_run(&b.s, &b.p, method, dt, STEPS, &steps));
    return hash_state(hash_u64(h, steps), &b.s);
}

/* Coins that lean ever more, in a batch: one step, then enough to end a block;
 * so many that the widest vectors are filled, and one is not. */
static uint64_t hash_batch(const scene *a, int32_t method)
{
    enum { COINS = 9 };
    const start b = start_of(a);
    coin_state s[COINS];
    int32_t status[COINS];
    uint64_t n, h = FNV_OFFSET;
    int i;
    for (i = 0; i < COINS; ++i) {
        s[i] = b.s;
        s[i].theta += 0.0625 * i; /* exact: fused or not, one sum */
    }
    for (n = 1; n < 100; n += 98) {
        h = hash_status(h, coin_batch_run(s, COINS, &b.p, method, 0.02 * b.unit,
                                          n, status));
        for (i = 0; i < COINS; ++i)
            h = hash_state(hash_status(h, status[i]), &s[i]);
    }
    return h;
}

/* By coin_advance() to ten times, of which every other is short, and back. */
static uint64_t hash_advance(const scene *a)
{
    uint64_t h = FNV_OFFSET;
    double tol, reached;
    int i;
    for (tol = 1e-2; tol >= 0.99e-11; tol /= 1000) {
        start b = start_of(a);
        for (i = 1; i <= 20; ++i) {
            const double t = (i % 2 ? 1.7 : 0.4) * (i <= 10 ? 1 : -1) * b.unit;
            reached = 0;
            h = hash_status(h, coin_advance(&b.s, &b.p, t, tol, &reached));
            h = hash_state(hash_doubles(h, &reached, 1), &b.s);
        }
    }
    return h;
}

/* Some of each loss, so that most coins come to rest. */
static coin_losses losses_of(const start *b)
{
    const double m = b->p.mass * b->p.radius * b->p.radius, w = 1 / b->unit;
    coin_losses l = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, {0, 0}};
    l.damping = 0.01;
    l.dry = 0.008 * m * w * w;
    l.viscous = 0.004 * m * w;
    l.layer = 0.002 * m * sqrt(w);
    l.gap = 0.001 * m * w;
    l.rolling = 0.004 * m * w * w;
    l.spin = 0.01 * m * w;
    l.angular = 0.001 * w;
    l.flat = 1e-4;
    return l;
}

static uint64_t hash_settle(const scene *a)
{
    uint64_t h = FNV_OFFSET;
    double tol, reached = 0;
    int i;
    for (tol = 1e-3; tol > 0.9e-9; tol /= 1e6) {
        start b = start_of(a);
        const coin_losses l = losses_of(&b);
        for (i = 0; i < 11; ++i) {
            const double t = (i < 10 ? 1.7 : 20) * b.unit;
            h = hash_status(h, coin_settle(&b.s, &b.p, &l, t,
                                           i < 10 ? tol : 1e-3, &reached));
            h = hash_state(hash_doubles(h, &reached, 1), &b.s);
        }
    }
    return h;
}

/* A scene in single precision. */
typedef struct start_float {
    coinf_params p;
    coinf_state s;
    float dt;
} start_float;

static start_float start_float_of(const scene *a)
{
    start_float b = {{0, 0, 0, 0, 0, 0, {0, 0}},
                     {0, 0, 0, 0, 0, 0, 0, 0, {0, 0, 0, 0, 0, 0, 0, 0}},
                     0};
    coinf_params_ring(&b.p, (float)a->mass, (float)a->radius,
                      (float)a->inner_radius, (float)a->gravity);
    b.s.theta = (float)a->theta;
    b.s.wX = (float)a->wX;
    b.s.wY = (float)a->wY;
    b.s.wZ = (float)a->wZ;
    b.dt = (float)(0.02 * sqrt(a->radius / a->gravity));
    return b;
}

static uint64_t hash_floats(uint64_t h, const void *from, size_t count)
{
    const unsigned char *at = (const unsigned char *)from;
    uint32_t bits;
    size_t i;
    for (i = 0; i < count; ++i) {
        memcpy(&bits, at + i * sizeof bits, sizeof bits);
        h = hash_u64(h, bits);
    }
    return h;
}

static uint64_t hash_state_float(uint64_t h, const coinf_state *s)
{
    return hash_floats(h, s, sizeof *s / sizeof(float));
}

/* The same runs in single precision, in two parts. */
static uint64_t hash_float(const scene *a)
{
    start_float b = start_float_of(a);
    uint64_t steps = 0, h = FNV_OFFSET;
    int part;
    for (part = 0; part < 2; ++part) {
        h = hash_status(
            h, coinf_run(&b.s, &b.p, COIN_RK4, b.dt, STEPS / 2, &steps));
        h = hash_state_float(hash_u64(h, steps), &b.s);
    }
    return h;
}

#ifndef WITHOUT_ORBIT
#define LENGTH(array) (sizeof(array) / sizeof *(array))

/* The orbit, to ten times forward and back. */
static uint64_t hash_orbit(const scene *a)
{
    const start b = start_of(a);
    coin_orbit o;
    coin_state s = b.s;
    const int32_t status = coin_orbit_init(&o, &b.s, &b.p);
    uint64_t h = hash_status(FNV_OFFSET, status);
    int i;
    if (status != COIN_OK)
        return h;
    /* All but the tag, which names the version, and what is spare. */
    h = hash_doubles(h, &o, offsetof(coin_orbit, reserved) / sizeof(double));
    h = hash_doubles(h, o.private_frame + 1, LENGTH(o.private_frame) - 1);
    h = hash_doubles(h, o.private_edges, LENGTH(o.private_edges));
    h = hash_doubles(h, o.private_centers, LENGTH(o.private_centers));
    h = hash_doubles(h, o.private_terms, LENGTH(o.private_terms));
    for (i = -10; i <= 10; ++i) {
        h = hash_status(h, coin_orbit_at(&o, 17.3 * i * b.unit, &s));
        h = hash_state(h, &s);
    }
    return h;
}
#endif

/* Prints a hash and what it is of; returns that of all so far. */
static uint64_t print(uint64_t all, uint64_t h, const char *const words[3])
{
    char line[64];
    size_t n = 0;
    int i;
    for (i = 60; i >= 0; i -= 4)
        line[n++] = "0123456789abcdef"[h >> i & 15];
    for (i = 0; i < 3; ++i) {
        const char *from = words[i];
        for (line[n++] = ' '; *from && n < sizeof line - 2;)
            line[n++] = *from++;
    }
    line[n] = 0;
    puts(line);
    return hash_u64(all, h);
}

/* Each kind of motion from a scene. */
static uint64_t print_scene(uint64_t all, const scene *a)
{
    int32_t m;
    for (m = 0; coin_method_name(m) != NULL; ++m) {
        const char *words[] = {coin_method_name(m), "run", a->name};
        all = print(all, hash_run(a, m), words);
        words[1] = "batch";
        all = print(all, hash_batch(a, m), words);
    }
    {
#ifndef WITHOUT_ORBIT
        const start b = start_of(a);
#endif
        const char *words[] = {"coin", "advance", a->name};
        all = print(all, hash_advance(a), words);
        words[1] = "float";
        all = print(all, hash_float(a), words);
        words[1] = "settle";
        all = print(all, hash_settle(a), words);
#ifndef WITHOUT_ORBIT
        words[1] = "orbit";
        all = print(all, hash_orbit(a), words);
        words[1] = "move";
        all = print(all, hash_move(&b.s, &b.p, b.unit), words);
#endif
    }
    return all;
}

int main(void)
{
    const char *const all_of[] = {"all", "of", "these"};
    uint64_t all = FNV_OFFSET;
    size_t i;

    for (i = 0; i < sizeof scenes / sizeof *scenes; i += SCENE_STRIDE)
        all = print_scene(all, &scenes[i]);
    print(0, all, all_of);
    return coin_selftest() != COIN_OK || coinf_selftest() != COIN_OK;
}
