/* SPDX-License-Identifier: MIT */
/* An impact at the lowest point of the rim, by the law of Chatterjee and Ruina
 * with no tangential restitution. */
#include "../motion/pinned.h"

#include "../motion/angles.h"

#include "air.h"

#include <float.h>

double coin_priv_rim_speed(const coin_body *b)
{
    return b->vy + b->s.wX * coin_priv_sincos(b->s.theta).s;
}

/* The part of the change from the smooth impact to the one that sticks. */
static double part(const coin_priv_bounce *law, double N, double T, double lift)
{
    if (law->mu_static > DBL_MAX || T <= law->mu_static * (N + lift))
        return 1;
    return law->mu_kinetic * N / (T - law->mu_kinetic * lift); /* (108) */
}

void coin_priv_impact(coin_body *b, double IX, double IZ,
                      const coin_priv_bounce *law)
{
    coin_state *const q = &b->s;
    const coin_priv_sc th = coin_priv_sincos(q->theta);
    const coin_priv_sc ph = coin_priv_sincos(q->phi);
    const double s = th.s, c = th.c, kx = 1 / IX, kz = 1 / IZ;
    const double wy = 1 + kx * (s * s), o = kx * c * s / wy; /* (106) */
    const double uX = b->vx * ph.c - b->vz * ph.s + q->wZ;   /* (105) */
    const double uh = b->vx * ph.s + b->vz * ph.c - q->wX * c;
    const double uy = b->vy + q->wX * s;
    const double N = (1 + law->restitution) * -uy / wy; /* (107) */
    const double dX = -uX / (1 + kz);                   /* (107) */
    const double dh = -wy / (1 + kx) * (uh + o * uy);   /* (107) */
    const double f = part(law, N, coin_priv_hypot(dX, dh), o * dh);
    const double pX = f * dX, along = f * dh, py = N + o * along;
    b->vx += pX * ph.c + along * ph.s;
    b->vz += along * ph.c - pX * ph.s;
    q->wX -= kx * (c * along - s * py); /* (106) */
    q->wZ += kz * pX;                   /* (106) */
    b->vy = law->restitution > 0 ? b->vy + py : -(q->wX * s);
}
