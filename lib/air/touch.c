/* SPDX-License-Identifier: MIT */
/* The first touch of a flight.
 *
 * The centre of a rim is Y = y + eta n_y high.  Its lowest point is |n_h|
 * lower, where n_h is the horizontal part of e_Z.  This gap, Y - |n_h|, has a
 * kink where the face is horizontal.  G = Y^2 - |n_h|^2 has the same sign and
 * no kink, so its zeros are looked for.  A bound of the second derivative of G
 * says how long there is surely none.  A coin with a thickness has two rims:
 * the earlier touch counts. */
#include "../motion/pinned.h"

#include "air.h"

#include <float.h>

/* A search ends after so many looks at the gap, and the flight goes on from
 * there.  Measured: MOST_LOOKS in tables.md. */
#define MOST_LOOKS 100

/* What G and its bounds are computed from. */
struct arc {
    double y, vy, eta;
    double n[3], c1[3], c2[3]; /* e_Z = n + sin(angle) c1 + (1 - cos(angle)) c2,
                                  along e_X, e_h and e_y of the start; angle is
                                  rate times the time of (116) */
    double rate, angular;
    double top;        /* no point of the rim is further below the centre of
                          the coin */
    double bend, jerk; /* where y <= top: G'' >= -2 bend, |G'''| <= jerk */
};

static void arc_of(struct arc *r, const coin_priv_flight *f, double eta)
{
    const coin_priv_coin *const from = &f->from;
    const double s = from->th.s, c = from->th.c, w = f->rate;
    const double kX = f->kX, kY = f->kY, kZ = f->kZ;
    const double kh = s * kY + c * kZ, ky = c * kY - s * kZ;
    const double across2 = kX * kX + kY * kY, across = sqrt(across2);
    const double level = sqrt(kX * kX + kh * kh);
    const double A = kZ * ky, D = level * across, b = f->angular;
    const double h = fabs(eta);
    const double above = coin_priv_larger(from->y, 0); /* below by rounding */
    const double fall = sqrt(from->vy * from->vy + 2 * above);
    const double peak = from->vy > 0 ? fall * fall / 2 : from->y;
    r->y = from->y;
    r->vy = from->vy;
    r->eta = eta;
    r->n[0] = 0;
    r->n[1] = c;
    r->n[2] = -s;
    r->c1[0] = kY;
    r->c1[1] = -s * kX;
    r->c1[2] = -c * kX;
    r->c2[0] = kX * kZ;
    r->c2[1] = s * kY * kZ - c * across2;
    r->c2[2] = c * kY * kZ + s * across2;
    r->rate = w;
    r->angular = f->angular;
    r->top = 1;
    if (w == 0)
        r->top = c;
    else if (fabs(A) > D)
        r->top = level * fabs(kZ) + fabs(ky) * across; /* (102) */
    r->top += h;
    /* of the height of the rim's centre: the most, its speed and so on */
    const double most = coin_priv_lesser(peak, r->top) + h;
    const double speed = fall + h * w * D, lift = 1 + h * w * (w + b) * D;
    const double twist = h * w * (w * w + (3 * w + b) * b) * D;
    r->bend =
        most * lift + (w + b) * w * D * (fabs(A) + D); /* (103), (117), (124) */
    r->jerk =
        6 * speed * lift + 2 * most * twist +
        w * w * w * D * (2 * fabs(A) + 4 * D) +
        (3 * w + b) * b * w * 2 * D * (fabs(A) + D); /* (103), (117), (124) */
}

/* The height of the rim's centre; G and its derivatives by the time.
 * look_at() has those of n, the horizontal part of e_Z, by the angle: d, and
 * the sums nn of n^2, nd of its half slope, nd_slope of the slope of that. */
struct look {
    double y, G, d, dd;
};

static struct look look_at(const struct arc *r, double t)
{
    const coin_priv_decay slows = coin_priv_decay_of(r->angular * t);
    const double turned = slows.part * t;  /* from (116) */
    const double w = slows.left * r->rate; /* from (116) */
    const coin_priv_sc half = coin_priv_sincos(r->rate * turned / 2);
    const double S = 2 * half.s * half.c, versine = 2 * half.s * half.s,
                 cosine = 1 - versine;
    double y = r->y + t * (r->vy - t / 2), v = r->vy - t, lift = -1;
    double nn = 0, nd = 0, nd_slope = 0;
    if (r->eta != 0) {
        const double turn = cosine * r->c1[2] + S * r->c2[2];
        y += r->eta * (r->n[2] + S * r->c1[2] + versine * r->c2[2]);
        v += r->eta * (w * turn);
        lift += r->eta * (w * w * (cosine * r->c2[2] - S * r->c1[2]) -
                          r->angular * w * turn);
    }
    for (int i = 0; i < 2; ++i) {
        const double n = r->n[i] + S * r->c1[i] + versine * r->c2[i];
        const double d = cosine * r->c1[i] + S * r->c2[i];
        nn += n * n;
        nd += n * d;
        nd_slope += d * d + n * (cosine * r->c2[i] - S * r->c1[i]);
    }
    const struct look at = {
        y,
        y * y - nn, /* (101) */
        2 * (y * v - w * nd),
        2 * (v * v + y * lift - (w * w * nd_slope - r->angular * w * nd)),
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
    return coin_priv_larger((at->d + root) / (2 * K), rises);
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
        if (leaves) { /* whatever rounding says */
            at.G = 0;
            at.d = coin_priv_larger(at.d, 0);
        }
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

coin_priv_touch coin_priv_rim_touch(const coin_priv_flight *f, double eta,
                                    double t, int leaves)
{
    struct arc r;
    coin_priv_touch found = {0, 0, 0};
    arc_of(&r, f, eta);
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

coin_priv_touch coin_priv_first_touch(const coin_priv_flight *f, double t,
                                      int leaves)
{
    const double h = f->from.half, s = f->from.th.s, far = 1 + h;
    const coin_priv_touch none = {t, 0, 0};
    if (f->from.y > far && f->from.y + t * (f->from.vy - t / 2) > far)
        return none; /* the rims are at most so far below the centre */
    if (h == 0)
        return coin_priv_rim_touch(f, 0, t, leaves);
    const coin_priv_touch a = coin_priv_rim_touch(f, h, t, leaves && s >= 0);
    const coin_priv_touch b = coin_priv_rim_touch(f, -h, a.t, leaves && s <= 0);
    return b.touches || b.t < a.t ? b : a;
}
