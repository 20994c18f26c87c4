/* SPDX-License-Identifier: MIT */
#include "textbook.h"

#include <math.h>
#include <string.h>

enum { MEMBERS = 8 };

static coin_state rates_of(const coin_state *s, const coin_params *p)
{
    const double M = p->mass, a = p->radius, g = p->gravity;
    const double IX = p->inertia_X, IZ = p->inertia_Z, m = M * a * a;
    const double wX = s->wX, wY = s->wY, wZ = s->wZ;
    const double sth = sin(s->theta), cth = cos(s->theta), tth = tan(s->theta);
    const double sph = sin(s->phi), cph = cos(s->phi);
    coin_state d;
    d.wX =
        (-(IZ + m) * wY * wZ - IX * wY * wY * tth + M * a * g * sth) / (IX + m);
    d.wY = wX * wY * tth + IZ / IX * wZ * wX;
    d.wZ = m / (IZ + m) * wX * wY;
    d.theta = wX;
    d.phi = wY / cth;
    d.psi = wZ + wY * tth;
    d.x = a * (-wZ * cph + wX * cth * sph);
    d.z = a * (wZ * sph + wX * cth * cph);
    return d;
}

/* s + h d */
static coin_state moved(const coin_state *s, double h, const coin_state *d)
{
    double y[MEMBERS], k[MEMBERS];
    coin_state r;
    memcpy(y, s, sizeof y);
    memcpy(k, d, sizeof k);
    for (int i = 0; i < MEMBERS; ++i)
        y[i] += h * k[i];
    memcpy(&r, y, sizeof r);
    return r;
}

void textbook_step(coin_state *s, const coin_params *p, double dt)
{
    const coin_state k1 = rates_of(s, p);
    const coin_state y2 = moved(s, dt / 2, &k1), k2 = rates_of(&y2, p);
    const coin_state y3 = moved(s, dt / 2, &k2), k3 = rates_of(&y3, p);
    const coin_state y4 = moved(s, dt, &k3), k4 = rates_of(&y4, p);
    *s = moved(s, dt / 6, &k1);
    *s = moved(s, dt / 3, &k2);
    *s = moved(s, dt / 3, &k3);
    *s = moved(s, dt / 6, &k4);
}
