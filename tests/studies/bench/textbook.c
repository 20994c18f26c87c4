/* SPDX-License-Identifier: MIT */
#include "textbook.h"

#include <math.h>

/* y = theta, phi, psi, x, z, wX, wY, wZ */
void textbook_rates(double d[8], const coin_params *p, const double y[8])
{
    const double M = p->mass, a = p->radius, g = p->gravity;
    const double IX = p->inertia_X, IZ = p->inertia_Z, m = M * a * a;
    const double wX = y[5], wY = y[6], wZ = y[7];
    const double s = sin(y[0]), c = cos(y[0]), t = s / c;
    const double sph = sin(y[1]), cph = cos(y[1]);
    d[0] = wX;
    d[1] = wY / c;
    d[2] = wZ + wY * t;
    d[3] = a * (-wZ * cph + wX * c * sph);
    d[4] = a * (wZ * sph + wX * c * cph);
    d[5] = (-(IZ + m) * wY * wZ - IX * wY * wY * t + M * g * a * s) / (IX + m);
    d[6] = wX * wY * t + IZ * wZ * wX / IX;
    d[7] = m * wX * wY / (IZ + m);
}

void textbook_run(coin_state *s, const coin_params *p, double dt,
                  unsigned long steps)
{
    double y[8] = {s->theta, s->phi, s->psi, s->x, s->z, s->wX, s->wY, s->wZ};
    double k1[8], k2[8], k3[8], k4[8], v[8];
    while (steps-- > 0) {
        textbook_rates(k1, p, y);
        for (int i = 0; i < 8; ++i)
            v[i] = y[i] + dt / 2 * k1[i];
        textbook_rates(k2, p, v);
        for (int i = 0; i < 8; ++i)
            v[i] = y[i] + dt / 2 * k2[i];
        textbook_rates(k3, p, v);
        for (int i = 0; i < 8; ++i)
            v[i] = y[i] + dt * k3[i];
        textbook_rates(k4, p, v);
        for (int i = 0; i < 8; ++i)
            y[i] += dt / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
    const coin_state r = {y[0], y[1], y[2], y[3], y[4], y[5], y[6], y[7]};
    *s = r;
}
