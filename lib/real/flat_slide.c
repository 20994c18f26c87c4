/* SPDX-License-Identifier: MIT */
/* A coin that lies flat and slides: friction of a uniform pressure over a disc,
 * or over the ring whose I_Z it has.
 *
 * In the time s, (113), speeds decay like exp(-s) up to the end,
 * where they vanish together as powers of the time left.  The law knows only
 * v/w: speeds are in units of v + w at the start, times in those over mu. */
#include "../motion/pinned.h"

#include "flat_slide.h"

/* The error that a step may make.  A tenth costs 26 % more, ten times 21 % less
 * (make tuning). */
#define TOL 1e-12

/* When so little of v + w is left, the rest is braked as if steadily.  A tenth
 * costs 2 % more (make tuning). */
#define LEFT 1e-11

/* A ring whose 1 - b^2/a^2 is less is computed as a hoop: (112) would divide
 * one small difference by another.  With a tenth or ten times of it the 99th
 * percentile of the errors of slides is 2e-11 or 1.5e-11 instead of 5e-13 (make
 * tuning). */
#define THIN 1e-5

/* A slide is pure if one speed is less than this part of the other: a tenth of
 * rounding.  A hundred times of it costs 7 % less (make tuning). */
#define NONE 1e-17

/* In a drag a speed is at least this: far below rounding, and
 * not 0, by which it is divided. */
#define TINY 1e-100

/* The places of the variables in a step of DOP853, among those that it reads:
 * it estimates their errors. */
enum {
    V = COIN_PRIV_UX,
    W = COIN_PRIV_WZ,
    PATH = COIN_PRIV_WX,
    TURN = COIN_PRIV_WY,
    TIME = COIN_PRIV_UH
};

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
    v = coin_priv_larger(v, TINY);
    w = coin_priv_larger(w, TINY);
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

/* The slopes by s. */
static void rates(double *d, const double *y, const coin_priv_law *l, int mode)
{
    const double per = y[V] + y[W]; /* (113) */
    const struct drag at = drag_of(l->IZ, y[V], y[W]);
    (void)mode;
    for (int i = 0; i < COIN_PRIV_WIDE; ++i)
        d[i] = 0;
    d[V] = -at.f * per;         /* (109) */
    d[W] = -at.t / l->IZ * per; /* (109) */
    d[PATH] = y[V] * per;
    d[TURN] = y[W] * per;
    d[TIME] = per;
}

/* The end of a slide, a pure slide or a pure turn: both speeds fall steadily,
 * and vanish together. */
static void brake(double *y, double IZ, double end)
{
    const struct drag at = drag_of(IZ, y[V], y[W]);
    const double left = end - y[TIME];
    const double stop = (y[V] + y[W]) / (at.f + at.t / IZ);
    const double h = coin_priv_lesser(stop, left), part = 1 - h / stop;
    y[PATH] += h * y[V] * (1 + part) / 2;
    y[TURN] += h * y[W] * (1 + part) / 2;
    y[TIME] = stop < left ? y[TIME] + h : end;
    y[V] *= part;
    y[W] *= part;
}

/* Slides until `end`, until it stops or until no trials are left.  The speeds
 * fall, so that a step which would reach `end` at the speeds of its start falls
 * short of it; the next step comes much closer. */
static void slide_on(coin_priv_moving *g, double end)
{
    coin_priv_dop853 *const w = &g->step;
    double *const y = w->y, h = 1;
    for (; g->tries > 0; --g->tries) {
        const double v = y[V], turn = y[W];
        if (y[TIME] >= end * (1 - 4 * DBL_EPSILON)) {
            y[TIME] = end;
            return;
        }
        if (v < NONE * turn || turn < NONE * v || v + turn < LEFT) {
            brake(y, g->law.IZ, end);
            return;
        }
        h = coin_priv_lesser(h, (end - y[TIME]) / (v + turn));
        rates(w->slope[0], y, &g->law, 0);
        const double error = coin_priv_try_step(w, h);
        const double ratio = TOL / coin_priv_larger(error, 1e-9 * TOL);
        for (int i = 0; error <= TOL && i < COIN_PRIV_READ; ++i)
            y[i] = coin_priv_larger(w->end[i], 0);
        h *= coin_priv_lesser(2, 0.2 + 0.7 * sqrt(sqrt(sqrt(ratio))));
    }
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

double coin_priv_slide_flat(coin_body *b, coin_priv_moving *g, double t)
{
    const double mu = g->law.mu_kinetic;
    const double v = sqrt(b->vx * b->vx + b->vz * b->vz);
    const double turn = fabs(b->s.wZ), S = v + turn;
    double *const y = g->step.y, end = t * mu / S;
    if (mu < TINY) {
        move_by(b, v, v * t, turn * t);
        return t;
    }
    const coin_priv_problem of = {&g->law, rates, 0, (double)INFINITY};
    g->step.of = of;
    for (int i = 0; i < COIN_PRIV_WIDE; ++i)
        y[i] = 0;
    y[COIN_PRIV_C] = 1; /* above the table, for the step */
    y[V] = v / S;
    y[W] = turn / S;
    slide_on(g, end);
    move_by(b, v, y[PATH] * (S * S / mu), y[TURN] * (S * S / mu));
    const double slower = v > 0 ? y[V] * S / v : 0;
    b->vx *= slower;
    b->vz *= slower;
    b->s.wZ = copysign(y[W] * S, b->s.wZ);
    return y[TIME] == end ? t : y[TIME] * S / mu;
}
