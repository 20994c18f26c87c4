/* SPDX-License-Identifier: MIT */
/* Single precision. */
#include "fuzz.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A float of any double: what is too large is infinite. */
static float f(union argument a)
{
    return isgreater(fabs(a.d), FLT_MAX)
               ? (float)(a.d > 0 ? INFINITY : -INFINITY)
               : (float)a.d;
}

/* clang-format off */
CALL(coinf_selftest, ())
CALL(coinf_params_disc, (a[0].p, f(a[1]), f(a[2]), f(a[3])))
CALL(coinf_params_ring, (a[0].p, f(a[1]), f(a[2]), f(a[3]), f(a[4])))
CALL(coinf_params_body, (a[0].p, f(a[1]), f(a[2]), f(a[3]), f(a[4]), f(a[5])))
CALL(coinf_params_check, (a[0].p))
CALL(coinf_state_check, (a[0].p, a[1].p))
CALL(coinf_state_from_motion,
     (a[0].p, a[1].p, a[2].p, a[3].p, f(a[4]), f(a[5])))
CALL(coinf_angular_velocity, (a[0].p, a[1].p))
CALL(coinf_step, (a[0].p, a[1].p, f(a[2])))
CALL(coinf_run, (a[0].p, a[1].p, a[2].i, f(a[3]), a[4].u, a[5].p))
CALL(coinf_energy, (a[0].p, a[1].p))
CALL(coinf_fastest_rate, (a[0].p, a[1].p))
CALL(coinf_integrals, (a[0].p, a[1].p, a[2].p))
CALL(coinf_reaction, (a[0].p, a[1].p, a[2].p))
CALL(coinf_rates, (a[0].p, a[1].p, a[2].p))
CALL(coinf_center, (a[0].p, a[1].p, a[2].p))
CALL(coinf_velocity, (a[0].p, a[1].p, a[2].p))
CALL(coinf_contact, (a[0].p, a[1].p, a[2].p, a[3].p))
CALL(coinf_axes, (a[0].p, a[1].p))
CALL(coinf_quaternion, (a[0].p, a[1].p))
CALL(coinf_matrix, (a[0].p, a[1].p, a[2].p))
CALL(coinf_check, (a[0].p, a[1].p, a[2].i, f(a[3]), f(a[4])))
/* clang-format on */

/* A run is so many runs of one step, to the bit, and ends where one does. */
static void judge_run(const struct outcome *o)
{
    const union argument *a = o->given;
    coinf_state s = o->world->sf;
    uint64_t done = 0, left;
    memcpy(&left, o->left[5].p, sizeof left);
    while (done < a[4].u &&
           coinf_run(&s, &o->world->pf, a[2].i, f(a[3]), 1, NULL) >= 0)
        ++done;
    demand(same(&s, o->left[0].p, sizeof s));
    if (left != UINT64_C(0xa5a5a5a5a5a5a5a5))
        demand(left == done && (o->result >= 0) == (done == a[4].u));
    else
        demand(o->result < 0);
}

static void judge_step(const struct outcome *o)
{
    coinf_state s = o->world->sf;
    const int32_t status =
        coinf_run(&s, &o->world->pf, COIN_RK4, f(o->given[2]), 1, NULL);
    if (o->result < 0)
        s = o->world->sf;
    else
        demand(status == o->result);
    demand(same(&s, o->left[0].p, sizeof s));
}

#define MAKES (BIT(COIN_EARG) | BIT(COIN_EPARAMS))
#define NO_PARAMS (BIT(COIN_EARG) | BIT(COIN_ESTATE))
#define STEPS (USUAL | BIT(COIN_ESTEP))

const struct function fuzz_functions[] = {
    ROW(coinf_selftest, "", 0, 0, PLAIN),
    ROW(coinf_params_disc, "Gddd", MAKES, 0, PLAIN),
    ROW(coinf_params_ring, "Gdddd", MAKES, 0, PLAIN),
    ROW(coinf_params_body, "Gddddd", MAKES, 0, PLAIN),
    ROW(coinf_params_check, "f", MAKES, 0, PLAIN),
    ROW(coinf_state_check, "gf", USUAL, 0, PLAIN),
    ROW(coinf_state_from_motion, "hfQWdd", USUAL, 0, PLAIN),
    ROW(coinf_angular_velocity, "gC", NO_PARAMS, 0, PLAIN),
    ROW(coinf_step, "Hft", STEPS, COIN_COARSE, 0, judge_step, 0),
    ROW(coinf_run, "Hfitun", STEPS, COIN_COARSE, BIT(COIN_ESTEP), judge_run, 0),
    ROW(coinf_energy, "gf", NUMBER),
    ROW(coinf_fastest_rate, "gf", NUMBER),
    ROW(coinf_integrals, "gfB", USUAL, 0, PLAIN),
    ROW(coinf_reaction, "gfm", USUAL, 0, PLAIN),
    ROW(coinf_rates, "gfj", USUAL, 0, PLAIN),
    ROW(coinf_center, "gfC", USUAL, 0, PLAIN),
    ROW(coinf_velocity, "gfC", USUAL, 0, PLAIN),
    ROW(coinf_contact, "gfCC", USUAL, 0, PLAIN),
    ROW(coinf_axes, "gN", NO_PARAMS, 0, PLAIN),
    ROW(coinf_quaternion, "gD", NO_PARAMS, 0, PLAIN),
    ROW(coinf_matrix, "gfU", USUAL, 0, PLAIN),
    ROW(coinf_check, "gfitd", STEPS, 15, PLAIN),
};

END_OF_TABLE;
