/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "air.h"

coin_priv_attitude coin_priv_attitude_of(const coin_state *s)
{
    const coin_priv_variables y = coin_priv_variables_of(s);
    const coin_priv_attitude at = {{y.sth, y.cth}, {y.sph, y.cph}};
    return at;
}

coin_priv_variables coin_priv_attitude_variables(const coin_state *s,
                                                 const coin_priv_attitude *at)
{
    const coin_priv_variables y = {
        s->wX, s->wY, s->wZ, at->th.s, at->th.c, 0, 0, at->ph.s, at->ph.c,
    };
    return y;
}

void coin_priv_flight_of(coin_priv_flight *f, const coin_body *b,
                         const coin_priv_attitude *at, double IX, double IZ)
{
    const coin_state *const s = &b->s;
    const double k1 = IZ / IX, lX = s->wX, lY = s->wY, lZ = k1 * s->wZ;
    const double rate = sqrt(lX * lX + lY * lY + lZ * lZ); /* (98) */
    const coin_priv_flight made = {
        *at,
        rate > 0 ? lX / rate : 0,
        rate > 0 ? lY / rate : 0,
        rate > 0 ? lZ / rate : 1,
        rate,
        s->wZ * (1 - k1), /* (98) */
        b->y,
        b->vy,
    };
    *f = made;
}

/* A vector along the axes of the table. */
struct vector {
    double x, y, z;
};

/* The vector with these components along e_X, e_Y and e_Z. */
static struct vector vector_of(const coin_priv_attitude *at, double X, double Y,
                               double Z)
{
    const double h = at->th.s * Y + at->th.c * Z;
    const struct vector v = {
        X * at->ph.c + h * at->ph.s,
        at->th.c * Y - at->th.s * Z,
        h * at->ph.c - X * at->ph.s,
    };
    return v;
}

/* An angle without whole turns: 2 pi as four parts. */
static double without_turns(double x)
{
    const double turns = x * (0.25 / COIN_PRIV_HALF_PI) + COIN_PRIV_ROUNDER;
    const double n = 4 * (turns - COIN_PRIV_ROUNDER);
    return ((x - n * COIN_PRIV_P1) - n * COIN_PRIV_P2) - n * COIN_PRIV_P3;
}

/* Sine and cosine from a multiple of them. */
static coin_priv_sc unit(double s, double c)
{
    const double size = sqrt(s * s + c * c);
    const coin_priv_sc r = {s / size, c / size};
    return r;
}

/* Far below the rounding of a unit vector, and gives 0 a direction. */
#define ANY 1e-100

void coin_priv_fly(coin_body *b, coin_priv_attitude *at,
                   const coin_priv_flight *f, double t)
{
    coin_state *const s = &b->s;
    const coin_priv_sc half = coin_priv_sincos(f->rate * t / 2);
    const double S = 2 * half.s * half.c, C = 2 * half.s * half.s;
    const double kX = f->kX, kY = f->kY, kZ = f->kZ;
    const struct vector n =
        vector_of(&f->at, S * kY + C * kX * kZ, C * kY * kZ - S * kX,
                  1 - C * (kX * kX + kY * kY)); /* (99) */
    const struct vector X =
        vector_of(&f->at, 1 - C * (kY * kY + kZ * kZ), S * kZ + C * kX * kY,
                  C * kX * kZ - S * kY); /* (99) */
    /* Where the face is horizontal any heading is as good: d follows it. */
    const coin_priv_sc ph = unit(n.x, n.z + ANY);
    const coin_priv_sc th = unit(-n.y, ph.s * n.x + ph.c * n.z);
    const coin_priv_sc d = unit(th.s * (ph.s * X.x + ph.c * X.z) + th.c * X.y,
                                ph.c * X.x - ph.s * X.z);
    const double wX = s->wX, wY = s->wY;
    at->th = th;
    at->ph = ph;
    s->theta = coin_priv_lean_within(coin_priv_angle(th)); /* (100) */
    s->phi = coin_priv_angle(ph);                          /* (100) */
    s->psi = without_turns(s->psi + f->sigma * t + coin_priv_angle(d));
    s->wX = wX * d.c - wY * d.s; /* (100) */
    s->wY = wX * d.s + wY * d.c; /* (100) */
    s->x += b->vx * t;
    s->z += b->vz * t;
    b->y += t * (b->vy - t / 2);
    b->vy -= t;
}
