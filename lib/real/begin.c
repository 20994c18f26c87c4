/* SPDX-License-Identifier: MIT */
/* From a state to a coin under way, and back. */
#include "../motion/pinned.h"

#include "../motion/rest.h"

#include "move.h"

void coin_priv_scale(coin_state *s, double length, double rate)
{
    s->x *= length;
    s->z *= length;
    s->wX *= rate;
    s->wY *= rate;
    s->wZ *= rate;
}

void coin_priv_begin(coin_priv_moving *g, const coin_state *s,
                     const coin_priv_variables *v, int mode, const double u[2],
                     double time, double tol)
{
    const coin_priv_sum zero = {0, 0};
    const double start[5] = {s->phi, s->psi, s->x, s->z, 0};
    double *const y = g->step.y;
    for (int i = 0; i < COIN_PRIV_WIDE; ++i)
        y[i] = 0;
    y[COIN_PRIV_WX] = v->wX;
    y[COIN_PRIV_WY] = v->wY;
    y[COIN_PRIV_WZ] = v->wZ;
    y[COIN_PRIV_S] = v->sth;
    y[COIN_PRIV_C] = v->cth;
    y[COIN_PRIV_UX] = u[0];
    y[COIN_PRIV_UH] = u[1];
    y[COIN_PRIV_SPH] = v->sph;
    y[COIN_PRIV_CPH] = v->cph;
    for (int i = 0; i < 5; ++i) {
        g->start[i] = start[i];
        g->pose[i] = zero;
    }
    g->step.of.law = &g->law;
    g->tol = tol;
    g->time = time;
    g->mode = mode;
    g->changed = 0;
    g->margin = g->stride = 0;
}

void coin_priv_end(const coin_priv_moving *g, coin_state *s)
{
    double pose[4];
    for (int i = 0; i < 4; ++i)
        pose[i] = g->pose[i].sum + g->pose[i].low;
    const coin_priv_sc th = {g->step.y[COIN_PRIV_S], g->step.y[COIN_PRIV_C]};
    s->theta = coin_priv_lean_within(coin_priv_angle(th));
    s->phi += pose[0];
    s->psi += pose[1];
    s->x += pose[2];
    s->z += pose[3];
    s->wX = g->step.y[COIN_PRIV_WX];
    s->wY = g->step.y[COIN_PRIV_WY];
    s->wZ = g->step.y[COIN_PRIV_WZ];
}

double coin_priv_reached(const coin_priv_sum *moved, double time, double t,
                         double w0)
{
    const double r = (moved->sum + moved->low) / w0;
    return moved->sum == time ? t : coin_priv_lesser(r, t);
}
