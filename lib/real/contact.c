/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "law.h"

/* A force that leaves the cone of friction by less than this part of its terms
 * counts as inside.  Where friction is 0, or exactly at its limit, the
 * difference is rounding.  From 1e-15 to 1e-13 no motion of make tuning depends
 * on it. */
#define SLACK 1e-14

/* The direction of a slip that begins is located to this part of the angle in
 * which it lies.  It is above the spacing of numbers, below which the search
 * would not end; up to 1e-12 no motion of make tuning depends on it. */
#define DIRECTION (4 * DBL_EPSILON)

/* How the coin would move without a force of the table on it, or, without a
 * slip, with the force that keeps its contact where it is. */
struct free_motion {
    double f;          /* the slope of the time: cos theta, or 1 */
    double turn, roll; /* the slopes of phi and psi */
    double X, Y, Z;    /* the slopes of wX, wY, wZ */
    double perY, perZ; /* what a friction of 1 along e_X adds to the last two */
};

/* The contact is held: the coin turns about the vertical through its contact,
 * or through its centre if it slips. */
COIN_PRIV_INLINE struct free_motion held_motion(const double *y,
                                                const coin_priv_law *l,
                                                int slips)
{
    const double wX = y[COIN_PRIV_WX], s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
    const double turn = c * y[COIN_PRIV_WY] - s * y[COIN_PRIV_WZ];
    const double IX = l->IX, K = l->K[slips];
    const double D = IX * (c * c) + K * (s * s);
    const double torque =
        l->spin + l->angular * (IX * (c * c) + l->IZ * (s * s)); /* (72) */
    const double fade =
        -turn * (torque + 2 * s * c * wX * (K - IX)) / D; /* (72), (85) */
    const double lift = (K - IX) * c * (turn * turn);
    const struct free_motion r = {
        1,
        turn,
        0,
        (s * ((slips ? 0 : 1) + lift) - l->angular * IX * wX) *
            l->perJ[slips], /* (72) */
        c * fade - s * wX * turn,
        -s * fade - c * wX * turn,
        -s * c / D, /* (85) */
        s * s / D,  /* (85) */
    };
    return r;
}

COIN_PRIV_INLINE struct free_motion rolling_motion(const double *y,
                                                   const coin_priv_law *l,
                                                   int slips, int lossy)
{
    const double wX = y[COIN_PRIV_WX], wY = y[COIN_PRIV_WY];
    const double s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
    const double cwZ = c * y[COIN_PRIV_WZ], swY = s * wY;
    const double k1 = l->IZ * l->perJ[1], K = l->K[slips];
    const double fall = slips ? 0 : s * c;
    struct free_motion r = {
        c,
        wY,
        cwZ + swY,
        (fall - wY * (K * cwZ + l->IX * swY)) * l->perJ[slips], /* (78) */
        wX * (k1 * cwZ + swY),                                  /* (78) */
        slips ? 0 : c * wX * wY * l->perK[0],
        0,
        l->perK[1],
    };
    if (lossy) {
        const coin_priv_slowing d = coin_priv_slowing_of(l, y, slips);
        r.X += d.wX;
        r.Y += d.wY;
        r.Z += d.wZ;
    }
    return r;
}

/* The slopes of a coin under a force, times `by`. */
COIN_PRIV_INLINE void slopes_of(double *d, const double *y,
                                const struct free_motion *o,
                                const coin_priv_push *F, int slips, double by)
{
    const double wX = y[COIN_PRIV_WX], s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
    const double sph = y[COIN_PRIV_SPH], cph = y[COIN_PRIV_CPH];
    const double vX = y[COIN_PRIV_UX] - y[COIN_PRIV_WZ];
    const double vh = y[COIN_PRIV_UH] + wX * c;
    const double swX2 = o->f * s * (wX * wX);
    d[COIN_PRIV_WX] = by * o->X;
    d[COIN_PRIV_WY] = by * o->Y;
    d[COIN_PRIV_WZ] = by * o->Z;
    d[COIN_PRIV_S] = by * (o->f * c * wX);
    d[COIN_PRIV_C] = by * (-o->f * s * wX);
    d[COIN_PRIV_UX] = slips ? by * (F->X - o->turn * vh + o->Z) : 0;
    d[COIN_PRIV_UH] = slips ? by * (F->h + o->turn * vX + swX2 - c * o->X) : 0;
    d[COIN_PRIV_SPH] = by * (o->turn * cph);
    d[COIN_PRIV_CPH] = by * (-o->turn * sph);
    d[COIN_PRIV_ADDS_PHI] = by * o->turn;
    d[COIN_PRIV_ADDS_PSI] = by * o->roll;
    d[COIN_PRIV_ADDS_X] = by * (o->f * (vX * cph + vh * sph));
    d[COIN_PRIV_ADDS_Z] = by * (o->f * (vh * cph - vX * sph));
    d[COIN_PRIV_ADDS_T] = by * o->f;
    d[COIN_PRIV_SIZE] = 0;
}

/* Slopes and force of one mode.  *d is what a step needs, times `by`. */
COIN_PRIV_INLINE coin_priv_push contact(double *d, const double *y,
                                        const coin_priv_law *l, int mode,
                                        coin_priv_direction n, double by)
{
    const double wX = y[COIN_PRIV_WX], s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
    const int slips = (mode & COIN_PRIV_SLIPS) != 0;
    const int lossy = l->lossy && !(mode & COIN_PRIV_IDLE);
    struct free_motion o = mode & COIN_PRIV_HELD
                               ? held_motion(y, l, slips)
                               : rolling_motion(y, l, slips, lossy);
    const double vX = y[COIN_PRIV_UX] - y[COIN_PRIV_WZ]; /* (77) */
    const double vh = y[COIN_PRIV_UH] + wX * c;          /* (77) */
    const double swX2 = o.f * s * (wX * wX);
    coin_priv_push F;
    if (slips) {
        const double mu = l->mu_kinetic;
        F.N = (o.f * (1 - c * (wX * wX)) - s * o.X) /
              (1 + s * (s + c * (mu * n.h)) * l->perJ[1]); /* (80) */
        F.X = -mu * F.N * n.X;
        F.h = -mu * F.N * n.h;
        o.X += (F.N * s - F.h * c) * l->perJ[1]; /* (81) */
        o.Y += o.perY * F.X;                     /* (81) */
        o.Z += o.perZ * F.X;                     /* (81) */
    } else {
        F.N = o.f * (1 - c * (wX * wX)) - s * o.X;
        F.X = o.turn * vh - o.Z;            /* (82) */
        F.h = c * o.X - swX2 - o.turn * vX; /* (82) */
    }
    if (d)
        slopes_of(d, y, &o, &F, slips, by);
    return F;
}

/* The same of any mode, in the code once. */
COIN_PRIV_NOINLINE coin_priv_push any_contact(double *d, const double *y,
                                              const coin_priv_law *l, int mode,
                                              coin_priv_direction n, double by)
{
    return contact(d, y, l, mode, n, by);
}

coin_priv_push coin_priv_slopes(double *d, const double *y,
                                const coin_priv_law *l, int mode,
                                coin_priv_direction n)
{
    return any_contact(d, y, l, mode, n, 1);
}

/* The direction of a slip with these variables, and its speed. */
static double direction(coin_priv_direction *n, const double *y)
{
    const double uX = y[COIN_PRIV_UX], uh = y[COIN_PRIV_UH];
    const double u = sqrt(uX * uX + uh * uh);
    n->X = uX / u;
    n->h = uh / u;
    return u;
}

void coin_priv_rates(double *d, const double *y, const coin_priv_law *l,
                     int mode)
{
    coin_priv_direction n = {0, 0};
    if (mode == 0) { /* most often: without the branches of the rest */
        (void)contact(d, y, l, 0, n, 1);
        return;
    }
    const double u = mode & COIN_PRIV_SLIPS ? direction(&n, y) : 0;
    const double by = mode & COIN_PRIV_SLIPS ? u / (u + 1) : 1; /* (83) */
    (void)any_contact(d, y, l, mode, n, by);
}

coin_priv_push coin_priv_push_of(const double *y, const coin_priv_law *l,
                                 int mode)
{
    coin_priv_direction n = {0, 0};
    if (mode & COIN_PRIV_SLIPS)
        (void)direction(&n, y);
    return coin_priv_slopes(0, y, l, mode, n);
}

double coin_priv_weight(const double *y, const coin_priv_law *l)
{
    const double wX = y[COIN_PRIV_WX], wY = y[COIN_PRIV_WY];
    const double s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
    const double up = l->IZ / l->IX * c * y[COIN_PRIV_WZ] + s * wY;
    return c * (1 - c * (wX * wX)) + s * (wY * up); /* (96) */
}

int coin_priv_leaves(const double *y, const coin_priv_law *l)
{
    const coin_priv_direction no_friction = {0, 0};
    const double wX = y[COIN_PRIV_WX], wY = y[COIN_PRIV_WY];
    const double s = y[COIN_PRIV_S], c = y[COIN_PRIV_C], k1 = l->IZ / l->IX;
    const double weight = coin_priv_weight(y, l);
    double d[COIN_PRIV_WIDE];
    if (weight > 0)
        return 0;
    (void)coin_priv_slopes(d, y, l, COIN_PRIV_SLIPS | COIN_PRIV_IDLE,
                           no_friction);
    const double ds = d[COIN_PRIV_S], dc = d[COIN_PRIV_C];
    const double swY = ds * wY + s * d[COIN_PRIV_WY];
    const double cwZ = dc * y[COIN_PRIV_WZ] + c * d[COIN_PRIV_WZ];
    const double up = k1 * c * y[COIN_PRIV_WZ] + s * wY;
    const double slope = dc - 2 * c * wX * (dc * wX + c * d[COIN_PRIV_WX]) +
                         swY * up + s * wY * (k1 * cwZ + swY);
    return !(-weight * d[COIN_PRIV_ADDS_T] < slope * coin_priv_blind(y));
}

double coin_priv_contact_margin(const double *y, const coin_priv_law *l,
                                int mode)
{
    const coin_priv_direction no_friction = {0, 0};
    const double wX = y[COIN_PRIV_WX], wY = fabs(y[COIN_PRIV_WY]);
    const double f = mode & COIN_PRIV_HELD ? 1 : y[COIN_PRIV_C];
    const double size = f * (1 + wX * wX) + wY * (wY + fabs(y[COIN_PRIV_WZ]));
    const double mu = l->mu_static;
    if (l->damping > 0)
        return coin_priv_weight(y, l) / size;
    const coin_priv_push F = coin_priv_slopes(0, y, l, mode, no_friction);
    if (mode & COIN_PRIV_SLIPS)
        return F.N / size;
    const double friction = sqrt(F.X * F.X + F.h * F.h);
    const double over = mu > 1 ? F.N - friction / mu : mu * F.N - friction;
    return over / size + SLACK;
}

double coin_priv_root(coin_priv_function *f, const void *of, coin_priv_place a,
                      coin_priv_place b, double width)
{
    int before = 0;
    /* Each fourth time the interval is halved, whatever the function does. */
    for (int i = 0; b.x - a.x > width; ++i) {
        double x = a.x + (b.x - a.x) * (a.at / (a.at - b.at));
        x = i % 4 == 3 ? (a.x + b.x) / 2 : x;
        x = x > a.x + width / 2 ? x : a.x + width / 2;
        x = coin_priv_lesser(x, b.x - width / 2);
        const double at = f(of, x);
        const int side = at < 0 ? -1 : 1;
        const coin_priv_place c = {x, at};
        if (side < 0) {
            a.at *= before == side ? 0.5 : 1; /* Illinois */
            b = c;
        } else {
            b.at *= before == side ? 0.5 : 1;
            a = c;
        }
        before = side;
    }
    return b.x;
}

/* The directions between two in which a slip may begin. */
struct sector {
    const double *y;
    const coin_priv_law *l;
    int mode;
    coin_priv_direction from, to;
    double sign; /* of the cross product of the first one */
};

static coin_priv_direction direction_at(const struct sector *f, double part)
{
    const double X = (1 - part) * f->from.X + part * f->to.X;
    const double h = (1 - part) * f->from.h + part * f->to.h;
    const double size = sqrt(X * X + h * h);
    const coin_priv_direction n = {X / size, h / size};
    return n;
}

/* The cross product of the slope of the slip and n, for a slip that begins in
 * the direction n, a part of the way through the sector.  It is 0 if the slip
 * keeps that direction. */
static double turn_away(const void *sector, double part)
{
    const struct sector *const f = (const struct sector *)sector;
    double d[COIN_PRIV_WIDE];
    const coin_priv_direction n = direction_at(f, part);
    (void)coin_priv_slopes(d, f->y, f->l, f->mode, n);
    return f->sign * (d[COIN_PRIV_UX] * n.h - d[COIN_PRIV_UH] * n.X); /* (84) */
}

/* The root of (84) lies between the direction against the static force and that
 * of the slip without friction.  Where these agree to rounding, the one with
 * the smaller cross product is taken. */
coin_priv_direction coin_priv_onset(const double *y, const coin_priv_law *l,
                                    int mode, coin_priv_push F)
{
    const coin_priv_direction no_friction = {0, 0};
    double d[COIN_PRIV_WIDE];
    mode |= COIN_PRIV_SLIPS;
    (void)coin_priv_slopes(d, y, l, mode, no_friction);
    const double dX = d[COIN_PRIV_UX], dh = d[COIN_PRIV_UH];
    const double a = sqrt(F.X * F.X + F.h * F.h), b = sqrt(dX * dX + dh * dh);
    struct sector f = {
        y, l, mode, {-F.X / a, -F.h / a}, {dX / b, dh / b}, 1,
    };
    coin_priv_place first = {0, turn_away(&f, 0)}, last = {1, turn_away(&f, 1)};
    if ((first.at < 0) == (last.at < 0))
        return fabs(first.at) < fabs(last.at) ? f.from : f.to;
    f.sign = first.at < 0 ? -1 : 1;
    first.at *= f.sign;
    last.at *= f.sign;
    return direction_at(&f,
                        coin_priv_root(turn_away, &f, first, last, DIRECTION));
}
