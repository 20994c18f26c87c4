/* SPDX-License-Identifier: MIT */
/* Real coins. */
#include "fuzz.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* What the rounding of places makes of the potential of a pull. */
static double rounding_of(const coin_state *s, const coin_table *f, double mass)
{
    return 2 * DBL_EPSILON * mass *
           (fabs(f->pull[0] * s->x) + fabs(f->pull[1] * s->z));
}

/* Friction and losses take energy: what is gained is error.  A step errs by tol
 * per natural unit of time, in units of the energy or of Mga. */
static void no_energy_is_gained(const struct outcome *o)
{
    const coin_params *p = &o->world->p;
    const double units = o->given[3].d * sqrt(p->gravity / p->radius);
    const coin_table *f = o->given[2].p;
    const coin_body *b = o->given[0].p, *d = o->left[0].p;
    const double pulled = p->mass * (f->pull[0] * (d->s.x - b->s.x) +
                                     f->pull[1] * (d->s.z - b->s.z));
    const double before = coin_body_energy(b, p) + fmax(pulled, 0);
    const double after = coin_body_energy(d, p) + fmax(-pulled, 0);
    const double Mga = p->mass * p->gravity * p->radius;
    const double error = 10 * o->given[4].d * (1 + units) + 1e-12;
    demand(after - before <= error * (before + Mga) +
                                 rounding_of(&b->s, f, p->mass) +
                                 rounding_of(&d->s, f, p->mass));
}

/* Whether a coin is upright: one with a thickness, to rounding of its height.
 */
static int stands(const coin_body *d, const coin_params *p)
{
    const double low = p->thickness * fabs(sin(d->s.theta));
    return d->s.theta == 0 ||
           (p->thickness > 0 && low <= 4 * DBL_EPSILON * p->radius);
}

/* Whether nothing moves.  What underflows in natural units may stay. */
static int rests(const coin_body *d)
{
    const double sum = fabs(d->s.wX) + fabs(d->s.wY) + fabs(d->s.wZ) +
                       fabs(d->vx) + fabs(d->vy) + fabs(d->vz);
    return sum < 1e-300;
}

/* A body is what its status says.  The normal speed of a coin that touches is
 * that of its lean, of one that comes down it is downward. */
static void it_is_what_it_says(const coin_body *d, const coin_params *p,
                               int32_t mode)
{
    const double a = p->radius, v = sqrt(p->gravity * a), u = DBL_EPSILON / 2;
    const double s = stands(d, p) ? 0 : sin(d->s.theta), c = cos(d->s.theta);
    const double half = p->thickness / 2;
    const double lower = s != 0 ? s : d->s.wX;
    const double eta = lower > 0 ? half : lower < 0 ? -half : 0;
    const double above = d->y - a * c - half * fabs(s);
    const double speed = d->s.wX * (a * s - eta * c), size = fabs(speed) + v;
    demand(above >= -20 * u * (a + half));
    if (mode & COIN_TOUCHES && mode & COIN_LIFTS)
        demand(above <= 20 * u * (a + half) && d->vy + speed <= 1e-10 * size);
    if (mode & COIN_LIFTS)
        return;
    demand(above <= 20 * u * (a + half));
    if (!(mode & COIN_RESTS))
        demand(fabs(d->vy + speed) <= 8 * u * (size + half * fabs(d->s.wX)));
}

static void it_rolls(const coin_body *d, const coin_params *p)
{
    double v[3];
    if (p->thickness != 0)
        return;
    demand(coin_velocity(&d->s, p, v) == COIN_OK);
    demand(d->vx == v[0] && d->vy == v[1] && d->vz == v[2]);
}

/* What a call of no time says of the body that a call left: its mode alone,
 * whatever `stop` is, and it changes nothing. */
static int32_t mode_of(const struct outcome *o, int32_t stop)
{
    coin_body d;
    double reached = 1;
    memcpy(&d, o->left[0].p, sizeof d);
    const int32_t mode = coin_move(&d, &o->world->p, o->given[2].p, 0,
                                   o->given[4].d, stop, &reached);
    demand(same(&d, o->left[0].p, sizeof d) && reached == 0);
    demand(mode == COIN_OK || mode == COIN_SLIPS || mode == COIN_LIFTS ||
           mode == COIN_RESTS);
    return mode;
}

static void judge_move(const struct outcome *o)
{
    const double t = o->given[3].d, reached = reached_by(o, 3, 6);
    const int32_t stop = o->given[5].i, status = (int32_t)o->result;
    const coin_body *d = o->left[0].p;
    const int moved = !same(d, o->given[0].p, sizeof *d);
    if (isnan(reached))
        return;
    no_energy_is_gained(o);
    const int32_t mode = mode_of(o, 0);
    demand(mode == mode_of(o, stop));
    if (status < 0)
        return;
    demand((status & mode) == mode && !(status & ~(mode | stop | COIN_MORE)));
    if (!(status & (COIN_RESTS | COIN_MORE | stop)))
        demand(reached == t);
    if (status & COIN_MORE)
        demand(reached < t);
    if (status & COIN_ROLLS)
        demand(mode == COIN_OK);
    if (status & COIN_TOUCHES)
        demand(mode == COIN_LIFTS);
    if (moved)
        it_is_what_it_says(d, &o->world->p, status);
    if (mode == COIN_RESTS && t > 0)
        demand(rests(d) &&
               (stands(d, &o->world->p) || fabs(d->s.theta) > 1.57));
    if (mode == COIN_OK && !(status & COIN_SLIPS) && moved)
        it_rolls(d, &o->world->p);
}

#define MODES                                                                  \
    (COIN_SLIPS | COIN_LIFTS | COIN_NEARLY_FLAT | COIN_RESTS | COIN_ROLLS |    \
     COIN_TOUCHES | COIN_MORE | COIN_DECIDED)

FUNCTION(coin_table_check, "%p", coin_table_check(a[0].p, a[1].p),
         BIT(COIN_EARG) | BIT(COIN_EPARAMS), 0, PLAIN)
FUNCTION(coin_body_from_state, ">sp",
         coin_body_from_state(a[0].p, a[1].p, a[2].p), USUAL, 0, PLAIN)
FUNCTION(coin_body_from_motion, ">pqw--",
         coin_body_from_motion(a[0].p, a[1].p, a[2].p, a[3].p, a[4].p, a[5].p),
         USUAL, 0, PLAIN)
FUNCTION(coin_move, "=p%Texr",
         coin_move(a[0].p, a[1].p, a[2].p, a[3].d, a[4].d, a[5].i, a[6].p),
         USUAL | STOPS, MODES, BIT(COIN_ERANGE), judge_move, 0)
FUNCTION(coin_body_energy, "<p", coin_body_energy(a[0].p, a[1].p), NUMBER)
FUNCTION(coin_body_reaction, "<p%F",
         coin_body_reaction(a[0].p, a[1].p, a[2].p, a[3].p), USUAL, 0, PLAIN)
FUNCTION(coin_body_contact, "<p3", coin_body_contact(a[0].p, a[1].p, a[2].p),
         USUAL, 0, PLAIN)
FUNCTION(coin_body_matrix, "<pM", coin_body_matrix(a[0].p, a[1].p, a[2].p),
         USUAL, 0, PLAIN)
FUNCTION(coin_body_strike, "=pw-",
         coin_body_strike(a[0].p, a[1].p, a[2].p, a[3].p), USUAL, 0, PLAIN)
FUNCTION(coin_body_face, "<p", coin_body_face(a[0].p, a[1].p), USUAL,
         COIN_HEADS | COIN_TAILS, PLAIN)
