/* SPDX-License-Identifier: MIT */
/* Prints a hash of every bit of many motions: the reference scenes by each
 * method, 2000 steps of 0.02 natural units of time.  The same on every
 * platform and compiler, whatever the size or order of bytes: it takes the
 * bits of each double from the lowest to the highest. */
#include <coin.h>

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { STEPS = 2000, PER_SAMPLE = 100, SAMPLES = STEPS / PER_SAMPLE + 1 };

/* FNV-1a, 64 bits. */
#define FNV_OFFSET UINT64_C(14695981039346656037)
#define FNV_PRIME UINT64_C(1099511628211)

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
};

static uint64_t hash_u64(uint64_t h, uint64_t bits)
{
    int i;
    for (i = 0; i < 8; ++i)
        h = (h ^ (bits >> 8 * i & 0xff)) * FNV_PRIME;
    return h;
}

static uint64_t hash_state(uint64_t h, const coin_state *s)
{
    uint64_t bits[sizeof *s / sizeof(uint64_t)];
    size_t i;
    memcpy(bits, s, sizeof bits);
    for (i = 0; i < sizeof bits / sizeof *bits; ++i)
        h = hash_u64(h, bits[i]);
    return h;
}

/* A scene by a method: the samples on the way, then one run to the end.  A
 * refused step is part of the picture: status and progress count too. */
static uint64_t hash_motion(const scene *a, int32_t method)
{
    const double dt = 0.02 * sqrt(a->radius / a->gravity);
    coin_state s = {0, 0, 0, 0, 0, 0, 0, 0}, out[SAMPLES];
    uint64_t h = FNV_OFFSET, steps = 0;
    coin_params p;
    size_t i, done = 0;
    int32_t status;

    status =
        coin_params_ring(&p, a->mass, a->radius, a->inner_radius, a->gravity);
    h = hash_u64(h, (uint32_t)status);
    s.theta = a->theta;
    s.wX = a->wX;
    s.wY = a->wY;
    s.wZ = a->wZ;
    status = coin_sample(&s, &p, method, dt, PER_SAMPLE, SAMPLES, out, &done);
    h = hash_u64(hash_u64(h, (uint32_t)status), done);
    for (i = 0; i < done; ++i)
        h = hash_state(h, &out[i]);
    status = coin_run(&s, &p, method, dt, STEPS, &steps);
    h = hash_u64(hash_u64(h, (uint32_t)status), steps);
    return hash_state(h, &s);
}

int main(void)
{
    uint64_t all = FNV_OFFSET;
    int32_t method;

    for (method = 0; coin_method_name(method) != NULL; ++method) {
        size_t i;
        for (i = 0; i < sizeof scenes / sizeof *scenes; ++i) {
            const uint64_t h = hash_motion(&scenes[i], method);
            printf("%016" PRIx64 " %s %s\n", h, coin_method_name(method),
                   scenes[i].name);
            all = hash_u64(all, h);
        }
    }
    printf("%016" PRIx64 " all, selftest %d\n", all, (int)coin_selftest());
    return method == 0;
}
