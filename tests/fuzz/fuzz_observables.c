/* SPDX-License-Identifier: MIT */
/* What can be read off a state. */
#include "fuzz.h"

#include <math.h>

/* Rows of unit length: 3 products and as many sums of 4 u. */
#define UNIT (32 * 0x1p-53)

static double squares(const double *x, int count)
{
    double sum = 0;
    for (int i = 0; i < count; ++i)
        sum += x[i] * x[i];
    return sum;
}

static void judge_axes(const struct outcome *o)
{
    const double *R = o->left[1].p;
    for (int i = 0; i < 3 && o->result >= 0; ++i)
        demand(fabs(squares(R + 3 * i, 3) - 1) <= UNIT);
}

static void judge_quaternion(const struct outcome *o)
{
    if (o->result >= 0)
        demand(fabs(squares(o->left[1].p, 4) - 1) <= UNIT);
}

static void judge_matrix(const struct outcome *o)
{
    const double *m = o->left[2].p;
    for (int i = 0; i < 3 && o->result >= 0; ++i)
        demand(fabs(squares(m + 4 * i, 3) - 1) <= UNIT && m[4 * i + 3] == 0);
    if (o->result >= 0)
        demand(m[13] > 0 && m[15] == 1);
}

static void judge_center(const struct outcome *o)
{
    const double *r = o->left[2].p;
    if (o->result >= 0)
        demand(r[1] > 0 && r[1] <= o->world->p.radius);
}

static void judge_contact(const struct outcome *o)
{
    const double *r = o->left[2].p, *v = o->left[3].p;
    if (o->result >= 0)
        demand(r[1] == 0 && v[1] == 0);
}

/* The bits are those of the reaction: a coin that lifts off does not slip. */
static void judge_check(const struct outcome *o)
{
    const int32_t bits = (int32_t)o->result;
    coin_force f;
    if (bits < 0)
        return;
    demand(coin_reaction(&o->world->s, &o->world->p, &f) == COIN_OK);
    demand(!(f.normal > 0) == ((bits & COIN_LIFTS) != 0));
    demand((f.normal > 0 && f.friction > o->given[4].d * f.normal) ==
           ((bits & COIN_SLIPS) != 0));
}

#define NO_PARAMS (BIT(COIN_EARG) | BIT(COIN_ESTATE))
#define CHECKED (USUAL | BIT(COIN_ESTEP))

FUNCTION(coin_angular_velocity, "s3", coin_angular_velocity(a[0].p, a[1].p),
         NO_PARAMS, 0, PLAIN)
FUNCTION(coin_energy, "sp", coin_energy(a[0].p, a[1].p), NUMBER)
FUNCTION(coin_fastest_rate, "sp", coin_fastest_rate(a[0].p, a[1].p), NUMBER)
FUNCTION(coin_integrals, "sp2", coin_integrals(a[0].p, a[1].p, a[2].p), USUAL,
         0, PLAIN)
FUNCTION(coin_reaction, "spF", coin_reaction(a[0].p, a[1].p, a[2].p), USUAL, 0,
         PLAIN)
FUNCTION(coin_rates, "spR", coin_rates(a[0].p, a[1].p, a[2].p), USUAL, 0, PLAIN)
FUNCTION(coin_center, "sp3", coin_center(a[0].p, a[1].p, a[2].p), USUAL, 0, 0,
         judge_center, 0)
FUNCTION(coin_velocity, "sp3", coin_velocity(a[0].p, a[1].p, a[2].p), USUAL, 0,
         PLAIN)
FUNCTION(coin_contact, "sp33", coin_contact(a[0].p, a[1].p, a[2].p, a[3].p),
         USUAL, 0, 0, judge_contact, 0)
FUNCTION(coin_axes, "s9", coin_axes(a[0].p, a[1].p), NO_PARAMS, 0, 0,
         judge_axes, 0)
FUNCTION(coin_quaternion, "s4", coin_quaternion(a[0].p, a[1].p), NO_PARAMS, 0,
         0, judge_quaternion, 0)
FUNCTION(coin_matrix, "spM", coin_matrix(a[0].p, a[1].p, a[2].p), USUAL, 0, 0,
         judge_matrix, 0)
FUNCTION(coin_check, "spitd",
         coin_check(a[0].p, a[1].p, a[2].i, a[3].d, a[4].d), CHECKED, 15, 0,
         judge_check, 0)
