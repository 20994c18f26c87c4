/* SPDX-License-Identifier: MIT */
/* From a state to a coin under way, and back. */
#include "../motion/pinned.h"

#include "../motion/state.h"

#include "move.h"

void coin_priv_scale(coin_state *s, double length, double rate)
{
    s->x *= length;
    s->z *= length;
    s->wX *= rate;
    s->wY *= rate;
    s->wZ *= rate;
}

void coin_priv_set_state(coin_priv_coin *c, const coin_state *s, double half)
{
    const coin_priv_variables v = coin_priv_variables_of(s);
    const coin_priv_coin made = {
        s->wX,
        s->wY,
        s->wZ,
        {v.sth, v.cth},
        {v.sph, v.cph},
        half,
        0,
        0,
        0,
        0,
        {s->phi, 0},
        {s->psi, 0},
        {s->x, 0},
        {s->z, 0},
    };
    *c = made;
    coin_priv_set_upright(c);
}

void coin_priv_get_state(coin_state *s, const coin_priv_coin *c)
{
    s->theta = coin_priv_lean_clamped(coin_priv_angle(c->th));
    s->phi = c->phi.sum + c->phi.low;
    s->psi = c->psi.sum + c->psi.low;
    s->x = c->x.sum + c->x.low;
    s->z = c->z.sum + c->z.low;
    s->wX = c->wX;
    s->wY = c->wY;
    s->wZ = c->wZ;
}

void coin_priv_set_rolling(coin_priv_coin *c, double eta)
{
    const coin_priv_lever d = coin_priv_lever_of(c->th.s, c->th.c, eta);
    const double vX = -(c->wZ + eta * c->wY), vh = d.Y * c->wX; /* (119) */
    c->y = d.Y;
    c->vx = vh * c->ph.s + vX * c->ph.c;
    c->vy = -(c->wX * d.P); /* (119) */
    c->vz = vh * c->ph.c - vX * c->ph.s;
}

void coin_priv_set_contact(coin_priv_coin *c, const double *y, double eta)
{
    const double uX = y[COIN_PRIV_UX], uh = y[COIN_PRIV_UH];
    const coin_priv_sc th = {y[COIN_PRIV_S], y[COIN_PRIV_C]};
    const coin_priv_sc ph = {y[COIN_PRIV_SPH], y[COIN_PRIV_CPH]};
    c->wX = y[COIN_PRIV_WX];
    c->wY = y[COIN_PRIV_WY];
    c->wZ = y[COIN_PRIV_WZ];
    c->th = th;
    c->ph = ph;
    coin_priv_set_rolling(c, eta);
    c->vx += uX * ph.c + uh * ph.s;
    c->vz += uh * ph.c - uX * ph.s;
}

void coin_priv_begin_call(coin_priv_moving *g, double time, double tol,
                          int tries)
{
    g->time = time;
    g->tol = tol;
    g->tries = tries;
    g->moved.sum = g->moved.low = 0;
    g->stop = g->found = 0;
    g->was = -1;
    g->changed = 0;
}

void coin_priv_begin(coin_priv_moving *g, int mode, const double u[2])
{
    const coin_priv_coin *const c = &g->c;
    double *const y = g->step.y;
    for (int i = 0; i < COIN_PRIV_WIDE; ++i)
        y[i] = 0;
    y[COIN_PRIV_WX] = c->wX;
    y[COIN_PRIV_WY] = c->wY;
    y[COIN_PRIV_WZ] = c->wZ;
    y[COIN_PRIV_S] = c->th.s;
    y[COIN_PRIV_C] = c->th.c;
    y[COIN_PRIV_UX] = u[0];
    y[COIN_PRIV_UH] = u[1];
    y[COIN_PRIV_SPH] = c->ph.s;
    y[COIN_PRIV_CPH] = c->ph.c;
    g->step.of.law = &g->law;
    g->step.of.by_t = 0;
    g->mode = mode;
    g->margin = g->stride = g->slow = 0;
}

/* How far the heading of the variables is ahead of this one. */
static double ahead(const double *y, coin_priv_sc ph)
{
    const double sph = y[COIN_PRIV_SPH], cph = y[COIN_PRIV_CPH];
    const coin_priv_sc by = {sph * ph.c - cph * ph.s, cph * ph.c + sph * ph.s};
    return coin_priv_angle(by);
}

void coin_priv_end(coin_priv_moving *g)
{
    coin_priv_coin *const c = &g->c;
    double *const y = g->step.y;
    coin_priv_sc ph = coin_priv_sincos(c->phi.sum + c->phi.low);
    if (coin_priv_pull(&g->law) > 0) { /* the force depends on the heading */
        coin_priv_add(&c->phi, ahead(y, ph));
        ph = coin_priv_sincos(c->phi.sum + c->phi.low);
    }
    y[COIN_PRIV_SPH] = ph.s;
    y[COIN_PRIV_CPH] = ph.c;
    coin_priv_set_contact(c, y, g->law.eta);
}

double coin_priv_reached(const coin_priv_moving *g, double time, double t,
                         double w0)
{
    const double r = (g->moved.sum + g->moved.low) / w0;
    return g->moved.sum == time ? t : coin_priv_lesser(r, t);
}
