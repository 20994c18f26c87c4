/* SPDX-License-Identifier: MIT */
/* What a general solver is given, in natural units, M = a = g = 1: (14)-(20)
 * with one division and no tangent, as a careful user would write them; or the
 * same with the sines and cosines of lean and heading as variables, as the
 * library has them, (31). */
#ifndef RATES_H
#define RATES_H

#include "../workprec.h"

#include <math.h>

struct peer_body {
    double IX, IZ;
};

static inline struct peer_body peer_body_of(const scene *c)
{
    const double m = c->p.mass * c->p.radius * c->p.radius;
    const struct peer_body b = {c->p.inertia_X / m, c->p.inertia_Z / m};
    return b;
}

/* y = theta, phi, psi, x, z, wX, wY, wZ */
static inline void peer_rates(const struct peer_body *b, const double *y,
                              double *d)
{
    const double IX = b->IX, IZ = b->IZ, wX = y[5], wY = y[6], wZ = y[7];
    const double s = sin(y[0]), c = cos(y[0]), q = 1 / c, wYt = wY * s * q;
    const double sph = sin(y[1]), cph = cos(y[1]);
    d[0] = wX;
    d[1] = wY * q;
    d[2] = wZ + wYt;
    d[3] = wX * c * sph - wZ * cph;
    d[4] = wX * c * cph + wZ * sph;
    d[5] = (s - wY * ((IZ + 1) * wZ + IX * wYt)) * (1 / (IX + 1));
    d[6] = wX * (wYt + (IZ / IX) * wZ);
    d[7] = wX * wY * (1 / (IZ + 1));
}

enum { PEER_SIZE = 8, PEER_FREE_SIZE = 11 };

/* y = sin theta, cos theta, sin phi, cos phi, phi, psi, x, z, wX, wY, wZ */
static inline void peer_free_rates(const struct peer_body *b, const double *y,
                                   double *d)
{
    const double IX = b->IX, IZ = b->IZ, wX = y[8], wY = y[9], wZ = y[10];
    const double s = y[0], c = y[1], wYq = wY / c, wYt = wYq * s;
    d[0] = wX * c;
    d[1] = -wX * s;
    d[2] = wYq * y[3];
    d[3] = -wYq * y[2];
    d[4] = wYq;
    d[5] = wZ + wYt;
    d[6] = d[0] * y[2] - wZ * y[3];
    d[7] = d[0] * y[3] + wZ * y[2];
    d[8] = (s - wY * ((IZ + 1) * wZ + IX * wYt)) * (1 / (IX + 1));
    d[9] = wX * (wYt + (IZ / IX) * wZ);
    d[10] = wX * wY * (1 / (IZ + 1));
}

static inline void peer_free_start(const scene *c, double y[PEER_FREE_SIZE])
{
    double v[PEER_SIZE];
    scene_to_natural(c, v);
    y[0] = sin(v[0]);
    y[1] = cos(v[0]);
    y[2] = sin(v[1]);
    y[3] = cos(v[1]);
    for (int i = 1; i < PEER_SIZE; ++i)
        y[i + 3] = v[i];
}

static inline coin_state peer_free_state(const scene *c, const double *y)
{
    double v[PEER_SIZE] = {atan2(y[0], y[1])};
    for (int i = 1; i < PEER_SIZE; ++i)
        v[i] = y[i + 3];
    return scene_from_natural(c, v);
}

/* A scene's ladder of tolerances, absolute and relative alike. */
#define PEER_TOLERANCES 1e-2, 0.5623413251903491, 1e-15

#endif
