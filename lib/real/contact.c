/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/kind.h"
#include "../motion/root.h"

#define LANES COIN_PRIV_LANES
#include "../motion/vector.t.h"

#include "contact.h"
#include "dop853.h"

/* A force that leaves the cone of friction by less than this part of its terms
 * counts as inside.  Where friction is 0, or exactly at its limit, the
 * difference is rounding.  Measured: SLACK in tables.md. */
#define SLACK 1e-14

/* The direction of a slip that begins is located to this part of the angle in
 * which it lies.  It is above the spacing of numbers, below which the search
 * would not end.  Measured: DIRECTION in tables.md. */
#define DIRECTION (4 * DBL_EPSILON)

coin_priv_push coin_priv_plain_contact(double *d, const double *y,
                                       const coin_priv_law *l, int mode,
                                       coin_priv_direction n, double by)
{
    return contact(d, y, l, mode, n, by, 1);
}

coin_priv_push coin_priv_slopes(double *d, const double *y,
                                const coin_priv_law *l, int mode,
                                coin_priv_direction n)
{
    return l->contact(d, y, l, mode, n, 1);
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

/* The slopes: 1. */
COIN_PRIV_NOINLINE int sound_rates(double *d, const double *y,
                                   const coin_priv_law *l, int mode)
{
    coin_priv_direction n = {0, 0};
    if (mode == 0 && l->plain) { /* most often: without further branches */
        (void)contact(d, y, l, 0, n, 1, 1);
        return 1;
    }
    const double u = mode & COIN_PRIV_SLIPS ? direction(&n, y) : 0;
    const double by = mode & COIN_PRIV_SLIPS ? u / (u + 1) : 1; /* (83) */
    if (mode == COIN_PRIV_SLIPS && l->plain) /* most of the steps of a toss */
        (void)contact(d, y, l, COIN_PRIV_SLIPS, n, by, 1);
    else
        (void)l->contact(d, y, l, mode, n, by);
    return 1;
}

double coin_priv_by_t(double *d)
{
    const double per = 1 / d[COIN_PRIV_ADDS_T];
#pragma GCC unroll 16
    for (int i = 0; i < COIN_PRIV_SIZE; i += LANES)
        store(d + i, per * load(d + i));
    return per;
}

COIN_PRIV_NOINLINE int rates_by_t(double *d, const double *y,
                                  const coin_priv_problem *of)
{
    (void)sound_rates(d, y, of->law, of->mode);
    (void)coin_priv_by_t(d);
    return 1;
}

int coin_priv_rates(double *d, const double *y, const coin_priv_problem *of)
{
    const double sum = fabs(y[COIN_PRIV_WX]) + fabs(y[COIN_PRIV_WY]) +
                       fabs(y[COIN_PRIV_WZ]) + fabs(y[COIN_PRIV_UX]) +
                       fabs(y[COIN_PRIV_UH]);
    const int above = y[COIN_PRIV_C] > 0 || of->mode & COIN_PRIV_HELD;
    if (!(above && isless(sum, of->limit)))
        return 0;
    if (!d)
        return 1;
    return of->by_t ? rates_by_t(d, y, of)
                    : sound_rates(d, y, of->law, of->mode);
}

coin_priv_push coin_priv_push_of(const double *y, const coin_priv_law *l,
                                 int mode)
{
    coin_priv_direction n = {0, 0};
    if (mode & COIN_PRIV_SLIPS)
        (void)direction(&n, y);
    return coin_priv_slopes(0, y, l, mode, n);
}

/* Minus the free acceleration of the gap under the contact, times cos theta.
 * Above 0 the table presses, or the coin falls back on it. */
static double weight_of(const double *y, const coin_priv_law *l)
{
    const double wX = y[COIN_PRIV_WX], wY = y[COIN_PRIV_WY];
    const double s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
    const double up = l->IZ / l->IX * c * y[COIN_PRIV_WZ] + s * wY;
    const coin_priv_lever r = coin_priv_lever_of(s, c, l->eta);
    return c * (1 - r.Y * (wX * wX)) +
           r.P * (wY * up + l->angular * c * wX); /* (96), (123) */
}

int coin_priv_leaves(const double *y, const coin_priv_law *l)
{
    const coin_priv_direction no_friction = {0, 0};
    const double wX = y[COIN_PRIV_WX], wY = y[COIN_PRIV_WY];
    const double s = y[COIN_PRIV_S], c = y[COIN_PRIV_C], k1 = l->IZ / l->IX;
    const double weight = weight_of(y, l);
    double d[COIN_PRIV_WIDE];
    if (weight > 0)
        return 0;
    coin_priv_law without = *l;
    without.lossy = 0;
    (void)coin_priv_slopes(d, y, &without, COIN_PRIV_SLIPS, no_friction);
    for (int i = COIN_PRIV_WX; i <= COIN_PRIV_WZ; ++i)
        d[i] -= l->angular * d[COIN_PRIV_ADDS_T] * y[i];
    const double ds = d[COIN_PRIV_S], dc = d[COIN_PRIV_C];
    const coin_priv_lever r = coin_priv_lever_of(s, c, l->eta);
    const coin_priv_lever dr = coin_priv_lever_of(ds, dc, l->eta);
    const double swY = ds * wY + s * d[COIN_PRIV_WY];
    const double PwY = dr.P * wY + r.P * d[COIN_PRIV_WY];
    const double cwZ = dc * y[COIN_PRIV_WZ] + c * d[COIN_PRIV_WZ];
    const double up = k1 * c * y[COIN_PRIV_WZ] + s * wY;
    const double damped = dc * wX + c * d[COIN_PRIV_WX];
    const double slope =
        dc - wX * ((dc * r.Y + c * dr.Y) * wX + 2 * c * r.Y * d[COIN_PRIV_WX]) +
        PwY * up + r.P * wY * (k1 * cwZ + swY) +
        l->angular * (dr.P * c * wX + r.P * damped);
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
    const coin_priv_push F = coin_priv_slopes(0, y, l, mode, no_friction);
    if (mode & COIN_PRIV_SLIPS)
        return F.N / size;
    const double friction = sqrt(F.X * F.X + F.h * F.h);
    const double over = mu > 1 ? F.N - friction / mu : mu * F.N - friction;
    return over / size + SLACK;
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
    if ((first.at < 0) == (last.at < 0)) /* they are one, to rounding */
        return f.to;
    f.sign = first.at < 0 ? -1 : 1;
    first.at *= f.sign;
    last.at *= f.sign;
    return direction_at(&f,
                        coin_priv_root(turn_away, &f, first, last, DIRECTION));
}
