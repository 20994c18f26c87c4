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

FUNCTION(coinf_selftest, "", coinf_selftest(), 0, 0, PLAIN)
FUNCTION(coinf_params_disc, "Gddd",
         coinf_params_disc(a[0].p, f(a[1]), f(a[2]), f(a[3])), MAKES, 0, PLAIN)
FUNCTION(coinf_params_ring, "Gdddd",
         coinf_params_ring(a[0].p, f(a[1]), f(a[2]), f(a[3]), f(a[4])), MAKES,
         0, PLAIN)
FUNCTION(coinf_params_body, "Gddddd",
         coinf_params_body(a[0].p, f(a[1]), f(a[2]), f(a[3]), f(a[4]), f(a[5])),
         MAKES, 0, PLAIN)
FUNCTION(coinf_params_check, "f", coinf_params_check(a[0].p), MAKES, 0, PLAIN)
FUNCTION(coinf_state_check, "gf", coinf_state_check(a[0].p, a[1].p), USUAL, 0,
         PLAIN)
FUNCTION(coinf_state_from_motion, "hfQWdd",
         coinf_state_from_motion(a[0].p, a[1].p, a[2].p, a[3].p, f(a[4]),
                                 f(a[5])),
         USUAL, 0, PLAIN)
FUNCTION(coinf_angular_velocity, "gC", coinf_angular_velocity(a[0].p, a[1].p),
         NO_PARAMS, 0, PLAIN)
FUNCTION(coinf_step, "Hft", coinf_step(a[0].p, a[1].p, f(a[2])), STEPS,
         COIN_COARSE, 0, judge_step, 0)
FUNCTION(coinf_run, "Hfitun",
         coinf_run(a[0].p, a[1].p, a[2].i, f(a[3]), a[4].u, a[5].p), STEPS,
         COIN_COARSE, BIT(COIN_ESTEP), judge_run, 0)
FUNCTION(coinf_energy, "gf", coinf_energy(a[0].p, a[1].p), NUMBER)
FUNCTION(coinf_fastest_rate, "gf", coinf_fastest_rate(a[0].p, a[1].p), NUMBER)
FUNCTION(coinf_integrals, "gfB", coinf_integrals(a[0].p, a[1].p, a[2].p), USUAL,
         0, PLAIN)
FUNCTION(coinf_reaction, "gfm", coinf_reaction(a[0].p, a[1].p, a[2].p), USUAL,
         0, PLAIN)
FUNCTION(coinf_rates, "gfj", coinf_rates(a[0].p, a[1].p, a[2].p), USUAL, 0,
         PLAIN)
FUNCTION(coinf_center, "gfC", coinf_center(a[0].p, a[1].p, a[2].p), USUAL, 0,
         PLAIN)
FUNCTION(coinf_velocity, "gfC", coinf_velocity(a[0].p, a[1].p, a[2].p), USUAL,
         0, PLAIN)
FUNCTION(coinf_contact, "gfCC", coinf_contact(a[0].p, a[1].p, a[2].p, a[3].p),
         USUAL, 0, PLAIN)
FUNCTION(coinf_axes, "gN", coinf_axes(a[0].p, a[1].p), NO_PARAMS, 0, PLAIN)
FUNCTION(coinf_quaternion, "gD", coinf_quaternion(a[0].p, a[1].p), NO_PARAMS, 0,
         PLAIN)
FUNCTION(coinf_matrix, "gfU", coinf_matrix(a[0].p, a[1].p, a[2].p), USUAL, 0,
         PLAIN)
FUNCTION(coinf_check, "gfitd",
         coinf_check(a[0].p, a[1].p, a[2].i, f(a[3]), f(a[4])), STEPS, 15,
         PLAIN)
