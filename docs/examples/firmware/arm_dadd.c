/* SPDX-License-Identifier: MIT */
/* Doubles on an ARM processor without a unit for them: libgcc's addition (gcc
 * 12, ieee754-df.S) rounds wrongly if one term is 2^33 times the other, the
 * signs differ, and the sum falls below a power of two: the digit that then
 * decides is gone.  8192 - 1.4622e-6 comes out 2^-40 too small.  Rare, an ulp,
 * and another bit than everywhere else.  Who wants the same bits links this,
 * with
 *     -Wl,--wrap=__aeabi_dadd,--wrap=__aeabi_dsub,--wrap=__aeabi_drsub
 */
#include <stdint.h>
#include <string.h>

/* Such helpers take doubles in integer registers, whatever -mfloat-abi. */
#define HELPER __attribute__((pcs("aapcs")))

HELPER double __real___aeabi_dadd(double a, double b);
HELPER double __wrap___aeabi_dadd(double a, double b);
HELPER double __wrap___aeabi_dsub(double a, double b);
HELPER double __wrap___aeabi_drsub(double a, double b);

#define SIGN (UINT64_C(1) << 63)
#define ONE (UINT64_C(1) << 52) /* the digit that is not stored */

static uint32_t exponent(uint64_t of)
{
    return (uint32_t)(of >> 52) & 0x7ff;
}

/* large - small 2^-33, the sign that of large: with ten digits more than are
 * kept, the last of them standing for all beyond. */
static uint64_t difference(uint64_t large, uint64_t small)
{
    const uint64_t y = (small & (ONE - 1)) | ONE;
    const uint64_t beyond = (y & ((1 << 23) - 1)) != 0;
    uint64_t d = (((large & (ONE - 1)) | ONE) << 10) - (y >> 23 | beyond);
    uint64_t from = large >> 52;
    if (d < ONE << 10) {
        d <<= 1;
        --from;
    }
    d += 0x1ff + (d >> 10 & 1);
    return ((from - 1) << 52) + (d >> 10);
}

static uint64_t bits_of(double a)
{
    uint64_t bits;
    memcpy(&bits, &a, sizeof bits);
    return bits;
}

HELPER double __wrap___aeabi_dadd(double a, double b)
{
    const uint64_t x = bits_of(a), y = bits_of(b);
    const uint32_t ex = exponent(x), ey = exponent(y);
    const uint32_t low = ex < ey ? ex : ey, high = ex < ey ? ey : ex;
    uint64_t sum;
    if (high - low != 33 || low == 0 || high == 0x7ff || !((x ^ y) & SIGN))
        return __real___aeabi_dadd(a, b);
    sum = ex > ey ? difference(x, y) : difference(y, x);
    memcpy(&a, &sum, sizeof a);
    return a;
}

HELPER double __wrap___aeabi_dsub(double a, double b)
{
    return __wrap___aeabi_dadd(a, -b);
}

HELPER double __wrap___aeabi_drsub(double a, double b)
{
    return __wrap___aeabi_dadd(b, -a);
}
