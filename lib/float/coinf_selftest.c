/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "floats.h"

#include <math.h>

/* The hash that every build must give, as in lib/about/selftest.c. */
#define PINNED UINT64_C(0x2fc5de29fb3956b6)

/* FNV-1a over the bits of a number, low byte first whatever the machine. */
static uint64_t hashed(uint64_t hash, float x)
{
    union {
        float value;
        uint32_t bits;
    } word;
    word.value = x;
    for (int byte = 0; byte < 4; ++byte) {
        hash ^= word.bits >> (8 * byte) & 0xff;
        hash *= UINT64_C(0x100000001b3);
    }
    return hash;
}

static uint64_t hashed_state(uint64_t hash, const coinf_state *s)
{
    const float member[] = {
        s->theta, s->phi, s->psi, s->x, s->z, s->wX, s->wY, s->wZ,
    };
    for (int i = 0; i < 8; ++i)
        hash = hashed(hashed(hash, member[i]), s->low[i]);
    return hash;
}

int32_t coinf_selftest(void)
{
    /* A wobbling disc, and a coin in SI units that turns many times. */
    static const float disc[][3] = {{1, 1, 1}, {0.00567f, 0.01213f, 9.80665f}};
    static const coinf_state start[] = {
        {0.5f, 0, 0, 0, 0, 0.1f, 0.8f, 1.2f, {0, 0, 0, 0, 0, 0, 0, 0}},
        {-0.3f, 50, -70, 0, 0, 0, 5, 40, {0, 0, 0, 0, 0, 0, 0, 0}},
    };
    static const float dt[] = {0.05f, 1.0f / 480};
    const volatile float unknown = (float)NAN; /* as in selftest.c */
    const float nan = unknown;
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (int i = 0; i < 2; ++i) {
        coinf_state s = start[i];
        coinf_params p = {0, 0, 0, 0, 0, 0, {0, 0}};
        coinf_params_disc(&p, disc[i][0], disc[i][1], disc[i][2]);
        coinf_run(&s, &p, COIN_RK4, dt[i], 100, NULL);
        hash = hashed_state(hash, &s);
    }
    const int pinned = (hash == PINNED) & (nan != nan);
    return pinned ? COIN_OK : COIN_EBUILD;
}
