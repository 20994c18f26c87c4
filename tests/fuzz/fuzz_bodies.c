/* SPDX-License-Identifier: MIT */
/* Version, parameters, states, methods' names. */
#include "fuzz.h"

#include <string.h>

/* Texts count as done if there is one. */
static double text(const char *t)
{
    return t && strlen(t) > 2 ? COIN_OK : COIN_EARG;
}

/* 0 counts as an error. */
static double size_of(const char *type)
{
    return coin_sizeof(type) > 0 ? COIN_OK : COIN_EARG;
}

/* Exactly the four methods have a name. */
static void judge_method(const struct outcome *o)
{
    const int32_t method = o->given[0].i;
    demand((method >= 0 && method <= 3) == (o->result >= 0));
}

/* Angles within half a turn, and the centre as given. */
static void judge_from_motion(const struct outcome *o)
{
    const coin_state *s = o->left[0].p;
    const double pi = 2 * 1.5707963267948966;
    if (o->result < 0)
        return;
    demand(s->phi > -pi && s->phi <= pi && s->psi > -pi && s->psi <= pi);
    demand(same(&s->x, &o->given[4].d, sizeof s->x));
    demand(same(&s->z, &o->given[5].d, sizeof s->z));
}

#define MAKES (BIT(COIN_EARG) | BIT(COIN_EPARAMS))

FUNCTION(coin_version, "", coin_version(), 0, INT32_MAX, PLAIN)
FUNCTION(coin_version_string, "", text(coin_version_string()), 0, 0, PLAIN)
FUNCTION(coin_status_string, "i", text(coin_status_string(a[0].i)), 0, 0, PLAIN)
FUNCTION(coin_sizeof, "$", size_of(a[0].p), BIT(COIN_EARG), 0, PLAIN)
FUNCTION(coin_params_disc, "Pddd",
         coin_params_disc(a[0].p, a[1].d, a[2].d, a[3].d), MAKES, 0, PLAIN)
FUNCTION(coin_params_ring, "Pdddd",
         coin_params_ring(a[0].p, a[1].d, a[2].d, a[3].d, a[4].d), MAKES, 0,
         PLAIN)
FUNCTION(coin_params_body, "Pddddd",
         coin_params_body(a[0].p, a[1].d, a[2].d, a[3].d, a[4].d, a[5].d),
         MAKES, 0, PLAIN)
FUNCTION(coin_params_cylinder, "Pdddd",
         coin_params_cylinder(a[0].p, a[1].d, a[2].d, a[3].d, a[4].d), MAKES, 0,
         PLAIN)
FUNCTION(coin_params_check, "p", coin_params_check(a[0].p), MAKES, 0, PLAIN)
FUNCTION(coin_state_check, "sp", coin_state_check(a[0].p, a[1].p), USUAL, 0,
         PLAIN)
FUNCTION(coin_state_from_motion, "Opqwdd",
         coin_state_from_motion(a[0].p, a[1].p, a[2].p, a[3].p, a[4].d, a[5].d),
         USUAL, 0, 0, judge_from_motion, 0)
FUNCTION(coin_method_name, "i", text(coin_method_name(a[0].i)), BIT(COIN_EARG),
         0, 0, judge_method, 0)
