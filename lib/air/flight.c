/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "air.h"
#include "space.h"

coin_priv_attitude coin_priv_attitude_of(const coin_state *s)
{
    const coin_priv_attitude at = {
        coin_priv_sincos(s->theta),
        coin_priv_sincos(s->phi),
    };
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
    const coin_priv_variables v = coin_priv_attitude_variables(s, at);
    const double k1 = IZ / IX;
    double R[9];
    coin_priv_axes(&v, R);
    for (int i = 0; i < 3; ++i) {
        f->X[i] = R[i];
        f->n[i] = R[6 + i];
        f->k[i] = s->wX * R[i] + s->wY * R[3 + i] + k1 * s->wZ * R[6 + i];
    }
    f->rate = sqrt(coin_priv_dot(f->k, f->k)); /* (98) */
    for (int i = 0; i < 3; ++i)
        f->k[i] = f->rate > 0 ? f->k[i] / f->rate : i == 1;
    f->sigma = s->wZ * (1 - k1); /* (98) */
    f->x = s->x;
    f->y = b->y;
    f->z = s->z;
    f->vx = b->vx;
    f->vy = b->vy;
    f->vz = b->vz;
}

/* A vector of the coin after half the turn `half` of the precession. */
static void turn_by(double to[3], const double v[3], const double k[3],
                    coin_priv_sc half)
{
    const double S = 2 * half.s * half.c, C = 2 * half.s * half.s;
    const double along = coin_priv_dot(k, v);
    double across[3];
    coin_priv_cross(across, k, v);
    for (int i = 0; i < 3; ++i)
        to[i] = v[i] + S * across[i] + C * (k[i] * along - v[i]); /* (99) */
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
    double X[3], n[3];
    turn_by(X, f->X, f->k, half);
    turn_by(n, f->n, f->k, half);
    /* Where the face is horizontal any heading is as good: d follows it. */
    const double level = sqrt(n[0] * n[0] + n[2] * n[2]);
    const coin_priv_sc ph = unit(n[0], n[2] + ANY);
    const coin_priv_sc th = unit(-n[1], level);
    const double along = ph.s * X[0] + ph.c * X[2];
    const coin_priv_sc d =
        unit(th.s * along + th.c * X[1], ph.c * X[0] - ph.s * X[2]);
    const double wX = s->wX, wY = s->wY;
    at->th = th;
    at->ph = ph;
    s->theta = coin_priv_lean_within(coin_priv_angle(th)); /* (100) */
    s->phi = coin_priv_angle(ph);                          /* (100) */
    s->psi = without_turns(s->psi + f->sigma * t + coin_priv_angle(d));
    s->wX = wX * d.c - wY * d.s; /* (100) */
    s->wY = wX * d.s + wY * d.c; /* (100) */
    s->x = f->x + f->vx * t;
    s->z = f->z + f->vz * t;
    b->y = f->y + t * (f->vy - t / 2);
    b->vy = f->vy - t;
}
