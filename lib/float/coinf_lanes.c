/* SPDX-License-Identifier: MIT */
#include "batch_float.h"

#include <string.h>

#if COIN_PRIV_WIDTH

#define COIN_PRIV_ABREAST
#include "../motion/number.t.h"

#include "../motion/angles.t.h"

#include "../motion/equations.t.h"

#include "step.t.h"
#undef COIN_PRIV_ABREAST
#include "../motion/kind.h"

typedef coinf_lanes_whole mask;

enum { NUMBERS = sizeof(coinf_state) / sizeof(float) };

COIN_PRIV_INLINE int any(mask m)
{
    uint64_t part[COIN_PRIV_WIDTH / 8], all = 0;
    memcpy(part, &m, sizeof part);
    for (size_t i = 0; i < sizeof part / sizeof *part; ++i)
        all |= part[i];
    return all != 0;
}

/* From one struct of floats for each coin to one struct of vectors, and back.
 * Lanes left over hold the first coin. */
static void load(coinf_lanes_state *to, coinf_state *const *coin, int count)
{
    float *number = (float *)to;
    for (int i = 0; i < NUMBERS; ++i)
        for (int k = 0; k < COINF_PRIV_LANES; ++k)
            *number++ = ((const float *)coin[k < count ? k : 0])[i];
}

static void store(coinf_state *const *coin, int count,
                  const coinf_lanes_state *from)
{
    for (int k = 0; k < count; ++k)
        for (int i = 0; i < NUMBERS; ++i)
            ((float *)coin[k])[i] =
                ((const float *)from)[i * COINF_PRIV_LANES + k];
}

/* A vector with x in every lane.  A difference: 0 + x would turn -0 into 0. */
COIN_PRIV_INLINE coinf_lanes all(float x)
{
    const coinf_lanes none = {0};
    return x - none;
}

static coinf_lanes_plan plan_for_all(const coinf_priv_plan *p)
{
    const coinf_lanes_plan of_all = {
        {all(p->f.h), all(p->f.GJ), all(p->f.KJ), all(p->f.XJ), all(p->f.k1),
         all(p->f.k2)},
        all(p->KJ_low),
        all(p->a),
        all(p->g_a),
        all(p->k1),
        all(p->k2),
        all(p->coarse2),
        all(p->most2),
    };
    return of_all;
}

/* Subtracts whole turns where there are any.  Subtracting zero turns would
 * change bits: it may round the remainder again. */
static void turn_back(coinf_lanes *angle, coinf_lanes *low)
{
    const mask far = coinf_lanes_magnitude(*angle) > 2 * COIN_PRIV_HALF_PI;
    coinf_lanes near = *angle, near_low = *low;
    coinf_lanes_reduce(&near, &near_low);
    *angle = coinf_lanes_choose(far, near, *angle);
    *low = coinf_lanes_choose(far, near_low, *low);
}

/* Leaves in *next the numbers of coins whose mask is all ones, and takes those
 * of the others from *s. */
static void keep(coinf_lanes_state *next, mask to_be_taken,
                 const coinf_lanes_state *s)
{
    for (int i = 0; i < NUMBERS; ++i)
        ((coinf_lanes *)next)[i] = coinf_lanes_choose(
            to_be_taken, ((coinf_lanes *)next)[i], ((const coinf_lanes *)s)[i]);
}

/* Copies vector by vector.  The moves of an assignment may be narrower, and a
 * wide load then waits for two stores. */
static void copy(coinf_lanes_state *to, const coinf_lanes_state *from)
{
    for (int i = 0; i < NUMBERS; ++i)
        ((coinf_lanes *)to)[i] = ((const coinf_lanes *)from)[i];
}

/* For each coin, all ones or 0. */
struct verdict {
    mask sound;  /* whether the last step was sound */
    mask coarse; /* whether any step so far was coarse */
};

/* One step of each coin.  Returns 0 if it would be sound for no coin.  A coin
 * whose step would not be sound stays where it is.  So its next step, from the
 * same state, is not made either. */
static int step_of_each(coinf_lanes_state *s, struct verdict *of,
                        const coinf_lanes_plan *plan)
{
    coinf_lanes_variables last;
    coinf_lanes_state next;
    coinf_lanes_slope first, rest;
    const coinf_lanes_variables y = coinf_lanes_variables_with_low(s);
    coinf_lanes_slopes(&first, &rest, &last, plan, &y, coinf_lanes_slope_at);
    copy(&next, s);
    coinf_lanes_add_change(&next, &first, &rest);
    const coinf_lanes begin = coinf_lanes_rate2(plan->g_a, &y);
    const coinf_lanes end = coinf_lanes_rate2(plan->g_a, &last);
    of->coarse |= ~((begin <= plan->coarse2) & (end <= plan->coarse2));
    of->sound = (begin <= plan->most2) & (end <= plan->most2) &
                coinf_lanes_holds(&next, plan);
    const mask turned =
        (coinf_lanes_magnitude(next.phi) > 2 * COIN_PRIV_HALF_PI) |
        (coinf_lanes_magnitude(next.psi) > 2 * COIN_PRIV_HALF_PI);
    if (COIN_PRIV_RARELY(any(~of->sound | turned))) {
        turn_back(&next.phi, &next.low[1]);
        turn_back(&next.psi, &next.low[2]);
        keep(&next, of->sound, s);
    }
    copy(s, &next);
    return any(of->sound);
}

static void run_rk4(coinf_state *const *coin, int32_t *status, int count,
                    const coinf_priv_plan *plan, uint64_t n)
{
    const coinf_lanes_plan of_all = plan_for_all(plan);
    const mask none = {0};
    struct verdict of = {~none, none};
    coinf_lanes_state s;
    load(&s, coin, count);
    while (n > 0 && step_of_each(&s, &of, &of_all))
        --n;
    store(coin, count, &s);
    for (int k = 0; k < count; ++k)
        status[k] = !of.sound[k] ? COIN_ESTEP : of.coarse[k] & COIN_COARSE;
}

coinf_priv_group_run *coinf_priv_group_run_of(int32_t method)
{
    return method == COIN_RK4 ? run_rk4 : NULL;
}

#else

coinf_priv_group_run *coinf_priv_group_run_of(int32_t method)
{
    (void)method;
    return NULL;
}

#endif
