/* SPDX-License-Identifier: MIT */
#include "pinned.h"

/* Scheduled before registers are given out gcc's code for RK4 is 4 to 6 %
 * faster, without a change of any bit. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__)
#pragma GCC optimize("schedule-insns", "sched-pressure")
#endif

#include "lanes.h"
#include "number.h"

#include <string.h>

#if COIN_PRIV_WIDTH

typedef double coin_lanes __attribute__((vector_size(COIN_PRIV_WIDTH)));
typedef int64_t lanes_mask __attribute__((vector_size(COIN_PRIV_WIDTH)));

/* coin_priv_lesser() in each lane: on x86 that is an instruction. */
#if defined(__SSE2__) && COIN_PRIV_WIDTH == 16
#define coin_lanes_lesser(a, b) __builtin_ia32_minpd(a, b)
#elif defined(__AVX__) && COIN_PRIV_WIDTH == 32
#define coin_lanes_lesser(a, b) __builtin_ia32_minpd256(a, b)
#else
COIN_PRIV_INLINE coin_lanes coin_lanes_lesser(coin_lanes a, coin_lanes b)
{
    const lanes_mask less = (lanes_mask)(a < b);
    return (coin_lanes)((less & (lanes_mask)a) | (~less & (lanes_mask)b));
}
#endif

/* The equations and the steps once more, as they are written, but with a vector
 * for each double: the same operations in the same order, so that each coin
 * gets the bits that it gets alone. */
#if defined(__clang__)
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wkeyword-macro"
#endif
#define double coin_lanes
#define coin_priv_stage coin_lanes_stage
#define coin_priv_pose coin_lanes_pose
#define coin_priv_moment coin_lanes_moment
#define coin_priv_field coin_lanes_field
#define coin_priv_motion coin_lanes_motion
#define coin_priv_drift coin_lanes_drift
#define coin_priv_sundman coin_lanes_sundman
#define coin_priv_sundman_drift coin_lanes_sundman_drift
#define coin_priv_velocity coin_lanes_velocity
#define coin_priv_rate2 coin_lanes_rate2
#define coin_priv_renew coin_lanes_renew
#define coin_priv_lesser coin_lanes_lesser
#define coin_priv_stage_plus coin_lanes_stage_plus
#define coin_priv_pose_plus coin_lanes_pose_plus
#define coin_priv_rk4_slopes coin_lanes_rk4_slopes
#define coin_priv_rk4_step coin_lanes_rk4_step
#undef ROLLCOIN_MOTION_H
#undef ROLLCOIN_RK4_H
#include "motion.h"
#include "rk4.h"
#define FIELD coin_lanes_motion
#define DRIFT coin_lanes_drift
#define EACH_POSE(F) F(phi) F(psi) F(x) F(z)
#include "dop8.h"
#undef double
#undef coin_priv_stage
#undef coin_priv_pose
#undef coin_priv_moment
#undef coin_priv_field
#undef coin_priv_motion
#undef coin_priv_drift
#undef coin_priv_sundman
#undef coin_priv_sundman_drift
#undef coin_priv_velocity
#undef coin_priv_rate2
#undef coin_priv_renew
#undef coin_priv_lesser
#undef coin_priv_stage_plus
#undef coin_priv_pose_plus
#undef coin_priv_rk4_slopes
#undef coin_priv_rk4_step
#if defined(__clang__)
#pragma clang diagnostic pop
#endif

enum { NUMBERS = sizeof(coin_priv_moment) / sizeof(double) };

/* From a struct of doubles for each coin to one of vectors, made whole before
 * it is written; and back for coin k. */
static void gather(coin_lanes_moment *to, coin_priv_moment *const *at)
{
    coin_lanes *number = (coin_lanes *)to;
    for (int i = 0; i < NUMBERS; ++i) {
        coin_lanes of_all = {0};
        for (int k = 0; k < COIN_PRIV_LANES; ++k)
            of_all[k] = ((const double *)at[k])[i];
        *number++ = of_all;
    }
}

static void scatter(coin_priv_moment *at, const coin_lanes_moment *from, int k)
{
    for (int i = 0; i < NUMBERS; ++i)
        ((double *)at)[i] = ((const coin_lanes *)from)[i][k];
}

static coin_lanes_field field_of(const coin_priv_body *b, double h)
{
    const coin_priv_field f = coin_priv_field_of(b, h);
    const coin_lanes none = {0};
    const coin_lanes_field of_all = {
        none + f.h,  none + f.GJ, none + f.KJ,
        none + f.XJ, none + f.k1, none + f.k2,
    };
    return of_all;
}

typedef coin_lanes lanes_step(coin_lanes_moment *next,
                              const coin_lanes_moment *now,
                              const void *coefficients);

COIN_PRIV_INLINE void march(coin_priv_moment *const *at, int *sound,
                            const double *high, uint64_t n, lanes_step *step,
                            const void *coefficients)
{
    coin_lanes_moment one, other, *now = &one, *next = &other;
    coin_lanes floor = {0};
    lanes_mask above = (lanes_mask)(floor == floor); /* all */
    memset(&one, 0, sizeof one); /* no need, but gcc's analyzer cannot tell */
    gather(now, at);
    gather(next, at);
    for (int k = 0; k < COIN_PRIV_LANES; ++k)
        floor[k] = high[k];
    for (; n > 0; --n) {
        const coin_lanes lowest = step(next, now, coefficients);
        const coin_lanes least = coin_lanes_lesser(lowest, next->y.cth);
        above &= (lanes_mask)(least > floor);
        coin_lanes_moment *const swapped = now;
        now = next;
        next = swapped;
    }
    for (int k = 0; k < COIN_PRIV_LANES; ++k) {
        sound[k] = above[k] != 0;
        if (sound[k])
            scatter(at[k], now, k);
    }
}

static void rk4_abreast(coin_priv_moment *const *at, int *sound,
                        const double *high, const coin_priv_body *b, double dt,
                        uint64_t n)
{
    const coin_lanes_rk4_slopes k = {
        field_of(b, dt / 2),
        field_of(b, dt),
        field_of(b, dt / 6),
    };
    march(at, sound, high, n, coin_lanes_rk4_step, &k);
}

static void rk8_abreast(coin_priv_moment *const *at, int *sound,
                        const double *high, const coin_priv_body *b, double dt,
                        uint64_t n)
{
    const coin_lanes_field f = field_of(b, dt);
    march(at, sound, high, n, dop8_step, &f);
}

coin_priv_abreast *coin_priv_method_abreast(int32_t method)
{
    return method == COIN_RK4   ? rk4_abreast
           : method == COIN_RK8 ? rk8_abreast
                                : NULL;
}

#else

coin_priv_abreast *coin_priv_method_abreast(int32_t method)
{
    (void)method;
    return NULL;
}

#endif
