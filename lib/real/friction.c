/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "friction.h"
#include "slide.h"

/* The status given, which is that of the state; in place of COIN_OK it is
 * COIN_ESTATE if the centre moves too fast. */
static int32_t status_of(int32_t status, const coin_slide *d,
                         const coin_priv_body *b)
{
    if (status != COIN_OK)
        return status;
    const double most = sqrt(b->w2_max);
    const int slow = fabs(d->vx) <= most * b->a && fabs(d->vz) <= most * b->a;
    return slow ? COIN_OK : COIN_ESTATE;
}

int32_t coin_priv_check_slide(const coin_slide *d, const coin_priv_body *b)
{
    return status_of(coin_priv_state_holds(&d->s, b) ? COIN_OK : COIN_ESTATE, d,
                     b);
}

/* COIN_OK and the body of a slide that can be computed with, or COIN_EARG,
 * COIN_EPARAMS, COIN_ESTATE in this order. */
static int32_t check(coin_priv_body *b, const coin_slide *d,
                     const coin_params *p)
{
    return d ? status_of(coin_priv_check(&d->s, p, b), d, b) : COIN_EARG;
}

int32_t coin_priv_contact_of(coin_priv_contact *out, const coin_params *p,
                             const coin_friction *f, const coin_losses *l)
{
    if (coin_priv_check_body(&out->b, p) != COIN_OK)
        return COIN_EPARAMS;
    coin_priv_body slipping = out->b;
    slipping.K = slipping.IZ;
    if (l && (l->damping > 0 ||
              coin_priv_losses_of(&out->l, l, &slipping) != COIN_OK))
        return COIN_EPARAMS;
    if (!l)
        out->l.solid = out->l.fluid = out->l.spin = 0; /* nothing else is read
                                                        */
    const double k = out->b.IX / out->b.m;
    const double bound = 2 * sqrt(k) * sqrt(1 + k); /* (86) */
    out->mu_static = f->mu_static;
    out->mu_kinetic = f->mu_kinetic;
    out->w0 = sqrt(out->b.g_a);
    out->psi_held = 0;
    const int good = f->mu_kinetic >= 0 && f->mu_kinetic <= f->mu_static &&
                     f->mu_kinetic < bound;
    return good ? COIN_OK : COIN_EPARAMS;
}

coin_priv_slip coin_priv_slip_start(const coin_slide *d,
                                    const coin_priv_variables *y, double a)
{
    const double vx = d->vx / a, vz = d->vz / a;
    const double vX = vx * y->cph - vz * y->sph;
    const double vh = vx * y->sph + vz * y->cph;
    const coin_priv_slip r = {
        y->wX,  y->wY,  y->wZ, y->sth, y->cth, vX + y->wZ, vh - y->wX * y->cth,
        y->sph, y->cph, 0,     0,      0,      0,          0,
    };
    return r;
}

void coin_priv_centre_velocity(double v[2], const coin_priv_slip *y, double a)
{
    const double vX = y->uX - y->wZ, vh = y->uh + y->wX * y->cth;
    v[0] = a * (vX * y->cph + vh * y->sph);
    v[1] = a * (vh * y->cph - vX * y->sph);
}

int32_t coin_slide_of(coin_slide *d, const coin_state *s, const coin_params *p)
{
    coin_priv_body b;
    const int32_t status = d ? coin_priv_check(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const coin_priv_variables y = coin_priv_variables_of(s);
    double v[3];
    coin_priv_velocity_of(v, b.a, &y);
    coin_priv_copy_state(&d->s, s);
    d->vx = v[0];
    d->vz = v[2];
    return COIN_OK;
}

double coin_slide_energy(const coin_slide *d, const coin_params *p)
{
    coin_priv_body b;
    if (check(&b, d, p) != COIN_OK)
        return (double)NAN;
    const coin_priv_sc th = coin_priv_sincos(d->s.theta);
    const double wX = d->s.wX, wY = d->s.wY, wZ = d->s.wZ;
    const double vx = d->vx, vy = b.a * wX * th.s, vz = d->vz;
    /* M v first: v^2 may overflow where M v^2 does not. */
    const double Mv2 = b.M * vx * vx + b.M * vz * vz + b.M * vy * vy;
    const double T = 0.5 * (Mv2 + b.IX * (wX * wX + wY * wY) + b.IZ * wZ * wZ);
    return T + b.Mga * th.c; /* (88) */
}

int32_t coin_slide_velocity(const coin_slide *d, const coin_params *p,
                            double u[2])
{
    coin_priv_body b;
    const int32_t status = u ? check(&b, d, p) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const coin_priv_variables at = coin_priv_variables_of(&d->s);
    const coin_priv_slip y = coin_priv_slip_start(d, &at, b.a);
    u[0] = b.a * (y.uX * y.cph + y.uh * y.sph);
    u[1] = b.a * (y.uh * y.cph - y.uX * y.sph);
    return COIN_OK;
}

int coin_priv_slips(const coin_priv_contact *t, const coin_priv_slip *y)
{
    const double rounding = 8 * DBL_EPSILON * (fabs(y->wX) + fabs(y->wZ));
    return !(coin_priv_hypot(y->uX, y->uh) <
             COIN_PRIV_SLIP_LEAST * t->w0 + rounding);
}

/* The force of the table, over M a and times cos theta. */
static coin_priv_push push_of(const coin_priv_contact *t, coin_priv_slip *y)
{
    const double u = coin_priv_hypot(y->uX, y->uh);
    if (coin_priv_slips(t, y)) {
        const coin_priv_direction n = {y->uX / u, y->uh / u};
        return coin_priv_kinetic(t, y, n);
    }
    y->uX = y->uh = 0;
    const coin_priv_push stick = coin_priv_static(t, y);
    const int leaves = coin_priv_clearance(t, y, 0) < 0;
    const double F = coin_priv_hypot(stick.X, stick.h);
    if (!(leaves & (F > 0) & (t->mu_static <= DBL_MAX)))
        return stick;
    return coin_priv_kinetic(t, y, coin_priv_slip_direction(t, y, &stick));
}

int32_t coin_slide_reaction(const coin_slide *d, const coin_params *p,
                            const coin_friction *f, const coin_losses *l,
                            coin_force *out)
{
    coin_priv_contact contact;
    if (!d || !p || !f || !out)
        return COIN_EARG;
    if (coin_priv_contact_of(&contact, p, f, l) != COIN_OK)
        return COIN_EPARAMS;
    const coin_priv_body *const b = &contact.b;
    const int32_t status = coin_priv_check_slide(d, b);
    if (status != COIN_OK)
        return status;
    const coin_priv_variables at = coin_priv_variables_of(&d->s);
    coin_priv_slip y = coin_priv_slip_start(d, &at, b->a);
    const coin_priv_push push = push_of(&contact, &y);
    const double scale = b->M * b->a / y.cth;
    coin_force r;
    r.R[0] = scale * (push.X * y.cph + push.h * y.sph);
    r.R[1] = r.normal = scale * push.N;
    r.R[2] = scale * (push.h * y.cph - push.X * y.sph);
    r.friction = scale * coin_priv_hypot(push.X, push.h);
    r.ratio = r.normal > 0 ? r.friction / r.normal : (double)INFINITY;
    if (!((r.friction <= DBL_MAX) & (fabs(r.normal) <= DBL_MAX)))
        return COIN_ESTATE;
    *out = r;
    return COIN_OK;
}
