/* SPDX-License-Identifier: MIT */
/* The first touch of a flight.
 *
 * The lowest point of the rim is |n_h| below the centre, n_h the horizontal
 * part of e_Z.  The gap has a kink where the face is horizontal, G = y^2 -
 * |n_h|^2 has none, and has the sign of the gap.  A bound of its second
 * derivative says how far no zero can be. */
#include "../motion/pinned.h"

#include "air.h"
#include "space.h"

#include <float.h>

/* Where the gap grows from nothing, a step is at least this long, times sqrt(y)
 * over 1 + rate: a dip that it passes over is less than 1e-14 deep. */
#define LEAST 1e-7

/* A search ends after so many looks at the gap. */
#define MOST_LOOKS 100

/* What G and its bounds are computed from. */
struct arc {
    double y, vy;
    double nh[2], c1[2], c2[2]; /* n_h = nh + sin(rate t) c1 +
                                   (1 - cos(rate t)) c2 */
    double rate;
    double top;        /* no point of the rim is further below the centre */
    double bend, jerk; /* where y <= top: G'' >= -2 bend, |G'''| <= jerk */
};

static void arc_of(struct arc *r, const coin_priv_flight *f)
{
    const double *const k = f->k, *const n = f->n, w = f->rate;
    const double along = coin_priv_dot(k, n);
    double q[3];
    coin_priv_cross(q, k, n);
    for (int i = 0; i < 2; ++i) {
        r->nh[i] = n[2 * i];
        r->c1[i] = q[2 * i];
        r->c2[i] = k[2 * i] * along - n[2 * i];
    }
    const double kh = sqrt(k[0] * k[0] + k[2] * k[2]);
    const double across = sqrt(coin_priv_dot(q, q));
    const double A = along * k[1], D = kh * across;
    r->y = f->y;
    r->vy = f->vy;
    r->rate = w;
    r->top = 1;
    if (w == 0)
        r->top = sqrt(n[0] * n[0] + n[2] * n[2]);
    else if (fabs(A) > D)
        r->top = kh * fabs(along) + fabs(k[1]) * across; /* (102) */
    const double fall = sqrt(f->vy * f->vy + 2 * f->y);
    const double peak = f->vy > 0 ? fall * fall / 2 : f->y;
    const double high = peak < r->top ? peak : r->top;
    r->bend = high + w * w * D * (fabs(A) + D);                 /* (103) */
    r->jerk = 6 * fall + w * w * w * D * (2 * fabs(A) + 4 * D); /* (103) */
}

/* G and its derivatives. */
struct look {
    double y, G, d, dd;
};

static struct look look_at(const struct arc *r, double t)
{
    const coin_priv_sc half = coin_priv_sincos(r->rate * t / 2);
    const double S = 2 * half.s * half.c, C = 2 * half.s * half.s, c = 1 - C;
    const double y = r->y + t * (r->vy - t / 2), v = r->vy - t;
    double nn = 0, nd = 0, dd = 0;
    for (int i = 0; i < 2; ++i) {
        const double n = r->nh[i] + S * r->c1[i] + C * r->c2[i];
        const double d = c * r->c1[i] + S * r->c2[i];
        nn += n * n;
        nd += n * d;
        dd += d * d + n * (c * r->c2[i] - S * r->c1[i]);
    }
    const struct look at = {
        y,
        y * y - nn, /* (101) */
        2 * (y * v - r->rate * nd),
        2 * (v * v - y - r->rate * r->rate * dd),
    };
    return at;
}

/* How far from here there is surely no zero. */
static double safe(const struct arc *r, const struct look *at)
{
    const double K = r->bend, root = sqrt(at->d * at->d + 4 * K * at->G);
    if (at->d < 0)
        return 2 * at->G / (root - at->d); /* (104) */
    const double rises = at->dd / r->jerk; /* (104) */
    const double least = LEAST * sqrt(at->y) / (1 + r->rate);
    const double h = (at->d + root) / (2 * K);
    const double longer = h > rises ? h : rises;
    return longer > least ? longer : least;
}

/* Searches for the first touch from the time found->t to `end`, where the
 * centre is low enough for one: y <= top.  Sets *found to the touch; or, if
 * there is none, found->t to the time up to which none was found. */
static void search(coin_priv_touch *found, const struct arc *r, double end,
                   int leaves)
{
    while (found->t < end && found->looks < MOST_LOOKS) {
        struct look at = look_at(r, found->t);
        const int zero = at.G <= 4 * DBL_EPSILON * (at.y * at.y);
        ++found->looks;
        found->touches = !leaves && zero;
        if (found->touches)
            return;
        if (leaves)
            at.G = 0;
        leaves = 0;
        const double h = safe(r, &at);
        found->touches = !(h > 2 * DBL_EPSILON * found->t);
        if (found->touches)
            return;
        found->t += h;
    }
    if (found->t > end)
        found->t = end;
}

coin_priv_touch coin_priv_first_touch(const coin_priv_flight *f, double t,
                                      int leaves)
{
    struct arc r;
    coin_priv_touch found = {0, 0, 0}, none = {t, 0, 0};
    if (f->y > 1 && f->y + t * (f->vy - t / 2) > 1)
        return none; /* the rim is at most 1 below the centre */
    arc_of(&r, f);
    const double v = r.vy, above = r.y - r.top, square = v * v + 2 * above;
    const double root = square > 0 ? sqrt(square) : 0;
    double up = 0, down = 0; /* between them y > top */
    if (above > 0) {
        down = v > 0 ? v + root : 2 * above / (root - v);
    } else if (v > 0 && square > 0) {
        up = -2 * above / (v + root);
        down = v + root;
    }
    search(&found, &r, up < t ? up : t, leaves);
    if (found.touches || found.looks == MOST_LOOKS)
        return found;
    found.t = down < t ? down : t;
    search(&found, &r, t, leaves && up == 0 && down == 0);
    return found;
}
