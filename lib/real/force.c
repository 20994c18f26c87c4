/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "force.h"

#include "ends.t.h"

enum { TERMS = COIN_PRIV_FORCE_TERMS };

/* The series of the variables, one term longer than those of the force, and of
 * the products in (32). */
struct series {
    lanes X[TERMS + 1], Y[TERMS + 1], Z[TERMS + 1];
    lanes s[TERMS + 1], c[TERMS + 1];
    lanes cX[TERMS + 1], sX[TERMS + 1], cZ[TERMS], sY[TERMS];
    lanes down[TERMS], up[TERMS]; /* in (32): -Y down is a part of the slope of
                                     X, and X up is the slope of Y */
};

/* Term k of a product.  The terms computed last are added last, so that the sum
 * of the others does not wait for them. */
COIN_PRIV_INLINE lanes product(const lanes *a, const lanes *b, int k)
{
    lanes sum = {0};
#pragma GCC unroll 8
    for (int i = 1; i < k; ++i)
        sum += a[i] * b[k - i];
    return k == 0 ? a[0] * b[0] : sum + (a[0] * b[k] + a[k] * b[0]);
}

/* Term k of the products, where those of c X and s X are already there, and
 * term k + 1 of the variables. */
COIN_PRIV_INLINE void next_terms(struct series *w, coin_priv_force_series *out,
                                 const coin_priv_field *f, int k, int which)
{
    const double part = 1.0 / (k + 1);
    w->cZ[k] = product(w->c, w->Z, k);
    w->sY[k] = product(w->s, w->Y, k);
    w->down[k] = f->KJ * w->cZ[k] + f->XJ * w->sY[k];
    w->up[k] = w->sY[k] + f->k1 * w->cZ[k];
    const lanes cXY = product(w->Y, w->cX, k);
    const lanes fall = f->GJ * product(w->s, w->c, k);
    /* clang-format off */
    w->X[k + 1] = part * (fall - product(w->Y, w->down, k));    /* (32) */
    w->Y[k + 1] = part * product(w->X, w->up, k);               /* (32) */
    w->Z[k + 1] = part * (f->k2 * cXY);                         /* (32) */
    w->s[k + 1] = part * product(w->c, w->cX, k);               /* (32) */
    w->c[k + 1] = -part * product(w->c, w->sX, k);              /* (32) */
    /* clang-format on */
    store(&out->X[k].at[which], cXY);
    store(&out->h[k].at[which], product(w->Y, w->Z, k));
    store(&out->cth[k].at[which], w->c[k]);
}

void coin_priv_force_series_of(coin_priv_force_series *out,
                               const coin_priv_body *b,
                               const coin_priv_variables *begin,
                               const coin_priv_variables *end, double unit,
                               int terms)
{
    const double g_a = unit * unit * b->g_a, share = b->IZ / b->K;
    const coin_priv_field f = {
        unit, unit * unit * b->GJ, b->KJ, b->XJ, b->k1, b->k2,
    };
    for (int which = 0; which < 2; which += LANES) {
        struct series w;
        w.X[0] = unit * at_ends(begin->wX, end->wX, which);
        w.Y[0] = unit * at_ends(begin->wY, end->wY, which);
        w.Z[0] = unit * at_ends(begin->wZ, end->wZ, which);
        w.s[0] = at_ends(begin->sth, end->sth, which);
        w.c[0] = at_ends(begin->cth, end->cth, which);
#pragma GCC unroll 8
        for (int k = 0; k <= TERMS; ++k) {
            if (k > terms)
                break;
            w.cX[k] = product(w.c, w.X, k);
            w.sX[k] = product(w.s, w.X, k);
            if (k < TERMS && k < terms)
                next_terms(&w, out, &f, k, which);
        }
        for (int k = 0; k < terms; ++k) {
            double *const X = &out->X[k].at[which];
            double *const h = &out->h[k].at[which];
            double *const normal = &out->normal[k].at[which];
            const double next = k + 1;
            store(X, share * load(X));                        /* (92) */
            store(h, load(h) + next * w.cX[k + 1]);           /* (92) */
            store(normal, g_a * w.c[k] - next * w.sX[k + 1]); /* (92) */
        }
    }
    out->terms = terms;
}
