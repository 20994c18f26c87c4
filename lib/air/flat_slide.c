/* SPDX-License-Identifier: MIT */
/* A coin that lies flat and slides: friction of a uniform pressure over a disc,
 * or over the ring whose I_Z it has.
 *
 * In the time s, (113), speeds decay like exp(-s) up to the end,
 * where they vanish together as powers of the time left.  The law knows only
 * v/w: speeds are in units of v + w at the start, times in those over mu. */
#include "../motion/pinned.h"

#include "../motion/angles.h"

#include "air.h"

/* The error that a step may make. */
#define TOL 1e-12

/* When so little of v + w is left, the rest is braked as if steadily. */
#define LEFT 1e-12

/* A ring whose 1 - b^2/a^2 is less is computed as a hoop: (112) would divide
 * one small difference by another. */
#define THIN 1e-5
#define ROUNDING 1e-15

/* Of the speed of the centre and that of the rim, one that is less than this
 * part of the other counts as 0. */
#define NONE 1e-17

/* The most steps of a call. */
#define STEPS 400

enum { V, W, PATH, TURN, TIME, VARS };
enum { ROWS = 6 }; /* of extrapolation */

/* Force over mu M g and torque over mu M g a. */
struct drag {
    double f, t;
};

/* What elliptic integrals of the parameter q are made of: the limit of the
 * arithmetic-geometric mean of 1 and sqrt(1 - q), and Q, the sum of 2^(n-1)
 * (c_n/q)^2. */
struct mean {
    double M, Q;
};

static struct mean mean_of(double q)
{
    const double rest = 1 - q > 1e-18 ? 1 - q : 1e-18, k = sqrt(rest);
    double a = (1 + k) / 2, b = sqrt(k), d = 0.5 / (1 + k), c = q * d;
    double Q = d * d, weight = 1;
    while (c > 1e-9 * a) {
        const double next = (a + b) / 2;
        d *= c / (4 * next);
        c *= c / (4 * next);
        weight *= 2;
        Q += weight * (d * d);
        b = sqrt(a * b);
        a = next;
    }
    const struct mean r = {(a + b) / 2, Q};
    return r;
}

/* A disc of radius 1, whose rim turns at w. */
static struct drag of_disc(double v, double w)
{
    const double x = v <= w ? v / w : w / v, q = x * x;
    const struct mean m = mean_of(q);
    const double f = 2 / (3 * m.M) * (1.5 - q / 2 - (1 + q) * q * m.Q);
    const double slow = 3 - 3 * q + q * q - (4 - 2 * q) * (q * q) * m.Q;
    const double fast = x * (1 + (2 - 4 * q) * m.Q);
    const struct drag r = {
        v <= w ? f * x : f,                     /* (110) */
        2 / (9 * m.M) * (v <= w ? slow : fast), /* (110) */
    };
    return r;
}

/* A hoop. */
static struct drag of_hoop(double v, double w)
{
    const double x = v <= w ? v / w : w / v, q = x * x;
    const struct mean m = mean_of(q);
    const double large = (1 - q / 2 - q * q * m.Q) / m.M; /* (111) */
    const double small = x * (0.5 - q * m.Q) / m.M;       /* (111) */
    const struct drag slow = {small, large}, fast = {large, small};
    return v <= w ? slow : fast;
}

/* The square of the inner radius. */
static double hole(double IZ)
{
    const double B = 2 * IZ - 1;
    return B > 0 ? B < 1 ? B : 1 : 0;
}

static struct drag drag_of(double IZ, double v, double w)
{
    const double B = hole(IZ);
    const struct drag none = {0, 0};
    if (!(v + w > 0)) /* a trial beyond the end */
        return none;
    if (!(B > 0))
        return of_disc(v, w);
    if (B > 1 - THIN) { /* a hoop of the middle radius */
        const double r = sqrt((1 + B) / 2);
        struct drag thin = of_hoop(v, w * r);
        thin.t *= r;
        return thin;
    }
    const double b = sqrt(B), per = 1 / (1 - B);
    const struct drag out = of_disc(v, w), in = of_disc(v, w * b);
    const struct drag r = {
        (out.f - B * in.f) * per,     /* (112) */
        (out.t - B * b * in.t) * per, /* (112) */
    };
    return r;
}

/* A slide: its law, and its variables. */
struct slide {
    double IZ, tol;
    double y[VARS];
};

/* Slopes by s, or by mu t. */
static void slopes(double *d, const double *y, double IZ, int by_time)
{
    const double v = y[V] > 0 ? y[V] : 0, w = y[W] > 0 ? y[W] : 0;
    const double per = by_time ? 1 : v + w; /* (113) */
    const struct drag at = drag_of(IZ, v, w);
    d[V] = -at.f * per;      /* (109) */
    d[W] = -at.t / IZ * per; /* (109) */
    d[PATH] = v * per;
    d[TURN] = w * per;
    d[TIME] = per;
}

/* Gragg's midpoint rule: n steps of h/n, smoothed. */
static void midpoint(double *to, const struct slide *m, const double *d0,
                     double h, int n, int by_time)
{
    const double step = h / n;
    double before[VARS], y[VARS], d[VARS];
    for (int i = 0; i < VARS; ++i) {
        before[i] = m->y[i];
        y[i] = m->y[i] + step * d0[i];
    }
    for (int l = 1; l < n; ++l) {
        slopes(d, y, m->IZ, by_time);
        for (int i = 0; i < VARS; ++i) {
            const double next = before[i] + 2 * step * d[i];
            before[i] = y[i];
            y[i] = next;
        }
    }
    slopes(d, y, m->IZ, by_time);
    for (int i = 0; i < VARS; ++i)
        to[i] = (y[i] + before[i] + step * d[i]) / 2;
}

/* A step by Gragg, Bulirsch and Stoer: the estimate of its error. */
static double extrapolate(double *to, const struct slide *m, double h,
                          int by_time)
{
    double row[ROWS][VARS], d0[VARS], error = 0;
    slopes(d0, m->y, m->IZ, by_time);
    for (int j = 0; j < ROWS; ++j) {
        double now[VARS];
        midpoint(now, m, d0, h, 2 * (j + 1), by_time);
        error = 0;
        for (int i = 0; i < VARS; ++i) {
            for (int l = 0; l < j; ++l) {
                const double u = (j + 1.0) / (j - l), old = row[l][i];
                row[l][i] = now[i];
                now[i] += (now[i] - old) / (u * u - 1);
            }
            row[j][i] = now[i];
            const double off = j ? fabs(now[i] - row[j - 1][i]) : 0;
            error = off > error ? off : error;
        }
    }
    for (int i = 0; i < VARS; ++i)
        to[i] = row[ROWS - 1][i];
    return error;
}

/* The end of a slide, of a pure one or of a pure turn: steady braking. */
static void brake(struct slide *m, double end)
{
    double *const y = m->y, d[VARS];
    slopes(d, y, m->IZ, 1);
    const double left = end - y[TIME], speed = y[V] + y[W];
    const double stop = speed > 0 ? speed / -(d[V] + d[W]) : 0;
    const double h = stop <= left ? stop : left;
    y[PATH] += h * (y[V] + h * d[V] / 2);
    y[TURN] += h * (y[W] + h * d[W] / 2);
    y[TIME] = stop <= left ? y[TIME] + h : end;
    y[V] = stop <= left ? 0 : y[V] + h * d[V];
    y[W] = stop <= left ? 0 : y[W] + h * d[W];
}

/* Whether the rest of the slide is braked steadily. */
static int ends(struct slide *m)
{
    double *const y = m->y;
    if (y[V] < NONE * y[W])
        y[V] = 0;
    if (y[W] < NONE * y[V])
        y[W] = 0;
    return !(y[V] > 0 && y[W] > 0) || y[V] + y[W] < LEFT;
}

/* The step after one with this error. */
static double next_step(double h, double error, double tol)
{
    if (error > tol) {
        const double part = 0.8 / sqrt(sqrt(sqrt(sqrt(error / tol))));
        return h * (part > 0.3 ? part : 0.3);
    }
    return h * (error < 1e-3 * tol ? 1.8 : error < 0.1 * tol ? 1.2 : 1);
}

/* Slides until `end`, or until it stops. */
static void slide_on(struct slide *m, double end)
{
    double *const y = m->y, to[VARS];
    double h = m->IZ < 0.5 ? m->IZ : 0.5;
    int by_time = 0;
    for (int n = 0; n < STEPS && y[TIME] < end; ++n) {
        if (ends(m)) {
            brake(m, end);
            return;
        }
        const double error = extrapolate(to, m, h, by_time);
        const double next = next_step(h, error, m->tol);
        if (error > m->tol) {
            h = next;
        } else if (!by_time && to[TIME] > end) {
            by_time = 1;
            h = end - y[TIME];
        } else {
            const int last = by_time && h >= end - y[TIME];
            for (int i = 0; i < VARS; ++i)
                y[i] = to[i] > 0 ? to[i] : 0;
            y[TIME] = last ? end : y[TIME];
            h = next < 20 ? next : 20;
            if (by_time && h > end - y[TIME])
                h = end - y[TIME];
        }
    }
}

static double speed_of(const coin_body *b)
{
    return coin_priv_hypot(b->vx, b->vz);
}

double coin_priv_flat_drag(double IZ, double v, double w)
{
    return drag_of(IZ, v, w).f;
}

/* Moves the body by a path and a turn. */
static void move_by(coin_body *b, double v, double path, double turn)
{
    if (v > 0) {
        b->s.x += path * (b->vx / v);
        b->s.z += path * (b->vz / v);
    }
    b->s.psi += b->s.wZ < 0 ? -turn : turn;
}

double coin_priv_slide_flat(coin_body *b, double IZ, double mu, double t)
{
    const double v = speed_of(b), w = fabs(b->s.wZ), S = v + w;
    const double width = 1 - hole(IZ);
    struct slide m = {IZ, TOL, {v / S, w / S, 0, 0, 0}};
    if (mu == 0) {
        move_by(b, v, v * t, w * t);
        return t;
    }
    if (width >= THIN && width * TOL < ROUNDING)
        m.tol = ROUNDING / width; /* drag_of() divides by it */
    const double end = t * mu / S;
    slide_on(&m, end);
    move_by(b, v, m.y[PATH] * (S * S / mu), m.y[TURN] * (S * S / mu));
    const double slower = v > 0 ? m.y[V] * S / v : 0;
    b->vx *= slower;
    b->vz *= slower;
    b->s.wZ = b->s.wZ < 0 ? -m.y[W] * S : m.y[W] * S;
    return m.y[TIME] == end ? t : m.y[TIME] * S / mu;
}
