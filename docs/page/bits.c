/* SPDX-License-Identifier: MIT */
/* bits.c: whether this build gives the bits that the library gives elsewhere.
 */
#include "page.h"

#include <math.h>
#include <string.h>

int32_t PAGE(page_selftest)(void)
{
    return coin_selftest();
}

static uint64_t hashed(uint64_t hash, const void *numbers, size_t count)
{
    for (size_t k = 0; k < count; ++k) {
        uint64_t bits;
        memcpy(&bits, (const char *)numbers + 8 * k, sizeof bits);
        for (int byte = 0; byte < 8; ++byte)
            hash = (hash ^ (bits >> (8 * byte) & 0xff)) * 0x100000001b3;
    }
    return hash;
}

enum { REAL_KNOTS = 300, SLIPPING_KNOTS = 2000 };

static uint64_t hash_now(uint64_t hash, const moment *m)
{
    return hashed(hash, m, sizeof *m / sizeof(double));
}

/* The end of the trail, in so many knots. */
static uint64_t hash_trail(uint64_t hash, double duration, int32_t knots)
{
    page_take();
    page_trail(0);
    page_trail_on(duration, knots);
    return hash_now(hash, &page.knots[page.count - 1]);
}

/* A scene as a real coin; an ideal one also by every method, by coin_advance(),
 * by its orbit and with a loss: the hash of all that comes out. */
static uint64_t hash_of(int32_t scene_index)
{
    const double dt = page_scene_number(scene_index, 0);
    const double duration = page_scene_number(scene_index, 1);
    const double steps = floor(duration / dt + 0.5);
    uint64_t hash = 0xcbf29ce484222325;

    page_scene(scene_index);
    page_take();
    page.count = 0;
    if (page.real)
        return hash_trail(hash, duration, REAL_KNOTS);
    for (int32_t m = 0; coin_method_name(m); ++m) {
        coin_state s = page.taken.start;
        coin_run(&s, &page.params, m, dt, (uint64_t)steps, NULL);
        hash = hashed(hash, &s, 8);
    }
    for (int far = 0; far < 3; ++far)
        if (page_at(far * 1e6 * page.orbit.period, duration) >= 0)
            hash = hash_now(hash, &page.now);
    page_asked()->losses.dry =
        1e-2 * page.taken.mass * page.taken.gravity * page.taken.radius;
    page_take();
    if (page_at(0, duration) >= 0)
        hash = hash_now(hash, &page.now);
    page_asked()->mu = 0.1;
    return hash_trail(hash, duration, SLIPPING_KNOTS);
}

/* The hash of scene k, as 16 characters.  The start is then another one. */
const char *PAGE(page_hash)(int32_t k)
{
    static char text[17];
    uint64_t hash = hash_of(k);

    for (int digit = 16; digit-- > 0; hash >>= 4)
        text[digit] = "0123456789abcdef"[hash & 15];
    return text;
}
