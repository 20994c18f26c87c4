/* SPDX-License-Identifier: MIT */
/* The losses: the torques of Eq. (65)-(67), in Sundman's time. */
#ifndef ROLLCOIN_LOSSES_H
#define ROLLCOIN_LOSSES_H

#include "../motion/equations.h"

#include <math.h>

/* Losses as the slopes read them. */
typedef struct PRIV(losses) {
    real damping, dry, viscous, layer, gap, rolling, spin;
    real soft2;    /* the square of the softening rate */
    real IX, J, K; /* the body's inertias */
    real solid;    /* dry + rolling */
    real fluid;    /* viscous + layer + gap */
} PRIV(losses);

/* What the losses add to the slopes of wX, wY, wZ by tau, and the energy that
 * they take per unit of tau. */
typedef struct PRIV(slowing) {
    real wX, wY, wZ, power;
} PRIV(slowing);

/* COIN_OK and *out, or COIN_EPARAMS.  l is not null. */
int32_t PRIV(losses_of)(PRIV(losses) * out, const COIN(losses) * l,
                        const PRIV(body) * b);

/* Whether all coefficients are 0. */
int PRIV(lossless)(const COIN(losses) * l);

/* u = cos(theta) d(psi)/dt: how fast the contact rolls along the rim, by tau.
 */
COIN_PRIV_INLINE real PRIV(roll_speed)(real wY, real wZ, real sth, real cth)
{
    return cth * wZ + sth * wY;
}

/* -Q/u of the contour friction. */
COIN_PRIV_INLINE real PRIV(grip)(const PRIV(losses) * l, real u, real cth)
{
    real grip = 0;
    if (l->solid > 0)
        grip = (l->dry + l->rolling * cth) /
               SQRT(u * u + l->soft2 * (cth * cth)); /* (65) */
    if (l->fluid > 0) {
        const real q = 1 / cth;
        grip += q * (l->viscous + l->layer * SQRT(FABS(u * q)) +
                     l->gap * q); /* (65) */
    }
    return grip;
}

COIN_PRIV_INLINE PRIV(slowing)
    PRIV(slowing_of)(const PRIV(losses) * l, const PRIV(variables) * y)
{
    const real wX = y->wX, wY = y->wY, wZ = y->wZ;
    const real sth = y->sth, cth = y->cth;
    const real u = PRIV(roll_speed)(wY, wZ, sth, cth);
    const real Q = -u * PRIV(grip)(l, u, cth);
    const real fade = l->damping * FABS(u); /* (66) */
    const real wy = wY * cth - wZ * sth;    /* about the vertical */
    const real turn = l->spin * wy * cth;   /* (67) */
    const real T2 = l->J * wX * wX + l->IX * wY * wY + l->K * wZ * wZ;
    const PRIV(slowing) d = {
        -fade * wX, (Q * sth - turn * cth) / l->IX - fade * wY, /* (68) */
        (Q * cth + turn * sth) / l->K - fade * wZ,              /* (68) */
        fade * T2 + turn * wy - Q * u,                          /* (69) */
    };
    return d;
}

/* The rate in tau at which the losses make the rates decay; (71) is made of it.
 */
COIN_PRIV_INLINE real PRIV(friction_rate)(const PRIV(losses) * l,
                                          const PRIV(variables) * y)
{
    const real sth = y->sth, cth = y->cth;
    const real u = PRIV(roll_speed)(y->wY, y->wZ, sth, cth);
    const real grip = PRIV(grip)(l, u, cth);
    const real lever = sth * sth / l->IX + cth * cth / l->K;
    return grip * lever + l->damping * FABS(u) + l->spin * cth / l->IX;
}

#endif
