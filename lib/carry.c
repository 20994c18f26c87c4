/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "stepper.h"

void coin_priv_carry_begin(coin_priv_carry *c, const coin_state *s)
{
    const coin_priv_stage y = coin_priv_stage_of(s);
    const coin_priv_carry begun = {
        {y, {s->phi, 0, 0, 0, 0}, s->theta, s->wY * y.cth, 0},
        {s->psi, 0},
        {-y.sth * y.sph, 0}, /* (21) */
        {-y.sth * y.cph, 0}, /* (21) */
        0,
    };
    *c = begun;
}

double coin_priv_heading(const coin_priv_stage *y, double phi)
{
    const double sph = y->sph, cph = y->cph;
    const coin_priv_sc by = coin_priv_sincos(phi);
    /* A coarse step leaves the pair's norm a little off 1. */
    const double norm = sqrt(sph * sph + cph * cph);
    const coin_priv_sc ahead = {
        (sph * by.c - cph * by.s) / norm,
        (cph * by.c + sph * by.s) / norm,
    };
    return phi + coin_priv_angle(ahead);
}

void coin_priv_settle(coin_priv_carry *c, coin_priv_moment *at)
{
    at->pose.phi = coin_priv_heading(&at->y, at->pose.phi);
    coin_priv_add(&c->psi, at->pose.psi);
    coin_priv_add(&c->x, at->pose.x);
    coin_priv_add(&c->z, at->pose.z);
    at->pose.psi = at->pose.x = at->pose.z = 0;
}

double coin_priv_lean(double sth, double cth)
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
    const coin_priv_stage *y = &c->at.y;
    const coin_priv_pose *pose = &c->at.pose;
    const double dx =
        coin_priv_total(c->x, pose->x) + y->sth * y->sph; /* (21) */
    const double dz =
        coin_priv_total(c->z, pose->z) + y->sth * y->cph; /* (21) */
    const coin_state s = {
        coin_priv_lean(y->sth, y->cth),
        coin_priv_heading(y, pose->phi),
        coin_priv_total(c->psi, pose->psi),
        start->x + b->a * dx,
        start->z + b->a * dz,
        y->wX,
        y->wY,
        y->wZ,
    };
    return s;
}
