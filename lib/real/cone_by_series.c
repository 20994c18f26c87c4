/* SPDX-License-Identifier: MIT */
/* The cone of friction and the half-space above the table are convex: a curve
 * of force whose numbers in Bernstein's form all lie within lies within.  Where
 * that does not decide, it may for the halves of the curve.  Of the few curves
 * left the zeros of polynomials are isolated. */
#include "../motion/pinned.h"

#include "../step/sundman.h"

#include "cone_by_series.h"

#include <math.h>

enum {
    JOINED = COIN_PRIV_JOINED,
    ALL = COIN_PRIV_FORCE_TERMS,
    SOME = COIN_PRIV_FORCE_SOME,
    FEW = COIN_PRIV_FORCE_FEW
};

/* The bits that are about the force. */
#define ON_FORCE (COIN_SLIPS | COIN_LIFTS)

/* How often a curve is halved.  Only the cost depends on it: what is left in
 * doubt is decided by other means.  From 4 to 10 the same steps of random
 * motions are decided, with 2 one in 2400 is not (make tuning). */
enum { CUTS = 5 };

/* ------------------------------------------------------ beyond any doubt -- */
/* Whether Bernstein point k lies in the cone; the first and the last are points
 * of the curve. */
COIN_PRIV_INLINE int is_in_cone(const coin_priv_curve *w, int k)
{
    const double A = w->X[k], B = w->h[k], C = w->bound[k];
    return (A * A + B * B <= C * C) & (C >= 0);
}

COIN_PRIV_INLINE int is_within(const coin_priv_curve *w, int degree)
{
    int in = 1;
    for (int k = 0; k <= degree; ++k)
        in &= is_in_cone(w, k);
    return in;
}

/* Whether it is certain that the whole curve lies in the cone.  The parts still
 * to be tested are in a stack, the next one on top. */
COIN_PRIV_INLINE int stays_within(coin_priv_curve stack[CUTS + 1], int terms)
{
    const int degree = COIN_PRIV_DEGREE(terms);
    int cuts[CUTS + 1] = {0};
    size_t parts = 1;
    while (parts > 0) {
        const size_t top = parts - 1;
        coin_priv_curve *const now = &stack[top], *const half = &stack[parts];
        if (is_within(now, degree)) {
            parts = top;
            continue;
        }
        if (cuts[top] == CUTS || !is_in_cone(now, degree))
            return 0;
        coin_priv_halve_joined(half->X, now->X, terms);
        coin_priv_halve_joined(half->h, now->h, terms);
        coin_priv_halve_joined(half->bound, now->bound, terms);
        cuts[parts] = ++cuts[top];
        ++parts;
    }
    return 1;
}

/* The size of term k of the force at an end, 0 or 1. */
static double size_of(const coin_priv_force_series *f, int k, int end)
{
    return fabs(f->X[k].at[end]) + fabs(f->h[k].at[end]) +
           fabs(f->normal[k].at[end]);
}

/* How fast the force changes at an end: the sum of its first and second
 * derivatives by strides, of which one is `one` units of the series. */
static double change_at(const coin_priv_force_series *f, int end, double one)
{
    return one * (size_of(f, 1, end) + one * size_of(f, 2, end));
}

/* How much nearer to the edge of the cone a force may be than it seems, if each
 * of its three components errs by 1: per_F sqrt(2) + per_N, rounded up. */
static double slack(const coin_priv_search *f)
{
    return 1.5 * f->per_F + f->per_N;
}

/* Whether the force at the end is in the cone, at least `off` from its edge. */
static int end_is_in_cone(const coin_priv_search *f,
                          const coin_priv_force_series *at, double off)
{
    const double A = f->per_F * at->X[0].at[1];
    const double B = f->per_F * at->h[0].at[1];
    const double C = f->per_N * at->normal[0].at[1] - off;
    return (A * A + B * B <= C * C) & (C >= 0);
}

/* Whether it is certain that the curve of the force stays in the cone all
 * along, at least `off` from its edge. */
static int force_stays(const coin_priv_search *f,
                       const coin_priv_force_series *at, double h, double off)
{
    coin_priv_curve stack[CUTS + 1], *const c = stack;
    const int terms = at->terms;
    coin_priv_join(c->X, at->X, h, f->per_F, terms);
    coin_priv_join(c->h, at->h, h, f->per_F, terms);
    coin_priv_join(c->bound, at->normal, h, f->per_N, terms);
    for (int k = 0; k <= COIN_PRIV_DEGREE(terms); ++k)
        c->bound[k] -= off;
    return terms == FEW    ? stays_within(stack, FEW)
           : terms == SOME ? stays_within(stack, SOME)
                           : stays_within(stack, ALL);
}

static int is_above(const double *b, double least, int degree)
{
    int above = 1;
    for (int k = 0; k <= degree; ++k)
        above &= b[k] > least;
    return above;
}

static int stays_off_flat(const coin_priv_force_series *at, double h,
                          double off)
{
    double c[JOINED + 1];
    coin_priv_join(c, at->cth, h, 1, at->terms);
    return is_above(c, COIN_PRIV_NEARLY_FLAT + off,
                    COIN_PRIV_DEGREE(at->terms));
}

/* The bound x of the error of a curve: cone_by_series.h. */
static double error_of(double stride, int terms)
{
    const double x = stride / (terms == FEW    ? COIN_PRIV_FEW_REACH
                               : terms == SOME ? COIN_PRIV_SOME_REACH
                                               : COIN_PRIV_REACH);
    const double x2 = x * x, x4 = x2 * x2;
    return x4 * x2 * (terms == FEW ? 1 : terms == SOME ? x4 : x4 * x4);
}

int coin_priv_is_clear(const coin_priv_search *f,
                       const coin_priv_force_series *at, double h,
                       double stride)
{
    /* Both underflow on a stretch of no length. */
    const double one = stride > 0 ? fabs(h) / stride : 0;
    const double error = error_of(stride, at->terms);
    const double change = change_at(at, 0, one) + change_at(at, 1, one);
    const double rise = error * (at->cth[0].at[0] + at->cth[0].at[1]);
    if ((f->bits & ON_FORCE) &&
        !force_stays(f, at, h, slack(f) * error * change))
        return 0;
    return !(f->bits & COIN_NEARLY_FLAT) || stays_off_flat(at, h, rise);
}

/* How many terms to try on a stretch of so many strides: the fewest whose error
 * is less than the distance of the force from the edge of the cone.  The
 * distance is that at the end of *at.  So are the changes of the force; if only
 * one term is set, they are taken to be as large as the force. */
static int terms_for(const coin_priv_search *f,
                     const coin_priv_force_series *at, double one,
                     double stride)
{
    if (!(f->bits & ON_FORCE) || at->terms == 0)
        return FEW;
    const double change =
        at->terms > 1 ? change_at(at, 1, one) : size_of(at, 0, 1);
    const double by = slack(f) * 2 * change;
    return end_is_in_cone(f, at, by * error_of(stride, FEW))    ? FEW
           : end_is_in_cone(f, at, by * error_of(stride, SOME)) ? SOME
                                                                : ALL;
}

int coin_priv_judge_stretch(const coin_priv_search *f, coin_priv_stretch *w,
                            double one)
{
    const double unit = one / w->unit, stride = fabs(w->tau) / one;
    for (int terms = terms_for(f, &w->force, unit, stride);;) {
        coin_priv_stretch_know(w, terms);
        if (coin_priv_is_clear(f, &w->force, w->tau / w->unit,
                               fabs(w->tau) / one))
            return 1;
        if (terms == ALL)
            return 0;
        const int more = terms_for(f, &w->force, unit, stride);
        terms = more > terms ? more : ALL;
    }
}

/* --------------------------------------------- where a bit holds in a part */
void coin_priv_join_part(coin_priv_part *w, const coin_priv_search *f,
                         const coin_priv_force_series *at)
{
    const double h = w->width * w->of->tau / w->of->unit;
    coin_priv_curve *const c = &w->force;
    if (f->bits & COIN_NEARLY_FLAT)
        coin_priv_join(w->cth, at->cth, h, 1, ALL);
    if (f->bits & ON_FORCE)
        coin_priv_join(w->normal, at->normal, h, 1, ALL);
    if (!(f->bits & COIN_SLIPS))
        return;
    coin_priv_join(c->X, at->X, h, f->per_F, ALL);
    coin_priv_join(c->h, at->h, h, f->per_F, ALL);
    for (int k = 0; k <= JOINED; ++k)
        c->bound[k] = f->per_N * w->normal[k];
}

/* Of two places that begin together it is the longer one. */
static coin_priv_place earlier(coin_priv_place a, coin_priv_place b)
{
    const int first = a.from < b.from || (a.from == b.from && a.to >= b.to);
    return first ? a : b;
}

/* The next place where the polynomial b is positive, up to where it is not. */
static coin_priv_place next_positive(const double *b, int degree, double from)
{
    coin_priv_place r = {coin_priv_first_positive(b, degree, from), 2};
    double minus[COIN_PRIV_SQUARED + 1];
    for (int k = 0; k <= degree; ++k)
        minus[k] = -b[k];
    if (r.from < 2)
        r.to = coin_priv_first_positive(minus, degree, r.from);
    return r;
}

/* Where b < least. */
static coin_priv_place below_least(const double *b, double least, double from)
{
    double lack[JOINED + 1];
    for (int k = 0; k <= JOINED; ++k)
        lack[k] = least - b[k];
    return next_positive(lack, JOINED, from);
}

/* Where the force leaves the cone, and where N comes from or goes to 0: next to
 * such a place F exceeds every multiple of N, if only for a moment. */
static coin_priv_place slip(const coin_priv_part *w, double from)
{
    double cone[COIN_PRIV_SQUARED + 1], pull[JOINED + 1];
    const double inside = from > 0 ? from : 0;
    coin_priv_cone_polynomial(cone, w->force.X, w->force.h, w->force.bound);
    coin_priv_place r = next_positive(cone, COIN_PRIV_SQUARED, from);
    if (is_above(w->normal, 0, JOINED))
        return r;
    for (int k = 0; k <= JOINED; ++k)
        pull[k] = -w->normal[k];
    const double down = coin_priv_first_positive(pull, JOINED, inside);
    r.to =
        coin_priv_lesser(r.to, coin_priv_first_positive(pull, JOINED, r.from));
    const coin_priv_place up = next_positive(w->normal, JOINED, inside);
    const coin_priv_place falls = {down, down};
    return earlier(earlier(r, up), falls);
}

coin_priv_place coin_priv_next_place(const coin_priv_search *f,
                                     const coin_priv_part *w, double from)
{
    coin_priv_place r = {2, 2};
    if ((f->bits & COIN_SLIPS) && !is_within(&w->force, JOINED))
        r = slip(w, from);
    if ((f->bits & COIN_LIFTS) && !is_above(w->normal, 0, JOINED))
        r = earlier(r, below_least(w->normal, 0, from));
    if ((f->bits & COIN_NEARLY_FLAT) &&
        !is_above(w->cth, COIN_PRIV_NEARLY_FLAT, JOINED))
        r = earlier(r, below_least(w->cth, COIN_PRIV_NEARLY_FLAT, from));
    return r;
}
