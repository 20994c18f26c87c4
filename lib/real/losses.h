/* SPDX-License-Identifier: MIT */
/* What slows a coin: the torques of Eq. (65)-(67) in Sundman's time. */
#ifndef ROLLCOIN_LOSSES_H
#define ROLLCOIN_LOSSES_H

#include "../motion/equations.h"

#include <math.h>

/* Losses as the slopes read them. */
typedef struct coin_priv_losses {
    double damping, dry, viscous, layer, gap, rolling, spin;
    double soft2;        /* the square of the softening rate */
    double IX, J, K;     /* the body's inertias */
    double solid, fluid; /* > 0 if a term of that kind is there */
} coin_priv_losses;

/* What the losses add to the slopes by tau of wX, wY, wZ, and the energy that
 * they take per tau. */
typedef struct coin_priv_slowing {
    double wX, wY, wZ, power;
} coin_priv_slowing;

/* COIN_OK and *out, or COIN_EPARAMS.  l is not null. */
int32_t coin_priv_losses_of(coin_priv_losses *out, const coin_losses *l,
                            const coin_priv_body *b);

/* Whether nothing slows the coin. */
int coin_priv_lossless(const coin_losses *l);

/* -Q/u of the contour friction, u = cos(theta) d(psi)/dt. */
COIN_PRIV_INLINE double coin_priv_grip(const coin_priv_losses *l, double u,
                                       double cth)
{
    double grip = 0;
    if (l->solid > 0)
        grip = (l->dry + l->rolling * cth) /
               sqrt(u * u + l->soft2 * (cth * cth)); /* (65) */
    if (l->fluid > 0) {
        const double q = 1 / cth;
        grip += q * (l->viscous + l->layer * sqrt(fabs(u * q)) +
                     l->gap * q); /* (65) */
    }
    return grip;
}

COIN_PRIV_INLINE coin_priv_slowing coin_priv_slow(const coin_priv_losses *l,
                                                  const coin_priv_variables *y)
{
    const double wX = y->wX, wY = y->wY, wZ = y->wZ;
    const double sth = y->sth, cth = y->cth;
    const double u = cth * wZ + sth * wY;
    const double Q = -u * coin_priv_grip(l, u, cth);
    const double fade = l->damping * fabs(u); /* (66) */
    const double wy = wY * cth - wZ * sth;    /* about the vertical */
    const double turn = l->spin * wy * cth;   /* (67) */
    const double T2 = l->J * wX * wX + l->IX * wY * wY + l->K * wZ * wZ;
    const coin_priv_slowing d = {
        -fade * wX, (Q * sth - turn * cth) / l->IX - fade * wY, /* (68) */
        (Q * cth + turn * sth) / l->K - fade * wZ,              /* (68) */
        fade * T2 + turn * wy - Q * u,                          /* (69) */
    };
    return d;
}

#endif
