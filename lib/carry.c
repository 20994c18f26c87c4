/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "stepper.h"

coin_priv_carry coin_priv_carry_of(const coin_state *s)
{
    coin_priv_carry c = {
        .y = coin_priv_stage_of(s),
        .pose = {.phi = s->phi, .psi = s->psi},
        .theta = s->theta,
    };
    c.p = s->wY * c.y.cth;
    return c;
}

double coin_priv_heading(const coin_priv_carry *c)
{
    const double sph = c->y.sph, cph = c->y.cph;
    const coin_priv_sc at = coin_priv_sincos(c->pose.phi);
    const coin_priv_sc ahead = {
        sph * at.c - cph * at.s,
        cph * at.c + sph * at.s,
    };
    return c->pose.phi + coin_priv_angle(ahead);
}

/* A lean below pi/2 for a pair with c > 0, however small c is. */
static double lean_of(double sth, double cth)
{
    const coin_priv_sc pair = {sth, cth};
    const double theta = coin_priv_angle(pair);
    const double least = COIN_PRIV_HALF_PI - DBL_EPSILON;
    return theta > least ? least : theta < -least ? -least : theta;
}

coin_state coin_priv_state_of(const coin_priv_carry *c, const coin_priv_body *b,
                              const coin_state *start)
{
    if (c->steps == 0)
        return *start;
    const coin_priv_stage *y = &c->y;
    const coin_priv_frame f = coin_priv_frame_of(start);
    /* From the contact's path to the centre's: a sin theta e_h at both ends.
     */
    const double dx = c->pose.x + (y->sth * y->sph - f.sth * f.sph); /* (21) */
    const double dz = c->pose.z + (y->sth * y->cph - f.sth * f.cph); /* (21) */
    const coin_state s = {
        .theta = lean_of(y->sth, y->cth),
        .phi = coin_priv_heading(c),
        .psi = c->pose.psi,
        .x = start->x + b->a * dx,
        .z = start->z + b->a * dz,
        .wX = y->wX,
        .wY = y->wY,
        .wZ = y->wZ,
    };
    return s;
}
