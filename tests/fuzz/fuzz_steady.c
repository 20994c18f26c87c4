/* SPDX-License-Identifier: MIT */
/* Steady motions, and orbits. */
#include "fuzz.h"

#include <math.h>

CALL(coin_steady_roll, (a[0].p, a[1].p, a[2].d))
CALL(coin_steady_spin, (a[0].p, a[1].p, a[2].d))
CALL(coin_steady_upright_spin, (a[0].p, a[1].p, a[2].d))
CALL(coin_steady_circle, (a[0].p, a[1].p, a[2].d, a[3].d, a[4].i))
CALL(coin_steady_turn, (a[0].p, a[1].p, a[2].d, a[3].d))
CALL(coin_steady_ride, (a[0].p, a[1].p, a[2].d, a[3].d))
CALL(coin_steady_radii, (a[0].p, a[1].p, a[2].p, a[3].p))
CALL(coin_steady_at, (a[0].p, a[1].p, a[2].d, a[3].p))
CALL(coin_orbit_init, (a[0].p, a[1].p, a[2].p))
CALL(coin_orbit_at, (a[0].p, a[1].d, a[2].p))
CALL(coin_stability, (a[0].p, a[1].p, a[2].p))
CALL(coin_critical_roll, (a[0].p))
CALL(coin_critical_spin, (a[0].p))

/* Eq. (39), to the 1e-9 of its largest term that steady means: what rounds here
 * besides is far below. */
static int is_steady(const coin_state *s, const coin_params *p)
{
    const double m = p->mass * p->radius * p->radius;
    const double wY = s->wY, wZ = s->wZ, sth = sin(s->theta);
    const double roll = (p->inertia_Z + m) * wZ * wY;
    const double turn = p->inertia_X * wY * wY * (sth / cos(s->theta));
    const double weight = p->mass * p->gravity * p->radius;
    const double most = fmax(fmax(fabs(roll), fabs(turn)), weight);
    return s->wX == 0 && fabs(roll + turn - weight * sth) <= 1.001e-9 * most;
}

/* What was made is steady, at the origin. */
static void judge_steady(const struct outcome *o)
{
    const coin_state *s = o->left[0].p;
    if (o->result < 0)
        return;
    demand(s->phi == 0 && s->psi == 0 && s->x == 0 && s->z == 0);
    demand(is_steady(s, &o->world->p));
}

/* Besides, it turns to the left and rolls to the side that it leans to.  wY^2
 * is in proportion to a small lean: next to the least double it may be 0. */
static void judge_turn(const struct outcome *o)
{
    const coin_state *s = o->left[0].p;
    judge_steady(o);
    if (o->result >= 0)
        demand((s->wY > 0 || fabs(s->theta) < 1e-300) &&
               (s->theta < 0 ? s->wZ <= 0 : s->wZ >= 0));
}

/* Only of a steady motion can these be told. */
static void judge_is_steady(const struct outcome *o)
{
    coin_state s = o->world->s;
    s.wX = 0; /* may be a billionth of the rates */
    if (o->result >= 0)
        demand(is_steady(&s, &o->world->p));
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
    ROW(coin_steady_turn, "Opa~", IS_STEADY, 0, 0, judge_turn, 0),
    ROW(coin_steady_ride, "Op^~", IS_STEADY, 0, 0, judge_turn, 0),
    ROW(coin_steady_radii, "spII", IS_STEADY, 0, 0, judge_is_steady, 0),
    ROW(coin_steady_at, "spTO", IS_STEADY | BIT(COIN_ESTEP) | BIT(COIN_ERANGE),
        0, 0, judge_at, 0),
    ROW(coin_orbit_init, "Ysp", IS_STEADY, 0, PLAIN),
    ROW(coin_orbit_at, "yTV",
        BIT(COIN_EARG) | BIT(COIN_ESTEP) | BIT(COIN_ERANGE), 0, PLAIN),
    ROW(coin_stability, "sp1", IS_STEADY, 0, 0, judge_is_steady, 0),
    ROW(coin_critical_roll, "p", NUMBER),
    ROW(coin_critical_spin, "p", NUMBER),
};

END_OF_TABLE;
