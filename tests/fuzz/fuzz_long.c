/* SPDX-License-Identifier: MIT */
/* Calls that take many steps. */
#include "fuzz.h"

static void judge_advance(const struct outcome *o)
{
    const double reached = reached_by(o, 2, 4);
    demand(o->result != COIN_OK || reached == o->given[2].d);
    demand(o->result != COIN_MORE || reached != o->given[2].d);
}

#define LANDS (BIT(COIN_ERANGE) | BIT(COIN_EFLAT))

FUNCTION(coin_advance, "SpTer",
         coin_advance(a[0].p, a[1].p, a[2].d, a[3].d, a[4].p),
         USUAL | BIT(COIN_ESTEP) | LANDS, COIN_MORE, LANDS, judge_advance, 0)
FUNCTION(coin_selftest, "", coin_selftest(), 0, 0, PLAIN)
