/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "contact.h"

/* The most trials of coin_priv_slip_direction(). */
#define TRIALS 60

/* A force that leaves the cone by less than this part of its terms counts as
 * inside.  Where friction is 0, or exactly at its limit, the difference is
 * rounding. */
#define SLACK 1e-14

/* How a coin responds to a force of the contact: its slopes without friction,
 * and what a force adds to them. */
struct response {
    double f;        /* the slope of the time: cos theta, or 1 */
    double turn;     /* the slope of phi */
    double roll;     /* the slope of psi */
    double gX;       /* the slope of wX without a force of the table */
    double wY, wZ;   /* the slopes of wY and wZ without friction */
    double yX, zX;   /* what they gain per unit of friction along e_X */
    double uX, uh;   /* the slope of the slip without a force of the table */
    double weight;   /* the N without friction, times D */
    double vX, vh;   /* the velocity of the centre */
    double lever, D; /* M a^2/I_X; 1 + lever sin^2 theta */
};

/* A slipping coin near flat whose contact is held turns about the vertical
 * through its centre. */
static void hold(struct response *o, const coin_priv_contact *t,
                 const coin_priv_slip *y)
{
    const coin_priv_body *b = &t->b;
    const double wX = y->wX, sth = y->sth, cth = y->cth;
    const double turn = -y->wZ / sth;
    const double D = b->IX * cth * cth + b->IZ * sth * sth;
    const double fade = -turn *
                        (t->l.spin + 2 * sth * cth * wX * (b->IZ - b->IX)) /
                        D; /* (85) */
    o->f = 1;
    o->turn = turn;
    o->roll = 0;
    o->gX = sth * cth * turn * turn * (b->k1 - 1); /* (85) */
    o->wY = cth * fade - sth * wX * turn;
    o->wZ = -sth * fade - cth * wX * turn;
    o->yX = -sth * cth * b->m / D; /* (85) */
    o->zX = sth * sth * b->m / D;  /* (85) */
}

COIN_PRIV_INLINE void let_roll(struct response *o, const coin_priv_contact *t,
                               const coin_priv_slip *y)
{
    const coin_priv_body *b = &t->b;
    const double wX = y->wX, wY = y->wY, sth = y->sth, cth = y->cth;
    const double cwZ = cth * y->wZ;
    o->f = cth;
    o->turn = wY;
    o->roll = cwZ + sth * wY;
    /* clang-format off */
    o->gX = -wY * (b->k1 * cwZ + wY * sth);                  /* (78) */
    o->wY = wX * (b->k1 * cwZ + wY * sth);                   /* (78) */
    /* clang-format on */
    o->wZ = 0;
    o->yX = 0;
    o->zX = b->m / b->IZ;
    if (t->l.solid + t->l.fluid + t->l.spin > 0) {
        const coin_priv_variables v = {wX, wY, y->wZ, sth, cth, 0, 0, 0, 0};
        const coin_priv_slowing slow = coin_priv_slowing_of(&t->l, &v);
        o->wY += slow.wY;
        o->wZ += slow.wZ;
    }
}

COIN_PRIV_INLINE struct response response_at(const coin_priv_contact *t,
                                             const coin_priv_slip *y)
{
    struct response o;
    const double wX = y->wX, sth = y->sth, cth = y->cth;
    if (t->psi_held)
        hold(&o, t, y);
    else
        let_roll(&o, t, y);
    o.vX = y->uX - y->wZ;    /* (77) */
    o.vh = y->uh + wX * cth; /* (77) */
    o.lever = t->b.m / t->b.IX;
    o.D = 1 + o.lever * (sth * sth);
    o.weight = o.f * (t->b.g_a - cth * (wX * wX)) - sth * o.gX;
    o.uX = o.wZ - o.turn * o.vh;
    o.uh = o.turn * o.vX + o.f * (wX * wX) * sth - cth * o.gX;
    return o;
}

/* The same as a function. */
static struct response response_of(const coin_priv_contact *t,
                                   const coin_priv_slip *y)
{
    return response_at(t, y);
}

static coin_priv_push stick(const struct response *o, const coin_priv_slip *y)
{
    const double part = o->lever * y->sth * y->cth;
    const double h =
        (part * o->weight - o->D * o->uh) / (1 + o->lever); /* (82) */
    const coin_priv_push force = {
        (o->weight + part * h) / o->D, /* (79) */
        -o->uX / (1 + o->zX),          /* (82) */
        h,
    };
    return force;
}

coin_priv_push coin_priv_static(const coin_priv_contact *contact,
                                const coin_priv_slip *y)
{
    const struct response o = response_of(contact, y);
    return stick(&o, y);
}

COIN_PRIV_INLINE coin_priv_push slide(const struct response *o,
                                      const coin_priv_slip *y, double mu,
                                      coin_priv_direction n)
{
    const double part = o->lever * y->sth * y->cth;
    const double N = o->weight / (o->D + part * mu * n.h); /* (80) */
    const coin_priv_push force = {N, -mu * N * n.X, -mu * N * n.h};
    return force;
}

coin_priv_push coin_priv_kinetic(const coin_priv_contact *contact,
                                 const coin_priv_slip *y, coin_priv_direction n)
{
    const struct response o = response_of(contact, y);
    return slide(&o, y, contact->mu_kinetic, n);
}

/* The slope of the slip. */
COIN_PRIV_INLINE coin_priv_direction slip_slope(const struct response *o,
                                                const coin_priv_slip *y,
                                                const coin_priv_push *p)
{
    const double sth = y->sth, cth = y->cth;
    const double turn = o->lever * (p->N * sth - p->h * cth);
    const coin_priv_direction d = {
        o->uX + (1 + o->zX) * p->X,
        o->uh + p->h - cth * turn,
    };
    return d;
}

/* The slopes under a force, times `by`. */
COIN_PRIV_INLINE void slopes_under(coin_priv_slip *d, const struct response *o,
                                   const coin_priv_slip *y,
                                   const coin_priv_push *force, double by)
{
    const coin_priv_direction slip = slip_slope(o, y, force);
    const double wX = y->wX, sth = y->sth, cth = y->cth;
    const double sph = y->sph, cph = y->cph, f = o->f;
    const double lean = o->lever * (force->N * sth - force->h * cth);
    d->wX = by * (o->gX + lean);             /* (81) */
    d->wY = by * (o->wY + o->yX * force->X); /* (81) */
    d->wZ = by * (o->wZ + o->zX * force->X); /* (81) */
    d->sth = by * (f * cth * wX);
    d->cth = by * (-f * sth * wX);
    d->uX = by * slip.X;
    d->uh = by * slip.h;
    d->sph = by * (o->turn * cph);
    d->cph = by * (-o->turn * sph);
    d->phi = by * o->turn;
    d->psi = by * o->roll;
    d->x = by * (f * (o->vX * cph + o->vh * sph));
    d->z = by * (f * (o->vh * cph - o->vX * sph));
    d->t = by * f;
}

void coin_priv_slopes_under(coin_priv_slip *d, const coin_priv_contact *contact,
                            const coin_priv_slip *y,
                            const coin_priv_push *force)
{
    const struct response o = response_of(contact, y);
    slopes_under(d, &o, y, force, 1);
}

int coin_priv_can_slip(const coin_priv_contact *contact,
                       const coin_priv_slip *y)
{
    const coin_priv_direction none = {0, 0};
    return contact->mu_static <= DBL_MAX &&
           coin_priv_kinetic(contact, y, none).N > 0;
}

/* mu N + F, divided by mu if that is above 1, with the absolute values of all
 * terms of the force. */
static double terms_of(const coin_priv_contact *t, const struct response *o,
                       const coin_priv_slip *y)
{
    const double cth = y->cth, sth = fabs(y->sth), mu = t->mu_static;
    const double turn = fabs(o->turn), wX2 = o->f * (y->wX * y->wX);
    const double wY = fabs(y->wY), cwZ = cth * fabs(y->wZ);
    const double gX =
        t->psi_held ? fabs(o->gX) : wY * (t->b.k1 * cwZ + wY * sth);
    const double weight = o->f * t->b.g_a + cth * wX2 + sth * gX;
    const double uX = fabs(o->wZ) + turn * fabs(o->vh);
    const double uh = turn * fabs(o->vX) + wX2 * sth + cth * gX;
    const double part = o->lever * sth * cth;
    const double h = (part * weight + o->D * uh) / (1 + o->lever);
    const double N = (weight + part * h) / o->D, F = uX / (1 + o->zX) + h;
    return mu > 1 ? N + F / mu : mu * N + F;
}

double coin_priv_margin(const coin_priv_contact *contact,
                        const coin_priv_slip *y)
{
    const struct response o = response_of(contact, y);
    const coin_priv_push force = stick(&o, y);
    const double mu = contact->mu_static;
    const double F = coin_priv_hypot(force.X, force.h);
    return (mu > 1 ? force.N - F / mu : mu * force.N - F) +
           SLACK * terms_of(contact, &o, y);
}

/* The directions between two.  That of a slip that begins is looked for in such
 * a sector. */
struct sector {
    coin_priv_direction from, to;
};

/* The direction of a vector; along e_X if it is 0. */
static coin_priv_direction unit(double X, double h)
{
    const double size = coin_priv_hypot(X, h);
    const int none = size == 0;
    const coin_priv_direction n = {none ? 1 : X / size, none ? 0 : h / size};
    return n;
}

static coin_priv_direction direction_at(const struct sector *f, double part)
{
    return unit((1 - part) * f->from.X + part * f->to.X,
                (1 - part) * f->from.h + part * f->to.h);
}

/* The cross product of the slope of the slip and n, for a slip that begins in
 * the direction n, a part of the way through the sector.  It is 0 if the slip
 * keeps that direction. */
static double turn_away(const struct response *o, const coin_priv_contact *t,
                        const coin_priv_slip *y, const struct sector *f,
                        double part)
{
    const coin_priv_direction n = direction_at(f, part);
    const coin_priv_push force = slide(o, y, t->mu_kinetic, n);
    const coin_priv_direction d = slip_slope(o, y, &force);
    return d.X * n.h - d.h * n.X; /* (84) */
}

/* The root of (84) lies between the direction against the static force and that
 * of the slip without friction.  Where these agree to rounding, the one with
 * the smaller cross product is taken. */
coin_priv_direction coin_priv_slip_direction(const coin_priv_contact *contact,
                                             const coin_priv_slip *y,
                                             const coin_priv_push *stick)
{
    const struct response o = response_of(contact, y);
    const double lever_h = (1 + o.lever) / o.D;
    const struct sector sector = {
        unit(-stick->X, -stick->h),
        unit(-stick->X * (1 + o.zX), -stick->h * lever_h),
    };
    double x0 = 0, off0 = turn_away(&o, contact, y, &sector, 0);
    double x1 = 1, off1 = turn_away(&o, contact, y, &sector, 1);
    double x = fabs(off0) < fabs(off1) ? x0 : x1, step = 1;
    for (int i = 0;
         (i < TRIALS) & (step > DBL_EPSILON) & ((off0 < 0) != (off1 < 0));
         ++i) {
        x = x0 + (x1 - x0) * (off0 / (off0 - off1));
        const double off = turn_away(&o, contact, y, &sector, x);
        step = fabs(x - x1);
        if ((off < 0) == (off1 < 0)) {
            off0 /= 2; /* Illinois */
        } else {
            x0 = x1;
            off0 = off1;
        }
        x1 = x;
        off1 = off;
    }
    return direction_at(&sector, x);
}

void coin_priv_roll_slopes(double *dy, const double *y, const void *contact)
{
    const coin_priv_contact *t = (const coin_priv_contact *)contact;
    const coin_priv_slip *at = (const coin_priv_slip *)(const void *)y;
    const struct response o = response_of(t, at);
    const coin_priv_push force = stick(&o, at);
    slopes_under((coin_priv_slip *)(void *)dy, &o, at, &force, 1);
}

void coin_priv_slip_slopes(double *dy, const double *y, const void *contact)
{
    const coin_priv_contact *t = (const coin_priv_contact *)contact;
    const coin_priv_slip *at = (const coin_priv_slip *)(const void *)y;
    const double u = coin_priv_hypot(at->uX, at->uh);
    const double scale = coin_priv_slip_scale(t, u);
    const coin_priv_direction n = {at->uX / u, at->uh / u};
    const struct response o = response_at(t, at);
    const coin_priv_push force = slide(&o, at, t->mu_kinetic, n);
    slopes_under((coin_priv_slip *)(void *)dy, &o, at, &force, scale);
}
