/* SPDX-License-Identifier: MIT */
/* What a general solver is given: (14)-(20) in natural units, M = a = g = 1,
 * with one division and no tangent, as a careful user would write them. */
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
    ++workprec_slopes;
}

/* A scene's ladder of tolerances, absolute and relative alike. */
#define PEER_TOLERANCES 1e-2, 0.5623413251903491, 1e-15

#endif
