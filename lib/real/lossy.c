/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "real/losses.h"

/* The coefficients of a step, and where its error goes. */
struct lossy_field {
    coin_priv_field ideal; /* first: it is what dop8.h hands on */
    const coin_priv_losses *l;
    double perw, perwZ; /* 1 over what the rates are held to */
    double *error;
};

/* h d/dtau of a stage: the ideal coin's, and the losses. */
COIN_PRIV_INLINE coin_priv_stage lossy(const coin_priv_field *f,
                                       const coin_priv_stage *y)
{
    const struct lossy_field *with =
        (const struct lossy_field *)(const void *)f;
    const coin_priv_slowing slow = coin_priv_slow(with->l, y);
    coin_priv_stage d = coin_priv_sundman(f, y);
    d.wX += f->h * slow.wX; /* (68) */
    d.wY += f->h * slow.wY; /* (68) */
    d.wZ += f->h * slow.wZ; /* (68) */
    return d;
}

/* The sum of squares of a stage's errors. */
COIN_PRIV_INLINE double size2(const struct lossy_field *f,
                              const coin_priv_stage *e)
{
    const double wX = e->wX * f->perw, wY = e->wY * f->perw;
    const double wZ = e->wZ * f->perwZ;
    return wX * wX + wY * wY + wZ * wZ + e->cth * e->cth + e->sth * e->sth +
           e->sph * e->sph + e->cph * e->cph;
}

/* The estimate of DOP853: of order 8, from those of order 5 and 3. */
COIN_PRIV_INLINE void note_error(const coin_priv_field *f,
                                 const coin_priv_stage *e5,
                                 const coin_priv_stage *e3)
{
    const struct lossy_field *with =
        (const struct lossy_field *)(const void *)f;
    const double by5 = size2(with, e5), by3 = size2(with, e3);
    const double sum = by5 + 0.01 * by3;
    *with->error = sum > 0 ? by5 / sqrt(sum) : sum;
}

#define FIELD lossy
#define DRIFT coin_priv_sundman_drift
#define EACH_POSE(F) F(phi) F(psi) F(x) F(z) F(t)
#define ERROR_TO note_error
#include "dop8.h"
#include "march.h"
#include "real/lossy.h"

/* How much of the friction's own rate counts: a step of LONGEST in settle.c is
 * then 4 of its relaxation times, and the method is stable up to 6. */
#define FRICTION 0.3

/* The part of the way to where the contact turns round that a step may go. */
#define TURN_ROUND 0.5

/* The coin's own rate in tau, as coin_advance() measures its steps by. */
static double ideal_rate(const coin_priv_body *b, const coin_priv_stage *y)
{
    const double wX = y->wX, wY = y->wY, cwZ = y->cth * y->wZ;
    return sqrt(wX * wX + 1.5 * (wY * wY) + b->KJ * b->k1 * (cwZ * cwZ) +
                y->cth * b->g_a);
}

double coin_priv_lossy_rate(const coin_priv_lossy *w)
{
    const coin_priv_stage *y = &w->c.at.y;
    const coin_priv_losses *l = &w->l;
    const double sth = y->sth, cth = y->cth;
    const double u = cth * y->wZ + sth * y->wY;
    const double grip = coin_priv_grip(l, u, cth);
    const double lever = sth * sth / l->IX + cth * cth / l->K;
    return ideal_rate(&w->b, y) +
           FRICTION * (grip * lever + l->damping * fabs(u) +
                       l->spin * cth / l->IX); /* (71) */
}

/* The u = cos(theta) d(psi)/dt within which friction may be stepped over: the
 * width of the softening; and for the terms that have none the width in which
 * they change the rates by no more than the error: (71). */
static double zone(const coin_priv_lossy *w, double du, double error)
{
    const coin_priv_stage *y = &w->c.at.y;
    const coin_priv_losses *l = &w->l;
    const double w0 = sqrt(w->b.g_a), turn = error * w0 * du;
    double least = (double)INFINITY;
    if (l->solid > 0)
        least = sqrt(l->soft2) * y->cth;
    if (l->layer > 0) { /* A^(7/16), a little below A^(2/5) */
        const double A =
            turn * l->IX * y->cth * sqrt(y->cth / w0) / (l->layer * w0 * w0);
        const double root = sqrt(sqrt(sqrt(sqrt(A))));
        const double cube = root * root * root;
        least = coin_priv_lesser(w0 * cube * cube * root, least);
    }
    if (l->damping > 0) {
        const double rate = fabs(y->wX) + fabs(y->wY) + fabs(y->wZ);
        least = coin_priv_lesser(sqrt(turn / (l->damping * rate)), least);
    }
    return least;
}

double coin_priv_lossy_bound(const coin_priv_lossy *w, double error)
{
    const coin_priv_stage *y = &w->c.at.y;
    const struct lossy_field f = {coin_priv_field_of(&w->b, 1), &w->l, 0, 0, 0};
    const coin_priv_stage d = lossy(&f.ideal, y);
    const double u = y->cth * y->wZ + y->sth * y->wY;
    const double du =
        fabs(y->cth * d.wZ + y->sth * d.wY + d.cth * y->wZ + d.sth * y->wY);
    const double least = zone(w, du, error);
    return TURN_ROUND * sqrt(u * u + least * least) / du;
}

void coin_priv_lossy_try(coin_priv_trial *trial, const coin_priv_lossy *w,
                         double tau)
{
    const coin_priv_stage *y = &w->c.at.y;
    const double natural = sqrt(w->b.g_a);
    const double rate = ideal_rate(&w->b, y);
    const double slow = rate < natural ? rate : natural;
    struct lossy_field f = {
        coin_priv_field_of(&w->b, tau),
        &w->l,
        1 / slow,
        1 / natural,
        &trial->error,
    };
    coin_priv_copy(&trial->next, &w->c.at, sizeof trial->next);
    trial->next.pose.t = 0;
    coin_priv_moment now = trial->next;
    const double lowest = dop8_step(&trial->next, &now, &f.ideal);
    if (!(coin_priv_lesser(lowest, trial->next.y.cth) > 0))
        trial->error = (double)INFINITY;
    trial->in_range = coin_priv_angles_hold(&trial->next, w->c.psi.sum, 0);
}

void coin_priv_lossy_accept(coin_priv_lossy *w, const coin_priv_trial *trial)
{
    coin_priv_copy(&w->c.at, &trial->next, sizeof w->c.at);
    if (++w->c.steps % COIN_PRIV_SETTLE == 0)
        coin_priv_settle(&w->c, &w->c.at);
}
