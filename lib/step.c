/* SPDX-License-Identifier: MIT */
/* One step by itself, for who has little stack: the bits of a coin_run() of one
 * step, which takes three times the stack to be fast.  Here each part of a step
 * is a function of its own, whose room is free again for the next. */
#include "pinned.h"

#include "march.h"
#include "method.h"
#include "rk4.h"
#include "stage.h"
#include "state.h"

/* A step under way. */
struct step {
    coin_priv_field f; /* for h = 1 */
    double h;          /* what the next slope is times */
    coin_priv_limits limits;
    coin_priv_stage y;
    coin_priv_pose pose; /* as in coin_priv_carry */
};

/* Checks everything, and keeps what the step needs of the body. */
COIN_PRIV_APART int32_t step_of(struct step *k, const coin_state *s,
                                const coin_params *p, double dt)
{
    coin_priv_body b;
    const int32_t status = coin_priv_check(s, p, &b);
    if (status != COIN_OK)
        return status;
    if (!(dt - dt == 0))
        return COIN_ESTEP;
    k->f = coin_priv_field_of(&b, 1);
    k->limits = coin_priv_limits_of(&b, COIN_RK4, dt);
    return COIN_OK;
}

COIN_PRIV_APART void begin(struct step *k, const coin_state *s)
{
    const coin_priv_pose none = {0, 0, 0, 0, 0};
    k->y = coin_priv_stage_of(s);
    k->pose = none;
}

/* *d becomes the slope at a stage, times h. */
COIN_PRIV_APART void slope(coin_priv_stage *d, const struct step *k,
                           const coin_priv_stage *y)
{
    const double h = k->h;
    const coin_priv_field f = {
        h, h * k->f.GJ, h * k->f.KJ, k->f.XJ, h * k->f.k1, h * k->f.k2,
    };
    *d = coin_priv_motion(&f, y);
}

/* Adds w times that of the pose. */
COIN_PRIV_APART void follow(struct step *k, int w, const coin_priv_stage *y)
{
    const coin_priv_field f = {k->h, 0, 0, 0, 0, 0};
    const coin_priv_pose v = coin_priv_drift(&f, y);
    k->pose = coin_priv_pose_plus(&k->pose, w, &v);
}

/* The sum of the pose's first three slopes becomes where they lead to. */
COIN_PRIV_APART void lead(struct step *k, double phi)
{
    const coin_priv_pose start = {phi, 0, 0, 0, 0};
    k->pose = coin_priv_pose_plus(&start, 1.0 / 3, &k->pose);
}

/* *to becomes a + w b. */
COIN_PRIV_APART void plus(coin_priv_stage *to, const coin_priv_stage *a,
                          double w, const coin_priv_stage *b)
{
    *to = coin_priv_stage_plus(a, w, b);
}

COIN_PRIV_APART double total(double start, double part)
{
    const coin_priv_sum sum = {start, 0};
    return coin_priv_total(sum, part);
}

/* coin_priv_rk4_step() in its parts; 0 if that leads below the table. */
COIN_PRIV_APART int stages(struct step *k, double dt, double phi)
{
    coin_priv_stage sum, y, d;
    k->h = dt / 2;
    slope(&sum, k, &k->y);
    follow(k, 1, &k->y);
    plus(&y, &k->y, 1, &sum);
    int above = y.cth > 0;
    for (int w = 2; w > 0; --w) {
        k->h = dt / w;
        slope(&d, k, &y);
        follow(k, w, &y);
        plus(&sum, &sum, w, &d);
        plus(&y, &k->y, 1, &d);
        above &= y.cth > 0;
    }
    k->h = dt / 6;
    slope(&d, k, &y);
    lead(k, phi);
    follow(k, 1, &y);
    k->pose.x = total(-k->y.sth * k->y.sph, k->pose.x); /* (21) */
    k->pose.z = total(-k->y.sth * k->y.cph, k->pose.z); /* (21) */
    plus(&k->y, &k->y, 1.0 / 3, &sum);
    plus(&k->y, &k->y, 1, &d);
    above &= k->y.cth > 0;
    return above;
}

COIN_PRIV_APART int within(struct step *k, const coin_params *p)
{
    return coin_priv_within(&k->limits, p->gravity / p->radius, &k->y);
}

COIN_PRIV_APART void renew(struct step *k)
{
    coin_priv_renew(&k->y);
}

COIN_PRIV_APART int32_t end(coin_state *s, const struct step *k, double a)
{
    const coin_priv_stage *y = &k->y;
    const coin_state next = {
        coin_priv_lean(y->sth, y->cth),
        k->pose.phi,
        total(s->psi, k->pose.psi),
        s->x + a * (k->pose.x + y->sth * y->sph), /* (21) */
        s->z + a * (k->pose.z + y->sth * y->cph), /* (21) */
        y->wX,
        y->wY,
        y->wZ,
    };
    /* A heading out of range is NaN by now. */
    if (coin_priv_check_members(&next) != COIN_OK)
        return COIN_ESTEP;
    coin_priv_copy(s, &next, sizeof next);
    return k->limits.warnings;
}

int32_t coin_step(coin_state *s, const coin_params *p, double dt)
{
    struct step k;
    const int32_t status = step_of(&k, s, p, dt);
    if (status != COIN_OK || dt == 0)
        return status;
    begin(&k, s);
    if (!within(&k, p) || !stages(&k, dt, s->phi))
        return COIN_ESTEP;
    renew(&k);
    if (!within(&k, p))
        return COIN_ESTEP;
    k.pose.phi = coin_priv_heading(&k.y, k.pose.phi);
    return end(s, &k, p->radius);
}
