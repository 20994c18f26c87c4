/* SPDX-License-Identifier: MIT */
/* What can be read off a coin_body: its energy, its slip, where it is drawn,
 * and the force of the table on it. */
#include "../motion/pinned.h"

#include "coin_body.h"
#include "flat_slide.h"

double coin_body_energy(const coin_body *b, const coin_params *p)
{
    coin_body natural;
    coin_priv_attitude at;
    coin_priv_body of;
    if (coin_priv_check_coin_body(&natural, &at, b, p, &of) != COIN_OK)
        return (double)NAN;
    const coin_state *s = &b->s;
    const double v2 = b->vx * b->vx + b->vy * b->vy + b->vz * b->vz;
    const double turn =
        of.IX * (s->wX * s->wX + s->wY * s->wY) + of.IZ * s->wZ * s->wZ;
    return (of.M * v2 + turn) / 2 + of.Mg * b->y; /* (88) */
}

int32_t coin_body_slip(const coin_body *b, const coin_params *p, double u[2])
{
    coin_body natural;
    coin_priv_attitude at;
    coin_priv_body of;
    const int32_t status =
        u ? coin_priv_check_coin_body(&natural, &at, b, p, &of) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const int lies = coin_priv_body_lies(b);
    const double uX = of.a * b->s.wZ, uh = -of.a * (b->s.wX * at.th.c);
    u[0] = b->vx + (lies ? 0 : uX * at.ph.c + uh * at.ph.s);
    u[1] = b->vz + (lies ? 0 : uh * at.ph.c - uX * at.ph.s);
    return COIN_OK;
}

int32_t coin_body_matrix(const coin_body *b, const coin_params *p, double m[16])
{
    coin_body natural;
    coin_priv_attitude at;
    coin_priv_body of;
    const int32_t status =
        m ? coin_priv_check_coin_body(&natural, &at, b, p, &of) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const double y = b->y;
    (void)coin_matrix(&b->s, p, m);
    m[13] = y;
    return COIN_OK;
}

/* The force on a coin that touches the table, in natural units. */
static coin_priv_push touching_force(const coin_body *b,
                                     const coin_priv_attitude *at,
                                     const coin_priv_law *l, int mode,
                                     const double u[2])
{
    coin_priv_moving g;
    g.law = *l;
    const coin_priv_variables v = coin_priv_attitude_variables(&b->s, at);
    coin_priv_begin(&g, &b->s, &v, mode, u, 0, 1);
    const int next = coin_priv_next_mode(&g);
    const coin_priv_push none = {0, 0, 0};
    if (next & COIN_PRIV_AIR)
        return none;
    const int slip_begins = next & ~mode & COIN_PRIV_SLIPS;
    coin_priv_push F = coin_priv_push_of(g.step.y, l, next & ~slip_begins);
    if (slip_begins) {
        const coin_priv_direction n = coin_priv_onset(g.step.y, l, next, F);
        F = coin_priv_slopes(0, g.step.y, l, next, n);
    }
    const coin_priv_push r = {F.N / g.step.y[COIN_PRIV_C],
                              F.X / g.step.y[COIN_PRIV_C],
                              F.h / g.step.y[COIN_PRIV_C]};
    return r;
}

/* The force on a coin that slides on its face, in natural units. */
static coin_priv_push sliding_force(const coin_body *b, coin_priv_sc ph,
                                    const coin_priv_law *l)
{
    const double v = sqrt(b->vx * b->vx + b->vz * b->vz);
    const double drag = coin_priv_flat_drag(l->IZ, v, fabs(b->s.wZ));
    const double per = v > 0 ? l->mu_kinetic * drag / v : 0;
    const coin_priv_push r = {
        1,
        -per * (b->vx * ph.c - b->vz * ph.s),
        -per * (b->vx * ph.s + b->vz * ph.c),
    };
    return r;
}

int32_t coin_body_reaction(const coin_body *b, const coin_params *p,
                           const coin_table *table, coin_force *out)
{
    coin_priv_body of;
    coin_priv_law law;
    double u[2];
    if (!b || !p || !table || !out)
        return COIN_EARG;
    if (coin_priv_check_body(&of, p) != COIN_OK ||
        coin_priv_table_law(&law, table, &of) != COIN_OK)
        return COIN_EPARAMS;
    coin_body natural;
    coin_priv_attitude at;
    const int32_t status = coin_priv_natural_body(&natural, &at, b, &of);
    if (status != COIN_OK)
        return status;
    const int mode = coin_priv_body_mode(&natural, &at, u);
    coin_priv_push F = {0, 0, 0};
    if (mode == COIN_PRIV_RESTS)
        F.N = 1;
    else if (mode == COIN_PRIV_LIES)
        F = sliding_force(&natural, at.ph, &law);
    else if (mode != COIN_PRIV_AIR)
        F = touching_force(&natural, &at, &law, mode, u);
    const coin_priv_sc ph = at.ph;
    coin_force r;
    r.R[0] = of.Mg * (F.X * ph.c + F.h * ph.s);
    r.R[1] = r.normal = of.Mg * F.N;
    r.R[2] = of.Mg * (F.h * ph.c - F.X * ph.s);
    r.friction = of.Mg * sqrt(F.X * F.X + F.h * F.h);
    r.ratio = r.normal > 0 ? r.friction / r.normal : (double)INFINITY;
    *out = r;
    return COIN_OK;
}
