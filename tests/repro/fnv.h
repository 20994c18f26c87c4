/* SPDX-License-Identifier: MIT */
/* A hash of what motions give. */
#ifndef ROLLCOIN_FNV_H
#define ROLLCOIN_FNV_H

#include <coin.h>
#include <stdint.h>
#include <string.h>

/* FNV-1a, 64 bits. */
#define FNV_OFFSET UINT64_C(14695981039346656037)
#define FNV_PRIME UINT64_C(1099511628211)

static uint64_t hash_u64(uint64_t h, uint64_t bits)
{
    int i;
    for (i = 0; i < 8; ++i)
        h = (h ^ (bits >> 8 * i & 0xff)) * FNV_PRIME;
    return h;
}

static uint64_t hash_doubles(uint64_t h, const void *from, size_t count)
{
    const unsigned char *at = (const unsigned char *)from;
    uint64_t bits;
    size_t i;
    for (i = 0; i < count; ++i) {
        memcpy(&bits, at + i * sizeof bits, sizeof bits);
        h = hash_u64(h, bits);
    }
    return h;
}

static uint64_t hash_state(uint64_t h, const coin_state *s)
{
    return hash_doubles(h, s, sizeof *s / sizeof(double));
}

static uint64_t hash_status(uint64_t h, int32_t status)
{
    return hash_u64(h, (uint32_t)status);
}

#endif
