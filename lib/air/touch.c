/* SPDX-License-Identifier: MIT */
/* The first touch of a flight.
 *
 * The lowest point of the rim is |n_h| below the centre, n_h the horizontal
 * part of e_Z.  The gap has a kink where the face is horizontal, G = y^2 -
 * |n_h|^2 has none, and has the sign of the gap.  A bound of its second
 * derivative says how far no zero can be. */
#include "../motion/pinned.h"

#include "air.h"

#include <float.h>

/* Where the gap grows from nothing, a step is at least this long, times sqrt(y)
 * over 1 + rate: a dip that it passes over is less than 1e-14 deep, LEAST^2.  A
 * tenth or ten times of it changes nothing (make tuning). */
#define LEAST 1e-7

/* A search ends after so many looks at the gap, and the flight goes on from
 * there.  Half or twice of it costs the same (make tuning). */
#define MOST_LOOKS 100

/* What G and its bounds are computed from. */
struct arc {
    double y, vy;
    double nh[2], c1[2], c2[2]; /* n_h = nh + sin(rate t) c1 +
                                   (1 - cos(rate t)) c2, along e_X and e_h of
                                   the start */
    double rate;
    double top;        /* no point of the rim is further below the centre */
    double bend, jerk; /* where y <= top: G'' >= -2 bend, |G'''| <= jerk */
};

static void arc_of(struct arc *r, const coin_priv_flight *f)
{
    const double s = f->at.th.s, c = f->at.th.c, w = f->rate;
    const double kX = f->kX, kY = f->kY, kZ = f->kZ;
    const double kh = s * kY + c * kZ, ky = c * kY - s * kZ;
    const double across2 = kX * kX + kY * kY, across = sqrt(across2);
    const double level = sqrt(kX * kX + kh * kh);
    const double A = kZ * ky, D = level * across;
    const double above = coin_priv_larger(f->y, 0); /* below by rounding */
    const double fall = sqrt(f->vy * f->vy + 2 * above);
    const double peak = f->vy > 0 ? fall * fall / 2 : f->y;
    r->y = f->y;
    r->vy = f->vy;
    r->nh[0] = 0;
    r->nh[1] = c;
    r->c1[0] = kY;
    r->c1[1] = -s * kX;
    r->c2[0] = kX * kZ;
    r->c2[1] = s * kY * kZ - c * across2;
    r->rate = w;
    r->top = 1;
    if (w == 0)
        r->top = c;
    else if (fabs(A) > D)
        r->top = level * fabs(kZ) + fabs(ky) * across; /* (102) */
    r->bend =
        coin_priv_lesser(peak, r->top) + w * w * D * (fabs(A) + D); /* (103) */
    r->jerk = 6 * fall + w * w * w * D * (2 * fabs(A) + 4 * D);     /* (103) */
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

/* The first zero of G + d h - K h^2 where d < 0; infinity if there is none. */
static double falls_to_zero(const struct look *at, double K)
{
    const double square = at->d * at->d + 4 * K * at->G;
    return square < 0 ? (double)INFINITY : 2 * at->G / (sqrt(square) - at->d);
}

/* How far from here there is surely no zero.  Where G falls: h by the bound of
 * G'', and farther by G'' here and the bound of G''', up to 2 h.  *width: how
 * far from there a zero lies at most, if there surely is one within 2 h. */
static double safe(const struct arc *r, const struct look *at, double *width)
{
    const double K = r->bend, bend = at->dd / 2;
    *width = (double)INFINITY;
    if (at->d < 0) {
        const double h = falls_to_zero(at, K), e = r->jerk * h / 3;
        const double early = falls_to_zero(at, e - bend);
        const double late = falls_to_zero(at, -e - bend);
        if (late <= 2 * h)
            *width = late - early;
        return coin_priv_larger(h, coin_priv_lesser(early, 2 * h));
    }
    const double root = sqrt(at->d * at->d + 4 * K * at->G);
    const double rises = at->dd / r->jerk; /* (104) */
    const double y = coin_priv_larger(at->y, 0);
    const double least = LEAST * sqrt(y) / (1 + r->rate);
    const double h = coin_priv_larger((at->d + root) / (2 * K), rises);
    return coin_priv_larger(h, least);
}

/* Searches for the first touch from the time found->t to `end`, where the
 * centre is low enough for one: y <= top.  Sets *found to the touch; or, if
 * there is none, found->t to the time up to which none was found. */
static void search(coin_priv_touch *found, const struct arc *r, double end,
                   int leaves)
{
    while (!found->touches && found->t < end && found->looks < MOST_LOOKS) {
        struct look at = look_at(r, found->t);
        const int zero = at.y <= 0 || at.G <= 4 * DBL_EPSILON * (at.y * at.y);
        double h = 0, width = (double)INFINITY;
        ++found->looks;
        at.G = leaves ? 0 : at.G;
        if (leaves || !zero)
            h = safe(r, &at, &width);
        leaves = 0;
        found->t += h;
        found->touches =
            coin_priv_lesser(h, width) <= 2 * DBL_EPSILON * found->t &&
            found->t <= end;
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
