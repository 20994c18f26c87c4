/* SPDX-License-Identifier: MIT */
#include "sliding.h"

#include <math.h>

void sliding_start(double y[SLIDING], const coin_body *d)
{
    const coin_state *s = &d->s;
    const double sph = sin(s->phi), cph = cos(s->phi);
    const double at[SLIDING] = {
        s->wX,
        s->wY,
        s->wZ,
        d->vx * cph - d->vz * sph,
        d->vx * sph + d->vz * cph,
        sin(s->theta),
        cos(s->theta),
        sph,
        cph,
        s->phi,
        s->psi,
        s->x,
        s->z,
    };
    for (int i = 0; i < SLIDING; ++i)
        y[i] = at[i];
}

coin_state sliding_state(const double y[SLIDING])
{
    const coin_state s = {
        .theta = atan2(y[STH], y[CTH]),
        .phi = y[PHI],
        .psi = y[PSI],
        .x = y[AT_X],
        .z = y[AT_Z],
        .wX = y[WX],
        .wY = y[WY],
        .wZ = y[WZ],
    };
    return s;
}

/* f(u/delta)/u. */
static inline double grip(const struct sliding *of, double uX, double uh)
{
    const double u2 = uX * uX + uh * uh, delta = of->delta;
    const double d2 = delta * delta, sum = u2 + d2;
    if (u2 <= d2)
        return 2 * of->mu_s * delta / sum;
    const double u = sqrt(u2), more = of->mu_s - of->mu_k;
    return of->mu_k / u + (more > 0 ? more * 4 * u * d2 / (sum * sum) : 0);
}

void sliding_slopes(double d[SLIDING], const double y[SLIDING],
                    const struct sliding *of)
{
    const double wX = y[WX], wY = y[WY], wZ = y[WZ], vX = y[VX], vh = y[VH];
    const double s = y[STH], c = y[CTH], sph = y[SPH], cph = y[CPH];
    const double k = 1 / of->IX, turn = wY / c;
    const double roll = of->IZ * k * wZ + s * turn, gX = -wY * roll;
    const double weight = 1 - wX * wX * c - s * gX;
    const double uX = vX + wZ, uh = vh - wX * c;
    const double g = grip(of, uX, uh);
    const double N = weight / (1 + k * s * (s + g * uh * c));
    const double FX = -g * N * uX, Fh = -g * N * uh;
    d[WX] = gX + k * (N * s - Fh * c);
    d[WY] = wX * roll;
    d[WZ] = FX / of->IZ;
    d[VX] = FX - turn * vh;
    d[VH] = Fh + turn * vX;
    d[STH] = c * wX;
    d[CTH] = -s * wX;
    d[SPH] = turn * cph;
    d[CPH] = -turn * sph;
    d[PHI] = turn;
    d[PSI] = wZ + s * turn;
    d[AT_X] = vX * cph + vh * sph;
    d[AT_Z] = vh * cph - vX * sph;
}

/* The impulse of the table in a time h, over M; friction along e_X, e_h. */
struct impulse {
    double N, X, h;
};

/* uX, uh: the slip without friction. */
static inline struct impulse impulse_of(const double *y,
                                        const struct sliding *of, double weight,
                                        double uX, double uh)
{
    const double s = y[STH], c = y[CTH], k = 1 / of->IX, D = 1 + k * s * s;
    struct impulse p;
    p.X = -uX / (1 + 1 / of->IZ);
    p.h = -uh * D / (1 + k);
    p.N = (weight + k * s * c * p.h) / D;
    const double F2 = p.X * p.X + p.h * p.h, most = of->mu_s * p.N;
    if (F2 > most * most) {
        const double u = sqrt(uX * uX + uh * uh), mu = of->mu_k;
        p.N = weight / (D + k * s * c * mu * uh / u);
        p.X = -mu * p.N * uX / u;
        p.h = -mu * p.N * uh / u;
    }
    return p;
}

void sliding_stepping(double y[SLIDING], const struct sliding *of, double h,
                      long steps)
{
    const double k = 1 / of->IX, kk = of->IZ * k;
    while (steps-- > 0) {
        const double wX = y[WX], s = y[STH], c = y[CTH], turn = y[WY] / c;
        const double roll = kk * y[WZ] + s * turn, gX = -y[WY] * roll;
        const double weight = 1 - wX * wX * c - s * gX;
        const double N0 = weight / (1 + k * s * s), vX = y[VX];
        y[WX] += h * (gX + k * N0 * s);
        y[WY] += h * wX * roll;
        y[VX] -= h * turn * y[VH];
        y[VH] += h * turn * vX;
        const struct impulse p =
            impulse_of(y, of, h * weight, y[VX] + y[WZ], y[VH] - y[WX] * c);
        y[WX] += k * ((p.N - h * N0) * s - p.h * c);
        y[WZ] += p.X / of->IZ;
        y[VX] += p.X;
        y[VH] += p.h;
        const double by = h * y[WX], on = h * y[WY] / c;
        const double sph = y[SPH], cph = y[CPH];
        y[AT_X] += h * (y[VX] * cph + y[VH] * sph);
        y[AT_Z] += h * (y[VH] * cph - y[VX] * sph);
        y[PSI] += h * y[WZ] + s * on;
        y[PHI] += on;
        y[STH] += by * (c - by / 2 * s);
        y[CTH] -= by * (s + by / 2 * c);
        y[SPH] += on * (cph - on / 2 * sph);
        y[CPH] -= on * (sph + on / 2 * cph);
    }
}
