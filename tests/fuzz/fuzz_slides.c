/* SPDX-License-Identifier: MIT */
/* Real coins. */
#include "fuzz.h"

#include <float.h>
#include <math.h>

/* Friction and losses take energy: what is gained is error.  A step errs by tol
 * per natural unit of time, in units of the energy or of Mga. */
static void no_energy_is_gained(const struct outcome *o)
{
    const coin_params *p = &o->world->p;
    const double units = o->given[3].d * sqrt(p->gravity / p->radius);
    const double before = coin_body_energy(o->given[0].p, p);
    const double after = coin_body_energy(o->left[0].p, p);
    const double Mga = p->mass * p->gravity * p->radius;
    const double error = 10 * o->given[4].d * (1 + units) + 1e-12;
    demand(after - before <= error * (before + Mga));
}

/* A body is what its status says.  The normal speed of a coin that touches is
 * that of its lean, of one that comes down it is downward. */
static void it_is_what_it_says(const coin_body *d, const coin_params *p,
                               int32_t mode)
{
    const double a = p->radius, v = sqrt(p->gravity * a), u = DBL_EPSILON / 2;
    const double above = d->y - a * cos(d->s.theta);
    const double speed = a * d->s.wX * sin(d->s.theta), size = fabs(speed) + v;
    demand(above >= -20 * u * a);
    if (mode & COIN_TOUCHES && mode & COIN_LIFTS)
        demand(above <= 20 * u * a && d->vy + speed <= 1e-10 * size);
    if (mode & COIN_LIFTS)
        return;
    demand(above <= 20 * u * a);
    if (!(mode & COIN_RESTS))
        demand(fabs(d->vy + speed) <= 8 * u * size);
}

static void judge_move(const struct outcome *o)
{
    const double t = o->given[3].d;
    const int32_t stop = o->given[5].i;
    const coin_body *d = o->left[0].p;
    const double reached = reached_by(o, 3, 6);
    if (isnan(reached))
        return;
    no_energy_is_gained(o);
    const int32_t mode = (int32_t)o->result;
    if (mode >= 0 && reached > 0)
        it_is_what_it_says(d, &o->world->p, mode);
    if (mode >= 0 && !(mode & (COIN_RESTS | COIN_LIFTS | stop)))
        demand(reached == t);
    if (mode == COIN_RESTS && reached > 0)
        demand(d->s.wX == 0 && d->s.wY == 0 && d->s.wZ == 0 && d->vx == 0 &&
               d->vy == 0 && d->vz == 0 && fabs(d->s.theta) > 1.57);
    if (mode == COIN_OK && t > 0) {
        double v[3];
        demand(coin_velocity(&d->s, &o->world->p, v) == COIN_OK);
        demand(d->vx == v[0] && d->vy == v[1] && d->vz == v[2]);
    }
}

#define MODES                                                                  \
    (COIN_SLIPS | COIN_LIFTS | COIN_NEARLY_FLAT | COIN_RESTS | COIN_ROLLS |    \
     COIN_TOUCHES)

FUNCTION(coin_table_check, "%p", coin_table_check(a[0].p, a[1].p),
         BIT(COIN_EARG) | BIT(COIN_EPARAMS), 0, PLAIN)
FUNCTION(coin_body_from_state, ">sp",
         coin_body_from_state(a[0].p, a[1].p, a[2].p), USUAL, 0, PLAIN)
FUNCTION(coin_body_from_motion, ">pqw--",
         coin_body_from_motion(a[0].p, a[1].p, a[2].p, a[3].p, a[4].p, a[5].p),
         USUAL, 0, PLAIN)
FUNCTION(coin_move, "=p%Texr",
         coin_move(a[0].p, a[1].p, a[2].p, a[3].d, a[4].d, a[5].i, a[6].p),
         USUAL | STOPS, MODES, STOPS, judge_move, 0)
FUNCTION(coin_body_energy, "<p", coin_body_energy(a[0].p, a[1].p), NUMBER)
FUNCTION(coin_body_reaction, "<p%F",
         coin_body_reaction(a[0].p, a[1].p, a[2].p, a[3].p), USUAL, 0, PLAIN)
FUNCTION(coin_body_slip, "<p2", coin_body_slip(a[0].p, a[1].p, a[2].p), USUAL,
         0, PLAIN)
FUNCTION(coin_body_matrix, "<pM", coin_body_matrix(a[0].p, a[1].p, a[2].p),
         USUAL, 0, PLAIN)
