/* SPDX-License-Identifier: MIT */
/* What can be read off a coin_body: its energy, its slip, where it is drawn,
 * and the force of the table on it. */
#include "../motion/pinned.h"

#include "coin_body.h"
#include "flat_slide.h"
#include "line.h"

/* The largest tolerance of a call. */
#define HOLDS 1e-2

double coin_body_energy(const coin_body *b, const coin_params *p)
{
    coin_priv_coin c;
    coin_priv_constants of;
    if (coin_priv_check_coin_body(&c, b, p, &of) != COIN_OK)
        return (double)NAN;
    const coin_state *s = &b->s;
    const double v2 = b->vx * b->vx + b->vy * b->vy + b->vz * b->vz;
    const double rotation =
        of.IX * (s->wX * s->wX + s->wY * s->wY) + of.IZ * s->wZ * s->wZ;
    return (of.M * v2 + rotation) / 2 + of.Mg * b->y; /* (88) */
}

int32_t coin_body_contact(const coin_body *b, const coin_params *p, double v[3])
{
    coin_priv_coin c;
    coin_priv_constants of;
    const int32_t status =
        v ? coin_priv_check_coin_body(&c, b, p, &of) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const double by = coin_priv_lies(&c) ? 0 : of.a * sqrt(of.g_a);
    const double eta = coin_priv_lower_rim(&c);
    const coin_priv_lever d = coin_priv_lever_of(c.th.s, c.th.c, eta);
    const double uX = by * (c.wZ + eta * c.wY);
    const double uh = -by * (c.wX * d.Y);
    v[0] = b->vx + (uX * c.ph.c + uh * c.ph.s);
    v[1] = b->vy + by * (c.wX * d.P);
    v[2] = b->vz + (uh * c.ph.c - uX * c.ph.s);
    return COIN_OK;
}

int32_t coin_body_matrix(const coin_body *b, const coin_params *p, double m[16])
{
    coin_priv_coin c;
    coin_priv_constants of;
    const int32_t status =
        m ? coin_priv_check_coin_body(&c, b, p, &of) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const double y = b->y;
    coin_params thin = *p;
    thin.thickness = 0;
    (void)coin_matrix(&b->s, &thin, m);
    m[13] = y;
    return COIN_OK;
}

/* The force on a coin that touches the table, in natural units.  A contact is
 * held as in a call of the tolerance HOLDS. */
static coin_priv_push touching_force(const coin_priv_coin *c,
                                     const coin_priv_law *l, int mode,
                                     const double u[2])
{
    coin_priv_moving g;
    g.law = *l;
    g.c = *c;
    g.tol = HOLDS;
    coin_priv_begin(&g, mode, u);
    coin_priv_set_held(&g);
    mode = g.mode;
    const int next = coin_priv_next_mode(&g);
    const coin_priv_push none = {0, 0, 0};
    if (next & COIN_PRIV_AIR)
        return none;
    coin_priv_push F = coin_priv_push_of(g.step.y, l, mode);
    if (next & ~mode & COIN_PRIV_SLIPS) { /* it has no direction yet */
        const coin_priv_direction n = coin_priv_onset(g.step.y, l, next, F);
        F = coin_priv_slopes(0, g.step.y, l, next, n);
    }
    if (F.N < 0) /* no lift-off is looked at: coin_priv_blind() */
        return none;
    const double f = mode & COIN_PRIV_HELD ? 1 : g.step.y[COIN_PRIV_C];
    const coin_priv_push r = {F.N / f, F.X / f, F.h / f};
    return r;
}

/* The force on a coin that lies or stands, in natural units: against its
 * velocity if it slides, else against the pull. */
static coin_priv_push force_on_face(const coin_priv_coin *c,
                                    const coin_priv_law *l, int mode)
{
    const double v = sqrt(c->vx * c->vx + c->vz * c->vz), w = fabs(c->wZ);
    const double drag = coin_priv_flat_drag(l->IZ, v, w);
    const int slides = mode & COIN_PRIV_LIES && l->mu_static <= DBL_MAX;
    double x = l->pull[0], z = l->pull[1], per = 1;
    if (slides && v + w > COIN_PRIV_SLIP_LEAST) {
        x = c->vx;
        z = c->vz;
        per = v > 0 ? l->mu_kinetic * drag / v : 0;
    } else if (slides) {
        per = l->mu_kinetic / coin_priv_pull(l);
    }
    const coin_priv_push r = {1, 0 - per * (x * c->ph.c - z * c->ph.s),
                              0 - per * (x * c->ph.s + z * c->ph.c)};
    return r;
}

/* The force on a coin that is upright, in natural units: on both rims, at rest
 * against the pull, or, where it tips, on the rim that stays. */
static coin_priv_push force_on_line(const coin_priv_coin *c, coin_priv_law *l)
{
    const int tips = coin_priv_tips(c, l);
    if (!tips)
        return coin_priv_line_mode(c, l) == COIN_PRIV_RESTS
                   ? force_on_face(c, l, COIN_PRIV_RESTS)
                   : coin_priv_line_push(c, l);
    double u[2];
    l->eta = tips * l->half;
    const int mode = coin_priv_tip_mode(c, l->eta, u);
    return touching_force(c, l, mode, u);
}

int32_t coin_body_reaction(const coin_body *b, const coin_params *p,
                           const coin_table *table, coin_force *out)
{
    coin_priv_constants of;
    coin_priv_law law;
    coin_priv_coin c;
    double u[2];
    if (!b || !p || !table || !out)
        return COIN_EARG;
    const double half = coin_priv_half_of(p);
    if (coin_priv_check_thick(&of, p) != COIN_OK ||
        coin_priv_table_law(&law, table, &of, half) != COIN_OK)
        return COIN_EPARAMS;
    const int32_t status = coin_priv_coin_of(&c, b, &of, half);
    if (status != COIN_OK)
        return status;
    law.eta = coin_priv_lower_rim(&c);
    const int mode = coin_priv_coin_mode(&c, &law, u);

    coin_priv_push F = {0, 0, 0};
    if (mode & (COIN_PRIV_RESTS | COIN_PRIV_LIES))
        F = force_on_face(&c, &law, mode);
    else if (mode == COIN_PRIV_LINE)
        F = force_on_line(&c, &law);
    else if (mode != COIN_PRIV_AIR)
        F = touching_force(&c, &law, mode, u);
    const coin_priv_sc ph = c.ph;
    coin_force r;
    r.R[0] = of.Mg * (F.X * ph.c + F.h * ph.s);
    r.R[1] = r.normal = of.Mg * F.N;
    r.R[2] = of.Mg * (F.h * ph.c - F.X * ph.s);
    r.friction = of.Mg * sqrt(F.X * F.X + F.h * F.h);
    r.ratio = r.normal > 0 ? r.friction / r.normal : (double)INFINITY;
    *out = r;
    return COIN_OK;
}
