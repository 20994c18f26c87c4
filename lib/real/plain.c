/* SPDX-License-Identifier: MIT */
/* What nearly all steps of a rolling coin are looked at by: a few polynomials,
 * without a root or a quotient. */
#include "../motion/pinned.h"

#include "cone.h"

/* By how much the interpolation may miss a variable, over stride^6: as in
 * cone.c. */
#define MISS 0.006

/* A step of less stride is looked at in its middle alone. */
#define SHORT 0.4

/* The slopes of the slopes are differences over this part of the time in
 * which the motion changes. */
#define NEAR (1.0 / 1048576)

/* The variables, and with them the slopes of wX and wZ. */
enum { X, Y, Z, SIN, COS, VARIABLES };

COIN_PRIV_INLINE coin_priv_variables slope(const coin_priv_field *f,
                                           const coin_priv_losses *l,
                                           const double *y)
{
    const coin_priv_variables at = {
        y[X], y[Y], y[Z], y[SIN], y[COS], 0, 0, 0, 0,
    };
    coin_priv_variables d = coin_priv_sundman_rates(f, &at);
    if (l) {
        const coin_priv_slowing slow = coin_priv_slow(l, &at);
        d.wX += slow.wX;
        d.wY += slow.wY;
        d.wZ += slow.wZ;
    }
    return d;
}

COIN_PRIV_INLINE void slopes(double *d, const coin_priv_field *f,
                             const coin_priv_losses *l, const double *y)
{
    const coin_priv_variables v = slope(f, l, y);
    d[X] = v.wX;
    d[Y] = v.wY;
    d[Z] = v.wZ;
    d[SIN] = v.sth;
    d[COS] = v.cth;
}

/* What is left of the cone at a place, as in coin_priv_end. */
struct left {
    double margin, miss;
};

COIN_PRIV_INLINE struct left left_at(const coin_priv_table *t, const double *y,
                                     double dwX, double dwZ)
{
    const double wX = y[X], wY = y[Y], sth = y[SIN], cth = y[COS];
    const double cwX = cth * wX;
    const double N = cth * t->b.g_a - cwX * cwX - sth * dwX;  /* (27) */
    const double FX = cwX * wY - dwZ;                         /* (25) */
    const double Fh = cth * dwX + wY * y[Z] - cwX * wX * sth; /* (26) */
    const double size = cth * t->b.g_a + cwX * wX + wY * wY + fabs(wY * y[Z]);
    const double per_N = t->mu_static > 1 ? 1 : t->mu_static;
    const double per_F = t->mu_static > 1 ? 1 / t->mu_static : 1;
    const double most = per_N * (N / size);
    const double along_X = per_F * (FX / size), along_h = per_F * (Fh / size);
    const struct left r = {
        most * fabs(most) - (along_X * along_X + along_h * along_h),
        per_N * fabs(most) + per_F * (fabs(along_X) + fabs(along_h)),
    };
    return r;
}

void coin_priv_end_of(coin_priv_end *e, const coin_priv_table *table,
                      const coin_priv_field *f, const coin_priv_losses *l,
                      const coin_priv_variables *y, double time)
{
    const double near = NEAR * time, per = 1 / near;
    double to[VARIABLES], d[VARIABLES];
    e->y[X] = y->wX;
    e->y[Y] = y->wY;
    e->y[Z] = y->wZ;
    e->y[SIN] = y->sth;
    e->y[COS] = y->cth;
    slopes(e->d, f, l, e->y);
    for (int i = 0; i < VARIABLES; ++i)
        to[i] = e->y[i] + near * e->d[i];
    slopes(d, f, l, to);
    for (int i = 0; i < VARIABLES; ++i)
        e->dd[i] = per * (d[i] - e->d[i]);
    const struct left left = left_at(table, e->y, e->d[X], e->d[Z]);
    e->margin = left.margin;
    e->miss = left.miss;
}

/* Hermite's polynomial of degree 5 at 1/4, 1/2, 3/4. */
enum { PLACES = 3 };
static const double weights[PLACES][6] = {
    {459.0 / 512, 189.0 / 1024, 27.0 / 2048, 53.0 / 512, -39.0 / 1024,
     9.0 / 2048},
    {1.0 / 2, 5.0 / 32, 1.0 / 64, 1.0 / 2, -5.0 / 32, 1.0 / 64},
    {53.0 / 512, 39.0 / 1024, 9.0 / 2048, 459.0 / 512, -189.0 / 1024,
     27.0 / 2048},
};

/* The least that a smooth function may have between n samples: below the least
 * of them by what parabolas, and the third differences, leave. */
COIN_PRIV_INLINE double least(const double *m, int n)
{
    double low = m[0], second = 0, third = 0, before = 0;
    for (int i = 1; i < n; ++i)
        low = coin_priv_lesser(m[i], low);
    for (int i = 1; i < n - 1; ++i) {
        const double d = (m[i + 1] - m[i]) - (m[i] - m[i - 1]);
        second += fabs(d);
        third += i > 1 ? fabs(d - before) : 0;
        before = d;
    }
    /* Three samples leave the third differences open. */
    return low - (n > 3 ? second + third : 2 * second) / 8;
}

/* What is left of the cone at place k. */
COIN_PRIV_INLINE struct left left_within(const coin_priv_table *table,
                                         const coin_priv_field *f,
                                         const coin_priv_losses *l,
                                         const coin_priv_end *a,
                                         const coin_priv_end *b, double tau,
                                         int k)
{
    const double *w = weights[k];
    const double tau2 = tau * tau;
    double y[VARIABLES];
    for (int i = 0; i < VARIABLES; ++i)
        y[i] = (w[0] * a->y[i] + w[3] * b->y[i]) +
               tau * (w[1] * a->d[i] + w[4] * b->d[i]) +
               tau2 * (w[2] * a->dd[i] + w[5] * b->dd[i]);
    const coin_priv_variables d = slope(f, l, y);
    return left_at(table, y, d.wX, d.wZ);
}

int coin_priv_plain(const coin_priv_table *table, const coin_priv_field *f,
                    const coin_priv_losses *l, const coin_priv_end *a,
                    const coin_priv_end *b, double tau, double stride)
{
    const double s2 = stride * stride;
    const int places = stride < SHORT ? 1 : PLACES;
    double m[PLACES + 2], terms = 0;
    m[0] = a->margin;
    for (int k = 0; k < places; ++k) {
        const int place = places > 1 ? k : PLACES / 2;
        const struct left at = left_within(table, f, l, a, b, tau, place);
        m[k + 1] = at.margin;
        terms = at.miss > terms ? at.miss : terms;
    }
    m[places + 1] = b->margin;
    return least(m, places + 2) > 2 * MISS * (s2 * s2 * s2) * terms;
}
