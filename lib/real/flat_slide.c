/* SPDX-License-Identifier: MIT */
/* A coin that lies flat and slides: friction of a uniform pressure over a disc,
 * or over the ring whose I_Z it has, and a constant pull along the table.
 *
 * The speeds u = (vx, vz, w) have the norm of the energy: |u|^2 = vx^2 + vz^2 +
 * I_Z w^2.  In it two slides only come closer to each other, (113): an error of
 * a step does not grow. */
#include "../motion/pinned.h"

#include "coin_body.h"
#include "flat_slide.h"

/* The estimate of a step's error may be up to PART times tol.  Measured: PART
 * in tables.md.
 */
#define PART 0.03

/* A step is at most so much of |u|/|u'|, before which no slide ends, (130).
 * Measured: REACH in tables.md. */
#define REACH 0.6

/* A ring whose 1 - b^2/a^2 is less is computed as a hoop: (112) would divide
 * one small difference by another.  Measured: THIN in tables.md. */
#define THIN 1e-5

/* In a drag a speed is at least TINY: far below rounding, and not 0, by which
 * it is divided.  A coin that begins to slide has the speed SEED. */
#define TINY 1e-100
#define SEED 1e-50

/* A time in which every slide that goes on leaves the range of positions. */
#define FOREVER 1e100

/* What f and t lose to rounding, next to v = w most, times the loss of (112).
 * Measured: ROUNDED in tables.md. */
#define ROUNDED (16 * DBL_EPSILON)

/* The variables of a step: what the slopes read, and what it adds. */
enum { VX, VZ, W, X = COIN_PRIV_READ, Z, TURN };

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

/* The factor by which (112) makes rounding larger. */
static double loss_of(double IZ)
{
    const double B = hole(IZ);
    return B > 1 - THIN ? 1 : 1 / (1 - B);
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

/* The slopes by t. */
static int slide_slopes(double *d, const double *y, const coin_priv_problem *of)
{
    const coin_priv_law *const l = of->law;
    if (!d)
        return 1;
    const double v =
        coin_priv_larger(sqrt(y[VX] * y[VX] + y[VZ] * y[VZ]), TINY);
    const double w = coin_priv_larger(fabs(y[W]), TINY);
    const struct drag at = drag_of(l->IZ, v, w);
    const double mu = l->mu_kinetic;
    for (int i = 0; i < COIN_PRIV_WIDE; ++i)
        d[i] = 0;
    d[VX] = l->pull[0] - mu * at.f * (y[VX] / v); /* (132) */
    d[VZ] = l->pull[1] - mu * at.f * (y[VZ] / v); /* (132) */
    d[W] = -mu * at.t / l->IZ * (y[W] / w);       /* (109) */
    d[X] = y[VX];
    d[Z] = y[VZ];
    d[TURN] = y[W];
    return 1;
}

/* The product of two speeds, or slopes, whose norm is that of the energy. */
static double product(const double *a, const double *b, double IZ)
{
    return a[VX] * b[VX] + a[VZ] * b[VZ] + IZ * (a[W] * b[W]);
}

/* Sets w->end after a time h in which the speeds become `part` of what they
 * are, steadily. */
static void go_straight(coin_priv_dop853 *w, double h, double part)
{
    for (int i = 0; i < 3; ++i) {
        w->end[VX + i] = w->y[VX + i] * part;
        w->end[X + i] = h * w->y[VX + i] * (1 + part) / 2;
    }
}

/* The largest estimate with which a step of h is accepted: what tol allows, and
 * what rounding may cause. */
static double allowed(const coin_priv_moving *g, double size, double h)
{
    const coin_priv_law *const l = &g->law;
    return PART * g->tol +
           ROUNDED * (size + h * l->mu_kinetic * loss_of(l->IZ));
}

/* A trial of a step of at most `left`: sets w->end, and returns the time moved,
 * or 0.  *h: the length of this trial, then of the next one. */
static double try_step(coin_priv_moving *g, double *h, double left)
{
    coin_priv_dop853 *const w = &g->step;
    const double *const u = w->y, *const a = w->slope[0], IZ = g->law.IZ;
    (void)slide_slopes(w->slope[0], u, &w->of);
    const double uu = product(u, u, IZ), aa = product(a, a, IZ);
    const double fade = -product(u, a, IZ) / uu;
    const double stop = fade > 1 / FOREVER ? 1 / fade : 2 * FOREVER;
    const double time = coin_priv_lesser(left, stop);
    const double aside[] = {a[VX] + fade * u[VX], a[VZ] + fade * u[VZ],
                            a[W] + fade * u[W]};
    const double off = sqrt(product(aside, aside, IZ)); /* (131) */
    if (off * time <= PART * g->tol || off <= 4 * DBL_EPSILON * sqrt(aa)) {
        go_straight(w, time, time < stop ? 1 - time * fade : 0);
        return time;
    }
    const double longest = REACH * sqrt(uu / aa); /* (130) */
    const double step = coin_priv_lesser(coin_priv_lesser(*h, left), longest);
    const double error = coin_priv_try_step(w, step);
    const double most = allowed(g, sqrt(uu), step);
    *h = step * coin_priv_next_length(error, most);
    return error <= most ? step : 0;
}

/* Sets y to the speeds of a coin that lies.  A coin at rest begins to slide
 * along the pull. */
static void begin(double *y, const coin_priv_coin *c, const coin_priv_law *l)
{
    const double size = coin_priv_pull(l);
    const int rests = c->vx == 0 && c->vz == 0 && c->wZ == 0;
    for (int i = 0; i < COIN_PRIV_WIDE; ++i)
        y[i] = 0;
    y[VX] = rests ? SEED * (l->pull[0] / size) : c->vx;
    y[VZ] = rests ? SEED * (l->pull[1] / size) : c->vz;
    y[W] = c->wZ;
}

/* Moves the coin to the end of a step. */
static void take(coin_priv_coin *c, const double *end)
{
    c->vx = end[VX];
    c->vz = end[VZ];
    c->wZ = end[W];
    coin_priv_add(&c->x, end[X]);
    coin_priv_add(&c->z, end[Z]);
    coin_priv_add(&c->psi, end[TURN]);
}

/* A step out of range is taken if it is the first: the caller refuses it. */
double coin_priv_slide_flat(coin_priv_coin *c, coin_priv_moving *g, double t)
{
    double *const y = g->step.y, *const end = g->step.end;
    double left = coin_priv_lesser(t, FOREVER), moved = 0, h = left;
    g->step.of.rates = slide_slopes;
    g->step.of.law = &g->law;
    begin(y, c, &g->law);
    for (; left > 0 && g->tries > 0; --g->tries) {
        const double step = try_step(g, &h, left);
        if (!(step > 0))
            continue;
        coin_priv_coin to = *c;
        take(&to, end);
        const int holds = coin_priv_coin_in_range(&to);
        if (holds || !(moved > 0)) {
            *c = to;
            moved += step;
            left -= step;
        }
        if (!holds || !(product(end, end, 1) > 0))
            break;
        for (int i = VX; i <= W; ++i)
            y[i] = end[i];
    }
    return left > 0 ? moved : t;
}

double coin_priv_face_grip(const coin_priv_law *l, double U2, double A2,
                           double P, double w)
{
    const double S = sqrt(U2 + A2 / 4);
    if (l->mu_static > DBL_MAX || !(S > 0))
        return 1;
    const double f = drag_of(l->IZ, S, fabs(w)).f;
    return coin_priv_lesser(1, l->mu_kinetic * P * f / (2 * S)); /* (133) */
}

double coin_priv_flat_drag(double IZ, double v, double w)
{
    return drag_of(IZ, v, w).f;
}
