/* SPDX-License-Identifier: MIT */
/* Steady motions, and orbits. */
#include "fuzz.h"

#include <math.h>

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

FUNCTION(coin_steady_roll, "Opv", coin_steady_roll(a[0].p, a[1].p, a[2].d),
         USUAL, 0, 0, judge_steady, 0)
FUNCTION(coin_steady_spin, "Opa", coin_steady_spin(a[0].p, a[1].p, a[2].d),
         USUAL, 0, 0, judge_steady, 0)
FUNCTION(coin_steady_upright_spin, "Opv",
         coin_steady_upright_spin(a[0].p, a[1].p, a[2].d), USUAL, 0, 0,
         judge_steady, 0)
FUNCTION(coin_steady_circle, "Opavb",
         coin_steady_circle(a[0].p, a[1].p, a[2].d, a[3].d, a[4].i), IS_STEADY,
         0, 0, judge_steady, 0)
FUNCTION(coin_steady_turn, "Opa~",
         coin_steady_turn(a[0].p, a[1].p, a[2].d, a[3].d), IS_STEADY, 0, 0,
         judge_turn, 0)
FUNCTION(coin_steady_ride, "Op^~",
         coin_steady_ride(a[0].p, a[1].p, a[2].d, a[3].d), IS_STEADY, 0, 0,
         judge_turn, 0)
FUNCTION(coin_steady_radii, "spII",
         coin_steady_radii(a[0].p, a[1].p, a[2].p, a[3].p), IS_STEADY, 0, 0,
         judge_is_steady, 0)
FUNCTION(coin_steady_at, "spTO", coin_steady_at(a[0].p, a[1].p, a[2].d, a[3].p),
         IS_STEADY | BIT(COIN_ESTEP) | BIT(COIN_ERANGE), 0, 0, judge_at, 0)
FUNCTION(coin_orbit_init, "Ysp", coin_orbit_init(a[0].p, a[1].p, a[2].p),
         IS_STEADY, 0, PLAIN)
FUNCTION(coin_orbit_at, "yTV", coin_orbit_at(a[0].p, a[1].d, a[2].p),
         BIT(COIN_EARG) | BIT(COIN_ESTEP) | BIT(COIN_ERANGE), 0, PLAIN)
FUNCTION(coin_stability, "sp1", coin_stability(a[0].p, a[1].p, a[2].p),
         IS_STEADY, 0, 0, judge_is_steady, 0)
FUNCTION(coin_critical_roll, "p", coin_critical_roll(a[0].p), NUMBER)
FUNCTION(coin_critical_spin, "p", coin_critical_spin(a[0].p), NUMBER)
