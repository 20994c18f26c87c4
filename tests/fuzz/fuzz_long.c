/* SPDX-License-Identifier: MIT */
/* Calls that take many steps. */
#include "fuzz.h"

#include <math.h>
#include <string.h>

CALL(coin_selftest, ())
CALL(coin_advance, (a[0].p, a[1].p, a[2].d, a[3].d, a[4].p))
/* After an error on the way: somewhere between here and t, and sound. */
static void judge_advance(const struct outcome *o)
{
    const double t = o->given[2].d;
    const coin_state *s = o->left[0].p;
    double reached;
    memcpy(&reached, o->left[4].p, sizeof reached);
    const int untouched =
        o->result < 0 && same(&reached, o->given[4].p, sizeof reached);
    if (untouched)
        demand(same(s, &o->world->s, sizeof *s));
    else if (o->result == COIN_OK)
        demand(reached == t);
    else if (o->result == COIN_EFLAT || o->result == COIN_ESTEP ||
             o->result == COIN_ERANGE)
        demand(fabs(reached) <= fabs(t) && reached * t >= 0 &&
               coin_state_check(s, &o->world->p) == COIN_OK);
}

#define LANDS (STOPS | BIT(COIN_EFLAT))

const struct function fuzz_functions[] = {
    ROW(coin_advance, "SpTer", USUAL | LANDS, 0, LANDS, judge_advance, 0),
    ROW(coin_selftest, "", 0, 0, PLAIN),
};

END_OF_TABLE;
