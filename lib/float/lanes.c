/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "lanes.h"

#include <string.h>

#if COINF_PRIV_WIDTH

typedef float coinf_lanes __attribute__((vector_size(COINF_PRIV_WIDTH)));
typedef int32_t lanes_int __attribute__((vector_size(COINF_PRIV_WIDTH)));

/* As coinf_state, whose numbers are in this order. */
typedef struct coinf_lanes_state {
    coinf_lanes theta, phi, psi, x, z, wX, wY, wZ, low[8];
} coinf_lanes_state;

enum { NUMBERS = sizeof(coinf_state) / sizeof(float) };

/* a where mask is all ones, b where it is 0. */
COINF_PRIV_INLINE coinf_lanes choose(lanes_int mask, coinf_lanes a,
                                     coinf_lanes b)
{
    return (coinf_lanes)((mask & (lanes_int)a) | (~mask & (lanes_int)b));
}

COINF_PRIV_INLINE coinf_lanes lanes_fabsf(coinf_lanes a)
{
    return (coinf_lanes)((lanes_int)a & INT32_MAX);
}

COINF_PRIV_INLINE int any(lanes_int mask)
{
    uint64_t part[COINF_PRIV_WIDTH / 8], all = 0;
    memcpy(part, &mask, sizeof part);
    for (size_t i = 0; i < sizeof part / sizeof *part; ++i)
        all |= part[i];
    return all != 0;
}

/* The equations and the arithmetic of a step once more, as they are written,
 * but with a vector for each float: the same operations in the same order, so
 * that each coin gets the bits that it gets alone. */
#if defined(__clang__)
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Wkeyword-macro"
#endif
#define float coinf_lanes
#define fabsf lanes_fabsf
#define coinf_state coinf_lanes_state
#define coinf_priv_stage coinf_lanes_stage
#define coinf_priv_pose coinf_lanes_pose
#define coinf_priv_moment coinf_lanes_moment
#define coinf_priv_field coinf_lanes_field
#define coinf_priv_motion coinf_lanes_motion
#define coinf_priv_drift coinf_lanes_drift
#define coinf_priv_sundman coinf_lanes_sundman
#define coinf_priv_sundman_drift coinf_lanes_sundman_drift
#define coinf_priv_velocity coinf_lanes_velocity
#define coinf_priv_rate2 coinf_lanes_rate2
#define coinf_priv_renew coinf_lanes_renew
#define coinf_priv_sc coinf_lanes_sc
#define coinf_priv_sine coinf_lanes_sine
#define coinf_priv_cosine coinf_lanes_cosine
#define coinf_priv_sincos_rest coinf_lanes_sincos_rest
#define coinf_priv_sincos coinf_lanes_sincos
#define coinf_priv_plan coinf_lanes_plan
#define coinf_priv_add coinf_lanes_add
#define coinf_priv_fall_low coinf_lanes_fall_low
#define coinf_priv_residue coinf_lanes_residue
#define coinf_priv_pair coinf_lanes_pair
#define coinf_priv_stage_at coinf_lanes_stage_at
#undef ROLLCOIN_MOTION_H
#undef ROLLCOIN_SINE_H
#undef ROLLCOIN_CHANGE_H
#include "change.h"
#include "motion.h"
#include "sine.h"

/* As lib/sincos.c, of angles in range: a step ends within half a turn.  The
 * number of quarter turns is in the last bits of a float near the rounder. */
COINF_PRIV_INLINE coinf_lanes_sc coinf_lanes_sincos(coinf_lanes x)
{
    coinf_lanes n;
    const coinf_lanes_sc rest = coinf_lanes_sincos_rest(&n, x);
    const lanes_int quarter = (lanes_int)(n + COINF_PRIV_ROUNDER);
    const lanes_int odd = (quarter & 1) == 1;
    const lanes_int minus_s = ((quarter & 2) == 2) & INT32_MIN;
    const lanes_int minus_c = (((quarter + 1) & 2) == 2) & INT32_MIN;
    const coinf_lanes s = choose(odd, rest.c, rest.s);
    const coinf_lanes c = choose(odd, rest.s, rest.c);
    const coinf_lanes_sc r = {
        (coinf_lanes)((lanes_int)s ^ minus_s),
        (coinf_lanes)((lanes_int)c ^ minus_c),
    };
    return r;
}

#define PART COINF_PRIV_INLINE
#define TRUTH lanes_int
#include "carry.h"
#include "rk4.h"
#undef float
#undef fabsf
#undef coinf_state
#undef coinf_priv_stage
#undef coinf_priv_pose
#undef coinf_priv_moment
#undef coinf_priv_field
#undef coinf_priv_motion
#undef coinf_priv_drift
#undef coinf_priv_sundman
#undef coinf_priv_sundman_drift
#undef coinf_priv_velocity
#undef coinf_priv_rate2
#undef coinf_priv_renew
#undef coinf_priv_sc
#undef coinf_priv_sine
#undef coinf_priv_cosine
#undef coinf_priv_sincos_rest
#undef coinf_priv_sincos
#undef coinf_priv_plan
#undef coinf_priv_add
#undef coinf_priv_fall_low
#undef coinf_priv_residue
#undef coinf_priv_pair
#undef coinf_priv_stage_at
#if defined(__clang__)
#pragma clang diagnostic pop
#endif

/* From a struct of floats for each coin to one of vectors, and back.  Places
 * that nobody took go along with the first. */
static void line_up(coinf_lanes_state *to, coinf_state *const *coin, int count)
{
    float *number = (float *)to;
    for (int i = 0; i < NUMBERS; ++i)
        for (int k = 0; k < COINF_PRIV_LANES; ++k)
            *number++ = ((const float *)coin[k < count ? k : 0])[i];
}

static void dismiss(coinf_state *const *coin, int count,
                    const coinf_lanes_state *from)
{
    for (int k = 0; k < count; ++k)
        for (int i = 0; i < NUMBERS; ++i)
            ((float *)coin[k])[i] =
                ((const float *)from)[i * COINF_PRIV_LANES + k];
}

static coinf_lanes_plan plan_of(const coinf_priv_plan *p)
{
    const coinf_lanes none = {0};
    const coinf_lanes_plan of_all = {
        {none + p->f.h, none + p->f.GJ, none + p->f.KJ, none + p->f.XJ,
         none + p->f.k1, none + p->f.k2},
        none + p->KJ_low,
        none + p->a,
        none + p->g_a,
        none + p->k1,
        none + p->k2,
        none + p->coarse2,
        none + p->most2,
        COIN_OK,
    };
    return of_all;
}

/* Takes whole turns off where there are any.  To take none off is not nothing:
 * the addition may round a remainder of half a digit anew. */
static void turn_back(coinf_lanes *angle, coinf_lanes *low)
{
    const lanes_int far = lanes_fabsf(*angle) > PI;
    coinf_lanes near = *angle, near_low = *low;
    take_turns_off(&near, &near_low);
    *angle = choose(far, near, *angle);
    *low = choose(far, near_low, *low);
}

/* Of each number that of *next where mask is all ones, of *s where it is 0. */
static void keep(coinf_lanes_state *next, lanes_int mask,
                 const coinf_lanes_state *s)
{
    for (int i = 0; i < NUMBERS; ++i)
        ((coinf_lanes *)next)[i] =
            choose(mask, ((coinf_lanes *)next)[i], ((const coinf_lanes *)s)[i]);
}

/* Vector by vector: what the compiler makes of an assignment may be narrower,
 * and a wide load then waits for two stores. */
static void copy(coinf_lanes_state *to, const coinf_lanes_state *from)
{
    for (int i = 0; i < NUMBERS; ++i)
        ((coinf_lanes *)to)[i] = ((const coinf_lanes *)from)[i];
}

/* What steps are for each coin: all ones or 0. */
struct verdict {
    lanes_int sound, coarse; /* the last one; any so far */
};

/* One step of each coin; 0 if it would be sound for none.  A coin whose step
 * would not be sound stays where it is, and so will at the next. */
static int step(coinf_lanes_state *s, struct verdict *of,
                const coinf_lanes_plan *plan)
{
    coinf_lanes_stage y, last;
    coinf_lanes_state next;
    struct slope first, rest;
    coinf_lanes_stage_at(&y, s);
    slopes(&first, &rest, &last, plan, &y);
    copy(&next, s);
    change(&next, &first, &rest);
    const coinf_lanes begin = coinf_lanes_rate2(plan->g_a, &y);
    const coinf_lanes end = coinf_lanes_rate2(plan->g_a, &last);
    of->coarse |= ~((begin <= plan->coarse2) & (end <= plan->coarse2));
    of->sound =
        (begin <= plan->most2) & (end <= plan->most2) & holds(&next, plan);
    const lanes_int turned =
        (lanes_fabsf(next.phi) > PI) | (lanes_fabsf(next.psi) > PI);
    if (COINF_PRIV_RARELY(any(~of->sound | turned))) {
        turn_back(&next.phi, &next.low[1]);
        turn_back(&next.psi, &next.low[2]);
        keep(&next, of->sound, s);
    }
    copy(s, &next);
    return any(of->sound);
}

static void rk4_abreast(coinf_state *const *coin, int32_t *status, int count,
                        const coinf_priv_plan *plan, uint64_t n)
{
    const coinf_lanes_plan of_all = plan_of(plan);
    const lanes_int none = {0};
    struct verdict of = {~none, none};
    coinf_lanes_state s;
    line_up(&s, coin, count);
    while (n > 0 && step(&s, &of, &of_all))
        --n;
    dismiss(coin, count, &s);
    for (int k = 0; k < count; ++k)
        status[k] = !of.sound[k] ? COIN_ESTEP : of.coarse[k] & COIN_COARSE;
}

coinf_priv_abreast *coinf_priv_method_abreast(int32_t method)
{
    return method == COIN_RK4 ? rk4_abreast : NULL;
}

#else

coinf_priv_abreast *coinf_priv_method_abreast(int32_t method)
{
    (void)method;
    return NULL;
}

#endif
