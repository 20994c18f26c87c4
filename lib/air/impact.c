/* SPDX-License-Identifier: MIT */
/* An impact at the lowest point of the rim, by the law of Chatterjee and Ruina
 * with no tangential restitution. */
#include "../motion/pinned.h"

#include "air.h"

#include <float.h>

coin_priv_rim coin_priv_rim_of(const coin_body *b, const coin_priv_attitude *at)
{
    const coin_state *const q = &b->s;
    const coin_priv_rim u = {
        b->vx * at->ph.c - b->vz * at->ph.s + q->wZ, /* (105) */
        b->vx * at->ph.s + b->vz * at->ph.c - q->wX * at->th.c,
        b->vy + q->wX * at->th.s,
    };
    return u;
}

/* The part of the change from the smooth impact to the one that sticks. */
static double part(const coin_priv_bounce *law, double N, double T, double lift)
{
    if (law->mu_static > DBL_MAX || T <= law->mu_static * (N + lift))
        return 1;
    return law->mu_kinetic * N / (T - law->mu_kinetic * lift); /* (108) */
}

void coin_priv_impact(coin_body *b, const coin_priv_attitude *at, double IX,
                      double IZ, const coin_priv_bounce *law)
{
    coin_state *const q = &b->s;
    const coin_priv_rim u = coin_priv_rim_of(b, at);
    const coin_priv_sc ph = at->ph;
    const double s = at->th.s, c = at->th.c, kx = 1 / IX, kz = 1 / IZ;
    const double wy = 1 + kx * (s * s), o = kx * c * s / wy; /* (106) */
    const double N = (1 + law->restitution) * -u.y / wy;     /* (107) */
    const double dX = -u.X / (1 + kz);                       /* (107) */
    const double dh = -wy / (1 + kx) * (u.h + o * u.y);      /* (107) */
    const double f = part(law, N, sqrt(dX * dX + dh * dh), o * dh);
    const double pX = f * dX, along = f * dh, py = N + o * along;
    b->vx += pX * ph.c + along * ph.s;
    b->vz += along * ph.c - pX * ph.s;
    q->wX -= kx * (c * along - s * py); /* (106) */
    q->wZ += kz * pX;                   /* (106) */
    b->vy = law->restitution > 0 ? b->vy + py : -(q->wX * s);
}
