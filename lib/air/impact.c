/* SPDX-License-Identifier: MIT */
/* An impact at the lowest point of the rim, by the law of Chatterjee and Ruina
 * with no tangential restitution. */
#include "../motion/pinned.h"

#include "air.h"

coin_priv_rim coin_priv_rim_of(const coin_priv_coin *c, double eta)
{
    const coin_priv_lever d = coin_priv_lever_of(c->th.s, c->th.c, eta);
    const coin_priv_rim u = {
        c->vx * c->ph.c - c->vz * c->ph.s + c->wZ + eta * c->wY, /* (105) */
        c->vx * c->ph.s + c->vz * c->ph.c - c->wX * d.Y,
        c->vy + c->wX * d.P,
    };
    return u;
}

/* The part of the change from the smooth impact to the one that sticks. */
static double part(const coin_priv_bounce *law, double N, double T, double lift)
{
    const int holds_all = law->mu_static > 1e100; /* no T is so large */
    if (holds_all || T <= law->mu_static * (N + lift))
        return 1;
    return law->mu_kinetic * N / (T - law->mu_kinetic * lift); /* (108) */
}

void coin_priv_impact(coin_priv_coin *c, double eta, double IX, double IZ,
                      const coin_priv_bounce *law)
{
    const coin_priv_rim u = coin_priv_rim_of(c, eta);
    const coin_priv_lever d = coin_priv_lever_of(c->th.s, c->th.c, eta);
    const coin_priv_sc ph = c->ph;
    const double P = d.P, Y = d.Y, kx = 1 / IX, kz = 1 / IZ, eta2 = eta * eta;
    const double Wyy = 1 + kx * (P * P), o = kx * Y * P / Wyy; /* (106) */
    const double N = (1 + law->restitution) * -u.y / Wyy;      /* (107) */
    const double dX = -u.X / (1 + kz + kx * eta2);             /* (107) */
    const double dh =
        -Wyy / (1 + kx * (1 + eta2)) * (u.h + o * u.y); /* (107) */
    const double f = part(law, N, sqrt(dX * dX + dh * dh), o * dh);
    const double pX = f * dX, along = f * dh, py = N + o * along;
    c->vx += pX * ph.c + along * ph.s;
    c->vz += along * ph.c - pX * ph.s;
    c->wX -= kx * (Y * along - P * py); /* (106) */
    c->wY += kx * eta * pX;             /* (106) */
    c->wZ += kz * pX;                   /* (106) */
    c->vy = law->restitution > 0 ? c->vy + py : -(c->wX * P);
}
