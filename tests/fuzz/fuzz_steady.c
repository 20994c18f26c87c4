/* SPDX-License-Identifier: MIT */
/* Steady motions. */
#include "fuzz.h"

#include <math.h>

CALL(coin_steady_roll, (a[0].p, a[1].p, a[2].d))
CALL(coin_steady_spin, (a[0].p, a[1].p, a[2].d))
CALL(coin_steady_upright_spin, (a[0].p, a[1].p, a[2].d))
CALL(coin_steady_circle, (a[0].p, a[1].p, a[2].d, a[3].d, a[4].i))
CALL(coin_steady_radii, (a[0].p, a[1].p, a[2].p, a[3].p))
CALL(coin_stability, (a[0].p, a[1].p, a[2].p))
CALL(coin_critical_roll, (a[0].p))
CALL(coin_critical_spin, (a[0].p))

/* What was made counts as steady. */
static void judge_steady(const struct outcome *o)
{
    const coin_state *s = o->left[0].p;
    double center, contact;
    if (o->result < 0)
        return;
    demand(s->phi == 0 && s->psi == 0 && s->x == 0 && s->z == 0 && s->wX == 0);
    demand(coin_steady_radii(s, &o->world->p, &center, &contact) == COIN_OK);
}

#define IS_STEADY (USUAL | BIT(COIN_EDOMAIN))

const struct function fuzz_functions[] = {
    ROW(coin_steady_roll, "Opv", USUAL, 0, 0, judge_steady, 0),
    ROW(coin_steady_spin, "Opa", USUAL, 0, 0, judge_steady, 0),
    ROW(coin_steady_upright_spin, "Opv", USUAL, 0, 0, judge_steady, 0),
    ROW(coin_steady_circle, "Opavb", IS_STEADY, 0, 0, judge_steady, 0),
    ROW(coin_steady_radii, "spII", IS_STEADY, 0, PLAIN),
    ROW(coin_stability, "sp1", IS_STEADY, 0, PLAIN),
    ROW(coin_critical_roll, "p", NUMBER),
    ROW(coin_critical_spin, "p", NUMBER),
};

END_OF_TABLE;
