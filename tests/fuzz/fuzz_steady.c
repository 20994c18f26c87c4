/* SPDX-License-Identifier: MIT */
/* Steady motions, and orbits. */
#include "fuzz.h"

#include <math.h>

CALL(coin_steady_roll, (a[0].p, a[1].p, a[2].d))
CALL(coin_steady_spin, (a[0].p, a[1].p, a[2].d))
CALL(coin_steady_upright_spin, (a[0].p, a[1].p, a[2].d))
CALL(coin_steady_circle, (a[0].p, a[1].p, a[2].d, a[3].d, a[4].i))
CALL(coin_steady_radii, (a[0].p, a[1].p, a[2].p, a[3].p))
CALL(coin_steady_near, (a[0].p, a[1].p, a[2].p))
CALL(coin_steady_at, (a[0].p, a[1].p, a[2].d, a[3].p))
CALL(coin_wobble_at, (a[0].p, a[1].p, a[2].p, a[3].d, a[4].p))
CALL(coin_orbit_init, (a[0].p, a[1].p, a[2].p))
CALL(coin_orbit_at, (a[0].p, a[1].d, a[2].p))
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

/* Where the coin is, and steady. */
static void judge_near(const struct outcome *o)
{
    const coin_state *s = o->left[2].p, *w = &o->world->s;
    double lambda2;
    if (o->result < 0)
        return;
    demand(s->phi == w->phi && s->psi == w->psi && s->x == w->x &&
           s->z == w->z && s->wX == 0);
    demand(coin_stability(s, &o->world->p, &lambda2) == COIN_OK);
}

/* The same motion, elsewhere on its way. */
static void judge_at(const struct outcome *o)
{
    const coin_state *s = o->left[3].p, *w = &o->world->s;
    if (o->result >= 0)
        demand(s->theta == w->theta && s->wX == 0 && s->wY == w->wY &&
               s->wZ == w->wZ);
}

#define IS_STEADY (USUAL | BIT(COIN_EDOMAIN))

const struct function fuzz_functions[] = {
    ROW(coin_steady_roll, "Opv", USUAL, 0, 0, judge_steady, 0),
    ROW(coin_steady_spin, "Opa", USUAL, 0, 0, judge_steady, 0),
    ROW(coin_steady_upright_spin, "Opv", USUAL, 0, 0, judge_steady, 0),
    ROW(coin_steady_circle, "Opavb", IS_STEADY, 0, 0, judge_steady, 0),
    ROW(coin_steady_radii, "spII", IS_STEADY, 0, PLAIN),
    ROW(coin_steady_near, "spO", IS_STEADY, 0, 0, judge_near, 0),
    ROW(coin_steady_at, "spTO", IS_STEADY | BIT(COIN_ESTEP), 0, 0, judge_at, 0),
    ROW(coin_wobble_at, "spkTO", IS_STEADY | BIT(COIN_ESTEP), 0, PLAIN),
    ROW(coin_orbit_init, "Gsp", IS_STEADY, 0, PLAIN),
    ROW(coin_orbit_at, "gTO", BIT(COIN_EARG) | BIT(COIN_ESTEP), 0, PLAIN),
    ROW(coin_stability, "sp1", IS_STEADY, 0, PLAIN),
    ROW(coin_critical_roll, "p", NUMBER),
    ROW(coin_critical_spin, "p", NUMBER),
};

END_OF_TABLE;
