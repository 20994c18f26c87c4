/* SPDX-License-Identifier: MIT */
/* The test that decides nearly all steps of a coin that rolls with losses.
 *
 * First the force along the step is taken as a polynomial of degree 3, by the
 * forces and their slopes at both ends, and then as one of degree 4, by the
 * force in the middle as well.  If the polynomial's points in Bernstein's form
 * lie in the cone of friction, so does the polynomial.  If neither decides, the
 * square margin is computed at three places of the interpolated motion. */
#include "../motion/pinned.h"

#include "cone.h"

/* The slopes of the slopes are differences over this part of the time in
 * which the motion changes.  Such a difference errs by NEAR/2 = 5e-7 of the
 * next derivative, and by 2^-52/NEAR = 2e-10 for rounding.  Both are far below
 * COIN_PRIV_MISS. */
#define NEAR (1.0 / 1048576)

/* The variables that the force depends on. */
enum { WX, WY, WZ, SIN, COS, VARIABLES };

COIN_PRIV_INLINE coin_priv_variables slopes_at(const coin_priv_field *f,
                                               const coin_priv_losses *l,
                                               const double *y)
{
    const coin_priv_variables at = {
        y[WX], y[WY], y[WZ], y[SIN], y[COS], 0, 0, 0, 0,
    };
    coin_priv_variables d = coin_priv_sundman_slopes(f, &at);
    const coin_priv_slowing slow = coin_priv_slowing_of(l, &at);
    d.wX += slow.wX;
    d.wY += slow.wY;
    d.wZ += slow.wZ;
    return d;
}

COIN_PRIV_INLINE void slopes(double *d, const coin_priv_field *f,
                             const coin_priv_losses *l, const double *y)
{
    const coin_priv_variables v = slopes_at(f, l, y);
    d[WX] = v.wX;
    d[WY] = v.wY;
    d[WZ] = v.wZ;
    d[SIN] = v.sth;
    d[COS] = v.cth;
}

COIN_PRIV_INLINE coin_priv_need need_of(const coin_priv_contact *t,
                                        const double *y, double dwX, double dwZ)
{
    const double wX = y[WX], wY = y[WY], sth = y[SIN], cth = y[COS];
    const double cwX = cth * wX;
    const coin_priv_need F = {
        cth * t->b.g_a - cwX * cwX - sth * dwX,  /* (27) */
        cwX * wY - dwZ,                          /* (25) */
        cth * dwX + wY * y[WZ] - cwX * wX * sth, /* (26) */
        cth * t->b.g_a + cwX * wX + wY * wY + fabs(wY * y[WZ]),
    };
    return F;
}

/* The factors of N and F in the square margin. */
struct scale {
    double N, F;
};

COIN_PRIV_INLINE struct scale scale_of(const coin_priv_contact *t, double size)
{
    const double mu = t->mu_static, per = 1 / size;
    const struct scale r = {mu > 1 ? per : mu * per, mu > 1 ? per / mu : per};
    return r;
}

/* The square margin at a place, and its weight, as in coin_priv_end. */
struct cone_margin {
    double square_margin, weight;
};

COIN_PRIV_INLINE struct cone_margin margin_of(const coin_priv_contact *t,
                                              const coin_priv_need *F)
{
    const struct scale per = scale_of(t, F->size);
    const double most = per.N * F->N;
    const double along_X = per.F * F->X, along_h = per.F * F->h;
    const struct cone_margin r = {
        most * fabs(most) - (along_X * along_X + along_h * along_h),
        fabs(most) + fabs(along_X) + fabs(along_h),
    };
    return r;
}

double coin_priv_square_margin_at(const coin_priv_contact *contact,
                                  const coin_priv_field *f,
                                  const coin_priv_variables *at)
{
    const double y[VARIABLES] = {at->wX, at->wY, at->wZ, at->sth, at->cth};
    const coin_priv_variables d = coin_priv_sundman_slopes(f, at);
    const coin_priv_need F = need_of(contact, y, d.wX, d.wZ);
    return margin_of(contact, &F).square_margin;
}

void coin_priv_end_of(coin_priv_end *e, const coin_priv_contact *contact,
                      const coin_priv_field *f, const coin_priv_losses *l,
                      const coin_priv_variables *y, double time)
{
    const double near = NEAR * time, per = 1 / near;
    double to[VARIABLES], d[VARIABLES];
    e->y[WX] = y->wX;
    e->y[WY] = y->wY;
    e->y[WZ] = y->wZ;
    e->y[SIN] = y->sth;
    e->y[COS] = y->cth;
    slopes(e->d, f, l, e->y);
    for (int i = 0; i < VARIABLES; ++i)
        to[i] = e->y[i] + near * e->d[i];
    slopes(d, f, l, to);
    for (int i = 0; i < VARIABLES; ++i)
        e->dd[i] = per * (d[i] - e->d[i]);
    e->force = need_of(contact, e->y, e->d[WX], e->d[WZ]);
    const coin_priv_need F = need_of(contact, to, d[WX], d[WZ]);
    e->slope.N = per * (F.N - e->force.N);
    e->slope.X = per * (F.X - e->force.X);
    e->slope.h = per * (F.h - e->force.h);
    const struct cone_margin m = margin_of(contact, &e->force);
    e->square_margin = m.square_margin;
    e->weight = m.weight;
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

/* The least value that a smooth function may have between samples: the least
 * sample, less how far parabolas through the samples may dip below it, and less
 * what the third differences say that parabolas miss. */
COIN_PRIV_INLINE double least(const double m[PLACES + 2])
{
    double low = m[0], second = 0, third = 0, before = 0;
    for (int i = 1; i < PLACES + 2; ++i)
        low = coin_priv_lesser(m[i], low);
    for (int i = 1; i < PLACES + 1; ++i) {
        const double d = (m[i + 1] - m[i]) - (m[i] - m[i - 1]);
        second += fabs(d);
        third += i > 1 ? fabs(d - before) : 0;
        before = d;
    }
    return low - (second + third) / 8;
}

/* The force at place k. */
static coin_priv_need need_within(const coin_priv_contact *contact,
                                  const coin_priv_field *f,
                                  const coin_priv_losses *l,
                                  const coin_priv_end *a,
                                  const coin_priv_end *b, double tau, int k)
{
    const double *w = weights[k];
    const double tau2 = tau * tau;
    double y[VARIABLES];
    for (int i = 0; i < VARIABLES; ++i)
        y[i] = (w[0] * a->y[i] + w[3] * b->y[i]) +
               tau * (w[1] * a->d[i] + w[4] * b->d[i]) +
               tau2 * (w[2] * a->dd[i] + w[5] * b->dd[i]);
    const coin_priv_variables d = slopes_at(f, l, y);
    return need_of(contact, y, d.wX, d.wZ);
}

/* The force that an end's slope leads to. */
COIN_PRIV_INLINE coin_priv_need along(const coin_priv_end *e, double tau)
{
    const coin_priv_need F = {
        e->force.N + tau * e->slope.N,
        e->force.X + tau * e->slope.X,
        e->force.h + tau * e->slope.h,
        0,
    };
    return F;
}

/* The third of the five points of the curve of degree 4. */
COIN_PRIV_INLINE coin_priv_need third_point(const coin_priv_end *a,
                                            const coin_priv_end *b, double tau,
                                            const coin_priv_need *mid)
{
    const coin_priv_need from = along(a, tau / 5), to = along(b, -tau / 5);
    const coin_priv_need F = {
        8.0 / 3 * mid->N - 5.0 / 6 * (from.N + to.N),
        8.0 / 3 * mid->X - 5.0 / 6 * (from.X + to.X),
        8.0 / 3 * mid->h - 5.0 / 6 * (from.h + to.h),
        0,
    };
    return F;
}

/* Whether a force is in the cone, at least `off` from its edge. */
COIN_PRIV_INLINE int is_in_cone(const coin_priv_need *F,
                                const struct scale *per, double off)
{
    const double most = per->N * F->N - off;
    const double along_X = per->F * F->X, along_h = per->F * F->h;
    return (most >= 0) & (along_X * along_X + along_h * along_h <= most * most);
}

/* Whether a curve certainly stays in the cone: all its points in Bernstein's
 * form are in the cone.  These are the forces at both ends, those at the time
 * to_next from the ends along their slopes, and `point`.  A curve of degree 3
 * has only the first four; `point` is then one of them once more. */
COIN_PRIV_INLINE int stays_in_cone(const coin_priv_contact *t,
                                   const coin_priv_end *a,
                                   const coin_priv_end *b, double to_next,
                                   const coin_priv_need *point, double miss)
{
    const struct scale per = scale_of(t, a->force.size + b->force.size);
    const double off = miss * (1.5 * per.F + per.N);
    if (!(is_in_cone(&a->force, &per, off) & is_in_cone(&b->force, &per, off)))
        return 0;
    const coin_priv_need from = along(a, to_next), to = along(b, -to_next);
    return is_in_cone(&from, &per, off) & is_in_cone(&to, &per, off) &
           is_in_cone(point, &per, off);
}

/* Whether the square margin is above `allowed` times the largest weight, at the
 * places and at both ends. */
static int has_margin(const coin_priv_contact *contact, const coin_priv_end *a,
                      const coin_priv_end *b, const coin_priv_need *at,
                      double allowed)
{
    double m[PLACES + 2],
        weight = a->weight > b->weight ? a->weight : b->weight;
    m[0] = a->square_margin;
    m[PLACES + 1] = b->square_margin;
    for (int k = 0; k < PLACES; ++k) {
        const struct cone_margin here = margin_of(contact, &at[k]);
        m[k + 1] = here.square_margin;
        weight = here.weight > weight ? here.weight : weight;
    }
    return least(m) > allowed * weight;
}

COIN_PRIV_INLINE double roll_of(const coin_priv_end *e)
{
    return coin_priv_roll_speed(e->y[WY], e->y[WZ], e->y[SIN], e->y[COS]);
}

/* Whether the contact turns round between two ends, where dry friction changes
 * the force so quickly that no curve follows it. */
static int turns_round(const coin_priv_losses *l, const coin_priv_end *a,
                       const coin_priv_end *b)
{
    return l->solid > 0 && (roll_of(a) < 0) != (roll_of(b) < 0);
}

int coin_priv_surely_in_cone(const coin_priv_contact *contact,
                             const coin_priv_field *f,
                             const coin_priv_losses *l, const coin_priv_end *a,
                             const coin_priv_end *b, double tau, double stride)
{
    const double s2 = stride * stride, s4 = s2 * s2;
    const double allowed = 2 * COIN_PRIV_MISS * (s4 * s2);
    const double size = a->force.size + b->force.size;
    coin_priv_need at[PLACES], *const mid = &at[PLACES / 2];
    if (turns_round(l, a, b))
        return 0;
    const double miss3 = COIN_PRIV_MISS3 * s4 * size;
    const double miss4 = COIN_PRIV_MISS4 * s4 * stride * size;
    if (stays_in_cone(contact, a, b, tau / 3, &a->force, miss3))
        return 1;
    const double low = coin_priv_lesser(a->square_margin, b->square_margin);
    if (!(low > allowed * coin_priv_lesser(a->weight, b->weight)))
        return 0;
    *mid = need_within(contact, f, l, a, b, tau, PLACES / 2);
    const coin_priv_need point = third_point(a, b, tau, mid);
    if (stays_in_cone(contact, a, b, tau / 4, &point, miss4))
        return 1;
    const struct cone_margin m = margin_of(contact, mid);
    if (!(m.square_margin > allowed * m.weight))
        return 0;
    at[0] = need_within(contact, f, l, a, b, tau, 0);
    at[PLACES - 1] = need_within(contact, f, l, a, b, tau, PLACES - 1);
    return has_margin(contact, a, b, at, allowed);
}
