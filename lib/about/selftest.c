/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include <coin.h>

#include <math.h>

/* The hash that every build must give.  tests/repro prints it.  It changes only
 * together with an entry in CHANGELOG.md. */
#define PINNED UINT64_C(0xf579272d5728be1a)

/* FNV-1a over the bits of a state, low byte first whatever the machine. */
static uint64_t hashed(uint64_t hash, const coin_state *s)
{
    const double member[] = {
        s->theta, s->phi, s->psi, s->x, s->z, s->wX, s->wY, s->wZ,
    };
    for (int i = 0; i < 8; ++i) {
        union {
            double value;
            uint64_t bits;
        } word;
        word.value = member[i];
        for (int byte = 0; byte < 8; ++byte) {
            hash ^= word.bits >> (8 * byte) & 0xff;
            hash *= UINT64_C(0x100000001b3);
        }
    }
    return hash;
}

int32_t coin_selftest(void)
{
    /* A disc, a ring and a coin in SI units; a wobble, a low pass, and a turn
     * through many quarters of phi and psi. */
    static const double ring[][4] = {
        {1, 1, 0, 1},
        {1, 1, 0.9, 1},
        {0.00567, 0.01213, 0, 9.80665},
    };
    static const coin_state start[] = {
        {0.5, 0, 0, 0, 0, 0.1, 0.8, 1.2},
        {0.3, -2, 1, 3, -4, 0, 0.02, 0.02},
        {-0.3, 50, -70, 0, 0, 0, 5, 40},
    };
    static const double dt[] = {0.05, 0.01, 1.0 / 480};
    /* A NaN that no compiler foresees: where it equals itself, no check of a
     * range refuses one.  == raises no exception, as < would. */
    const volatile double unknown = (double)NAN;
    const double nan = unknown;
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    for (int i = 0; i < 3; ++i) {
        coin_params p = {0, 0, 0, 0, 0, 0, {0, 0}};
        coin_params_ring(&p, ring[i][0], ring[i][1], ring[i][2], ring[i][3]);
        for (int32_t m = 0; coin_method_name(m); ++m) {
            coin_state s = start[i];
            coin_run(&s, &p, m, dt[i], 100, NULL);
            hash = hashed(hash, &s);
        }
        coin_state s = start[i];
        coin_advance(&s, &p, 100 * dt[i], 1e-9, NULL);
        hash = hashed(hash, &s);
    }
    const int pinned = (hash == PINNED) & (nan != nan);
    return pinned ? COIN_OK : COIN_EBUILD;
}
