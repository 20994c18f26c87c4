/* SPDX-License-Identifier: MIT */
/* Version, parameters, states, methods' names. */
#include "fuzz.h"

#include <string.h>

CALL(coin_version, ())
CALL(coin_params_disc, (a[0].p, a[1].d, a[2].d, a[3].d))
CALL(coin_params_ring, (a[0].p, a[1].d, a[2].d, a[3].d, a[4].d))
CALL(coin_params_body, (a[0].p, a[1].d, a[2].d, a[3].d, a[4].d, a[5].d))
CALL(coin_params_check, (a[0].p))
CALL(coin_state_check, (a[0].p, a[1].p))
CALL(coin_state_from_motion, (a[0].p, a[1].p, a[2].p, a[3].p, a[4].d, a[5].d))

/* Texts count as done if there is one. */
static double text(const char *t)
{
    return t && strlen(t) > 2 ? COIN_OK : COIN_EARG;
}

CALL_AS(coin_version_string, text, (coin_version_string()))
CALL_AS(coin_status_string, text, (coin_status_string(a[0].i)))
CALL_AS(coin_method_name, text, (coin_method_name(a[0].i)))

/* 0 counts as an error. */
static double size_of(const char *type)
{
    return coin_sizeof(type) > 0 ? COIN_OK : COIN_EARG;
}
CALL_AS(coin_sizeof, size_of, (a[0].p))

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

const struct function fuzz_functions[] = {
    ROW(coin_version, "", 0, INT32_MAX, PLAIN),
    ROW(coin_version_string, "", 0, 0, PLAIN),
    ROW(coin_status_string, "i", 0, 0, PLAIN),
    ROW(coin_sizeof, "$", BIT(COIN_EARG), 0, PLAIN),
    ROW(coin_params_disc, "Pddd", MAKES, 0, PLAIN),
    ROW(coin_params_ring, "Pdddd", MAKES, 0, PLAIN),
    ROW(coin_params_body, "Pddddd", MAKES, 0, PLAIN),
    ROW(coin_params_check, "p", MAKES, 0, PLAIN),
    ROW(coin_state_check, "sp", USUAL, 0, PLAIN),
    ROW(coin_state_from_motion, "Opqwdd", USUAL, 0, 0, judge_from_motion, 0),
    ROW(coin_method_name, "i", BIT(COIN_EARG), 0, 0, judge_method, 0),
};

END_OF_TABLE;
