/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "air.h"

void coin_priv_flight_of(coin_priv_flight *f, const coin_priv_coin *c,
                         double IX, double IZ, double angular)
{
    const double k1 = IZ / IX, lX = c->wX, lY = c->wY, lZ = k1 * c->wZ;
    const double rate = sqrt(lX * lX + lY * lY + lZ * lZ); /* (98) */
    f->from = *c;
    f->kX = rate > 0 ? lX / rate : 0;
    f->kY = rate > 0 ? lY / rate : 0;
    f->kZ = rate > 0 ? lZ / rate : 1;
    f->rate = rate;
    f->sigma = c->wZ * (1 - k1); /* (98) */
    f->angular = angular;
    f->pull[0] = f->pull[1] = 0;
}

/* Up to x = 1/2 the power series of `part`, whose further terms are below
 * rounding; then by doubling x. */
coin_priv_decay coin_priv_decay_of(double x)
{
    double part = 1, left = 1;
    int doublings = 0;
    for (; x > 0.5; x /= 2)
        ++doublings;
    for (int n = x > 0 ? 16 : 0; n > 1; --n)
        part = 1 - x / n * part;
    left -= x * part;
    for (; doublings > 0; --doublings) {
        part *= (1 + left) / 2;
        left *= left;
    }
    const coin_priv_decay r = {left, part};
    return r;
}

/* A vector along the axes of the table. */
struct vector {
    double x, y, z;
};

/* The vector with these components along e_X, e_Y and e_Z. */
static struct vector vector_of(const coin_priv_coin *at, double X, double Y,
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

void coin_priv_fly(coin_priv_coin *c, const coin_priv_flight *f, double t)
{
    const coin_priv_coin *const at = &f->from;
    const coin_priv_decay slows = coin_priv_decay_of(f->angular * t);
    const double turned = slows.part * t; /* (116) */
    const coin_priv_sc half = coin_priv_sincos(f->rate * turned / 2);
    const double S = 2 * half.s * half.c, C = 2 * half.s * half.s;
    const double kX = f->kX, kY = f->kY, kZ = f->kZ;
    const struct vector n =
        vector_of(at, S * kY + C * kX * kZ, C * kY * kZ - S * kX,
                  1 - C * (kX * kX + kY * kY)); /* (99) */
    const struct vector X =
        vector_of(at, 1 - C * (kY * kY + kZ * kZ), S * kZ + C * kX * kY,
                  C * kX * kZ - S * kY); /* (99) */
    /* Where the face is horizontal any heading is as good: d follows it. */
    const coin_priv_sc ph = unit(n.x, n.z + ANY);
    const coin_priv_sc th = unit(-n.y, ph.s * n.x + ph.c * n.z);
    const coin_priv_sc d = unit(th.s * (ph.s * X.x + ph.c * X.z) + th.c * X.y,
                                ph.c * X.x - ph.s * X.z);
    const double wX = slows.left * at->wX, wY = slows.left * at->wY; /* (116) */
    const double px = f->pull[0], pz = f->pull[1];
    *c = *at;
    c->th = th;
    c->ph = ph;
    c->phi.sum = coin_priv_angle(ph); /* (100) */
    c->psi.sum = without_turns(at->psi.sum + f->sigma * turned +
                               coin_priv_angle(d)); /* (100) */
    c->phi.low = c->psi.low = 0;
    c->wX = wX * d.c - wY * d.s;                     /* (100) */
    c->wY = wX * d.s + wY * d.c;                     /* (100) */
    c->wZ = slows.left * at->wZ;                     /* (116) */
    coin_priv_add(&c->x, t * (at->vx + px * t / 2)); /* (125) */
    coin_priv_add(&c->z, t * (at->vz + pz * t / 2)); /* (125) */
    c->vx += px * t;
    c->vz += pz * t;
    c->y += t * (at->vy - t / 2);
    c->vy -= t;
}
