/* SPDX-License-Identifier: MIT */
/* bits.c: whether this build gives the bits that the library gives elsewhere.
 */
#include "page.h"

#include "../examples/scenes.h"

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

/* A scene by every method, by coin_advance(), by its orbit, with a loss, and as
 * a real coin: the hash of all that comes out. */
static uint64_t hash_of(int32_t scene_index)
{
    const scene *k = &SCENES[scene_index];
    const double steps = floor(k->duration / k->dt + 0.5);
    uint64_t hash = 0xcbf29ce484222325;

    page_scene(scene_index);
    page_take();
    for (int32_t m = 0; coin_method_name(m); ++m) {
        coin_state s = k->start;
        coin_run(&s, &page.params, m, k->dt, (uint64_t)steps, NULL);
        hash = hashed(hash, &s, 8);
    }
    for (int far = 0; far < 3; ++far)
        if (page_at(far * 1e6 * page.orbit.period, k->duration) >= 0)
            hash = hashed(hash, &page.now, sizeof page.now / sizeof(double));
    page_asked()->losses.dry =
        1e-2 * page.taken.mass * page.taken.gravity * page.taken.radius;
    page_take();
    if (page_at(0, k->duration) >= 0)
        hash = hashed(hash, &page.now, sizeof page.now / sizeof(double));
    page_asked()->mu = 0.1;
    page_take();
    page_trail(0);
    page_trail_on(k->duration, 2000);
    return hashed(hash, &page.knots[page.count - 1],
                  sizeof page.now / sizeof(double));
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
