/* SPDX-License-Identifier: MIT */
/* Coins that slip. */
#include "fuzz.h"

#include <math.h>
#include <string.h>

CALL(coin_slide_of, (a[0].p, a[1].p, a[2].p))
CALL(coin_slide_advance,
     (a[0].p, a[1].p, a[2].p, a[3].p, a[4].d, a[5].d, a[6].p))
CALL(coin_slide_energy, (a[0].p, a[1].p))
CALL(coin_slide_reaction, (a[0].p, a[1].p, a[2].p, a[3].p, a[4].p))
CALL(coin_slide_velocity, (a[0].p, a[1].p, a[2].p))

/* Friction and losses take energy: what is gained is error.  A step errs by tol
 * per natural unit of time, in units of the energy or of Mga. */
static void no_energy_is_gained(const struct outcome *o)
{
    const coin_params *p = &o->world->p;
    const double units = o->given[4].d * sqrt(p->gravity / p->radius);
    const double before = coin_slide_energy(o->given[0].p, p);
    const double after = coin_slide_energy(o->left[0].p, p);
    const double Mga = p->mass * p->gravity * p->radius;
    const double error = 10 * o->given[5].d * (1 + units) + 1e-12;
    demand(after - before <= error * (before + Mga));
}

/* As of coin_settle(); a lift-off keeps the progress made. */
static void judge_advance(const struct outcome *o)
{
    const double t = o->given[4].d;
    const coin_slide *d = o->left[0].p;
    double reached;
    memcpy(&reached, o->left[6].p, sizeof reached);
    const int untouched =
        o->result < 0 && same(&reached, o->given[6].p, sizeof reached);
    if (untouched)
        return;
    no_energy_is_gained(o);
    if (o->result == COIN_OK || o->result == COIN_SLIPS)
        demand(reached == t);
    else
        demand(reached >= 0 && reached <= t &&
               coin_state_check(&d->s, &o->world->p) == COIN_OK);
    if (o->result == COIN_RESTS)
        demand(d->s.wY == 0 && d->s.wX * d->s.theta >= 0 &&
               fabs(d->s.theta) > 1.57);
}

#define ENDS (STOPS | BIT(COIN_ELIFT))

const struct function fuzz_functions[] = {
    ROW(coin_slide_of, ">sp", USUAL, 0, PLAIN),
    ROW(coin_slide_advance, "=p%-Ter", USUAL | ENDS, COIN_SLIPS | COIN_RESTS,
        ENDS, judge_advance, 0),
    ROW(coin_slide_energy, "<p", NUMBER),
    ROW(coin_slide_reaction, "<p%-F", USUAL, 0, PLAIN),
    ROW(coin_slide_velocity, "<p2", USUAL, 0, PLAIN),
};

END_OF_TABLE;
