/* SPDX-License-Identifier: MIT */
/* The force along a stretch is a curve of degree 13, whose numbers in
 * Bernstein's form lie around it.  The cone of friction and the half-space
 * above the table are convex: a curve whose numbers all lie within lies within,
 * and this is so of most stretches.  Of the others the zeros of polynomials are
 * isolated; the motion itself then says whether, and from when on, a bit holds.
 */
#include "../motion/pinned.h"

#include "../step/sundman.h"

#include "event.h"

#include <math.h>

enum { JOINED = COIN_PRIV_JOINED };

/* COIN_NEARLY_FLAT begins at this cos theta. */
#define NEARLY_FLAT 0.01

/* A curve over the longest step errs by up to 4 % of the force, 1e-8 over one
 * of SHORT strides.  So a stretch is left alone where its numbers keep a tenth
 * of the force from the edge, and else taken in parts that are short. */
#define KEEP 0.9
#define SHORT 0.7

/* A part of a stretch, the force along it in Bernstein's form, scaled so that
 * the coin slips where along^2 + across^2 > bound^2. */
struct part {
    const coin_priv_stretch *of;
    double first, width;
    double along[JOINED + 1], across[JOINED + 1], bound[JOINED + 1];
    double normal[JOINED + 1], cth[JOINED + 1];
};

static int32_t bits_of(const coin_priv_search *f, const coin_state *s)
{
    const int32_t bits = coin_check(s, f->p, COIN_RK4, 0, f->mu);
    return bits > 0 ? bits & f->bits : 0;
}

int32_t coin_priv_bits_held(const coin_priv_search *f, const coin_state *s,
                            const coin_priv_force *at)
{
    const double A = at->along[0], B = at->across[0], C = at->normal[0];
    const double mu = f->mu < 1 ? f->mu : 1, F2 = A * A + B * B;
    const double room = KEEP * mu * C;
    const int is_clear =
        (C > 0) & (F2 <= room * room) & (at->cth[0] > (1 + KEEP) * NEARLY_FLAT);
    return is_clear ? 0 : bits_of(f, s);
}

/* The run at x of a stretch, without its lean.  No step is made of no time. */
static coin_priv_run run_to(const coin_priv_stretch *w, double x)
{
    coin_priv_run r = w->from;
    r.g.added.t = 0;
    if (x > 0)
        (void)coin_priv_extrapolate(&r, x * w->tau);
    return r;
}

static coin_priv_moment moment_of(const coin_priv_search *f,
                                  const coin_priv_stretch *w, double x)
{
    coin_priv_moment m = {x, run_to(w, x), 0};
    coin_priv_read_lean(&m.run.g);
    const coin_state s = coin_priv_run_state(&m.run);
    m.bits = bits_of(f, &s);
    return m;
}

/* ----------------------------------------------------- a part's polynomials */
/* Between two forces, x = first to first + width; only what the bits ask for.
 */
static void join(struct part *w, const coin_priv_search *f,
                 const coin_priv_force *begin, const coin_priv_force *end)
{
    const double h = w->width * w->of->tau / f->unit;
    const double less = f->mu > 1 ? 1 / f->mu : 1, more = f->mu > 1 ? 1 : f->mu;
    if (f->bits & COIN_NEARLY_FLAT)
        coin_priv_join(w->cth, begin->cth, end->cth, h);
    if (f->bits & (COIN_SLIPS | COIN_LIFTS))
        coin_priv_join(w->normal, begin->normal, end->normal, h);
    if (!(f->bits & COIN_SLIPS))
        return;
    coin_priv_join(w->along, begin->along, end->along, h);
    coin_priv_join(w->across, begin->across, end->across, h);
    for (int k = 0; k <= JOINED; ++k) {
        w->along[k] *= less;
        w->across[k] *= less;
        w->bound[k] = more * w->normal[k];
    }
}

/* Whether the force stays in the cone that is narrower by a factor. */
static int is_in_cone(const struct part *w, double keep)
{
    int in = 1;
    for (int k = 0; k <= JOINED; ++k) {
        const double A = w->along[k], B = w->across[k];
        const double C = keep * w->bound[k];
        in &= (A * A + B * B <= C * C) & (w->normal[k] > 0);
    }
    return in;
}

static int is_above(const double *b, double least)
{
    int above = 1;
    for (int k = 0; k <= JOINED; ++k)
        above &= b[k] > least;
    return above;
}

/* Whether no bit holds in the part, and none nearly does. */
static int is_far(const coin_priv_search *f, const struct part *w)
{
    const double *N = w->normal;
    if ((f->bits & COIN_SLIPS) && !is_in_cone(w, KEEP))
        return 0;
    if ((f->bits & (COIN_SLIPS | COIN_LIFTS)) &&
        !is_above(N, (1 - KEEP) * (N[0] > N[JOINED] ? N[0] : N[JOINED])))
        return 0;
    return !(f->bits & COIN_NEARLY_FLAT) || is_above(w->cth, 5 * NEARLY_FLAT);
}

static double lesser(double a, double b)
{
    return a < b ? a : b;
}

static void negate(double *b, int degree)
{
    for (int k = 0; k <= degree; ++k)
        b[k] = -b[k];
}

/* Where in a part a bit holds, by the polynomials; from > 1 if nowhere. */
struct place {
    double from, to;
};

static struct place earlier(struct place a, struct place b)
{
    return a.from <= b.from ? a : b;
}

/* Where a polynomial is positive next, which is negated. */
static struct place positive(double *b, int degree, double from)
{
    struct place r = {coin_priv_rise(b, degree, from), 2};
    negate(b, degree);
    if (r.from < 2)
        r.to = coin_priv_rise(b, degree, r.from);
    return r;
}

/* Where b < least. */
static struct place below_least(const double *b, double least, double from)
{
    double left[JOINED + 1];
    for (int k = 0; k <= JOINED; ++k)
        left[k] = least - b[k];
    return positive(left, JOINED, from);
}

/* Where the force leaves the cone while N > 0, and where N becomes so. */
static struct place slip(const struct part *w, double from)
{
    double cone[COIN_PRIV_SQUARED + 1], rest[JOINED + 1];
    struct place r = {from, 2};
    do {
        coin_priv_cone(cone, w->along, w->across, w->bound);
        r = positive(cone, COIN_PRIV_SQUARED, r.from);
    } while (r.from < 2 && coin_priv_value(w->normal, JOINED, r.from) <= 0);
    if (is_above(w->normal, 0))
        return r;
    for (int k = 0; k <= JOINED; ++k)
        rest[k] = w->normal[k];
    const struct place up = positive(rest, JOINED, from > 0 ? from : 0);
    r.to = lesser(r.to, coin_priv_rise(rest, JOINED, r.from));
    return earlier(r, up);
}

/* The next place beyond `from` where a bit holds. */
static struct place next_place(const coin_priv_search *f, const struct part *w,
                               double from)
{
    struct place r = {2, 2};
    if ((f->bits & COIN_SLIPS) && !is_in_cone(w, 1))
        r = slip(w, from);
    if ((f->bits & COIN_LIFTS) && !is_above(w->normal, 0))
        r = earlier(r, below_least(w->normal, 0, from));
    if ((f->bits & COIN_NEARLY_FLAT) && !is_above(w->cth, NEARLY_FLAT))
        r = earlier(r, below_least(w->cth, NEARLY_FLAT, from));
    return r;
}

/* ------------------------------------------------------------ its first event
 */
/* Whether the coin is held down: the sign of N. */
static int presses(const coin_priv_search *f, const coin_priv_moment *m)
{
    coin_force force = {{0, 0, 0}, 0, 0, 0};
    const coin_state s = coin_priv_run_state(&m->run);
    (void)coin_reaction(&s, f->p, &force);
    return force.normal > 0;
}

/* A moment within (low, high) from which on a bit holds, to within tol: at the
 * end of the bracket no bit holds at low, at high one does. */
static void bisect(const coin_priv_search *f, const coin_priv_stretch *w,
                   double low, coin_priv_moment *high, double tol)
{
    while (high->x - low > tol) {
        const coin_priv_moment m = moment_of(f, w, low + (high->x - low) / 2);
        if (m.bits != 0)
            *high = m;
        else
            low = m.x;
    }
}

/* A moment at which a bit holds where two others, at which none does, have N
 * of different signs: between them F exceeds every multiple of N. */
static coin_priv_moment between(const coin_priv_search *f,
                                const coin_priv_stretch *w,
                                coin_priv_moment low, coin_priv_moment high)
{
    const int side = presses(f, &high);
    while (side != presses(f, &low)) {
        const coin_priv_moment m =
            moment_of(f, w, low.x + (high.x - low.x) / 2);
        if (m.bits != 0 || !(m.x > low.x && m.x < high.x))
            return m;
        if (presses(f, &m) == side)
            high = m;
        else
            low = m;
    }
    return high;
}

/* The part of a stretch that lasts no longer than tol: cos theta changes by a
 * factor below 3 in half a step. */
static double least_part(const coin_priv_search *f, const coin_priv_stretch *w)
{
    const double a = w->begin.cth[0], b = w->end.cth[0];
    return f->tol / (3 * fabs(w->tau) * (a > b ? a : b));
}

/* The moment from which on a bit holds, within tol, at or next to a place of a
 * part, as the motion itself says; its bits are 0 if none does. */
static coin_priv_moment locate(const coin_priv_search *f, const struct part *w,
                               struct place at)
{
    const double tol = least_part(f, w->of);
    const double from = w->first + w->width * at.from;
    const double to = w->first + w->width * lesser(at.to, 1);
    const double middle = from + (to - from) / 2;
    double width = tol / 4, low = from - width;
    coin_priv_moment high = moment_of(f, w->of, lesser(from + width, middle));
    if (high.bits == 0 && high.x < middle)
        high = moment_of(f, w->of, middle);
    if (high.bits == 0)
        high = between(f, w->of, moment_of(f, w->of, low > 0 ? low : 0),
                       moment_of(f, w->of, lesser(to + width, 1)));
    if (high.bits == 0)
        return high;
    for (; low > 0; low = from - width) {
        const coin_priv_moment m = moment_of(f, w->of, low);
        if (m.bits == 0)
            break;
        high = m;
        width *= 8;
    }
    bisect(f, w->of, low > 0 ? low : 0, &high, tol);
    return high;
}

/* The places are zeros of polynomials, and so few. */
static int first_of_part(coin_priv_moment *out, const coin_priv_search *f,
                         const struct part *w)
{
    struct place at = {-1, 2};
    for (;;) {
        at = next_place(f, w, at.from);
        if (at.from > 1)
            return 0;
        *out = locate(f, w, at);
        if (out->bits != 0)
            return 1;
    }
}

/* A stretch that is not left alone, in parts. */
static int first_in_parts(coin_priv_moment *out, const coin_priv_search *f,
                          struct part *part)
{
    const coin_priv_stretch *w = part->of;
    const coin_priv_body *b = &w->from.b;
    const double stride =
        fabs(w->tau) / coin_priv_sundman_tau(b, &w->from.g.y, 1);
    const int parts = 1 + (int)(stride / SHORT);
    coin_priv_force begin = w->begin, end;
    part->width = 1.0 / parts;
    for (int i = 1; i <= parts; ++i) {
        end = w->end;
        if (i < parts) {
            const coin_priv_run r = run_to(w, i * part->width);
            coin_priv_force_of(&end, b, &r.g.y, f->unit);
        }
        join(part, f, &begin, &end);
        if (first_of_part(out, f, part))
            return 1;
        part->first = i * part->width;
        begin = end;
    }
    return 0;
}

int coin_priv_first_event(coin_priv_moment *out, const coin_priv_search *f,
                          const coin_priv_stretch *w)
{
    struct part part;
    part.of = w;
    part.first = 0;
    part.width = 1;
    join(&part, f, &w->begin, &w->end);
    return is_far(f, &part) ? 0 : first_in_parts(out, f, &part);
}
