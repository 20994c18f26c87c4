/* SPDX-License-Identifier: MIT */
/* The variables and the coefficients of the equations of motion, from a state
 * and a body. */
#ifndef ROLLCOIN_EQUATIONS_H
#define ROLLCOIN_EQUATIONS_H

#include "angles.h"
#include "body.h"

#include "equations.t.h"

/* The variables of a state, inline in the caller.  The lean is reduced only
 * where that is needed: its sine and cosine are then known sooner, and a step
 * waits for them. */
COIN_PRIV_INLINE PRIV(variables) PRIV(variables_inline)(const COIN(state) * s)
{
    const PRIV(sc) ph = PRIV(sine_cosine)(s->phi);
    const PRIV(sc) th = FABS(s->theta) <= K(0.5) * COIN_PRIV_HALF_PI
                            ? PRIV(sine_cosine_reduced)(s->theta, 0)
                            : PRIV(sine_cosine)(s->theta);
    const real q = 1 / th.c;
    const PRIV(variables) y = {
        s->wX, s->wY, s->wZ, th.s, th.c, q, q * th.s, ph.s, ph.c,
    };
    return y;
}

COIN_PRIV_INLINE PRIV(field) PRIV(field_of)(const PRIV(body) * b, real h)
{
    const PRIV(field) f = {
        h, h * b->GJ, h * b->KJ, b->XJ, h * b->k1, h * b->k2,
    };
    return f;
}

/* The same as a function, for callers that may take a little longer. */
PRIV(variables) PRIV(variables_of)(const COIN(state) * s);

/* The rows e_X, e_Y, e_Z of the coin's frame in the table's. */
COIN_PRIV_INLINE void PRIV(axes)(const PRIV(variables) * y, real R[9])
{
    const real sth = y->sth, cth = y->cth, sph = y->sph, cph = y->cph;
    /* clang-format off */
    R[0] = cph;       R[1] = 0;    R[2] = -sph;      /* (7) */
    R[3] = sth * sph; R[4] = cth;  R[5] = sth * cph; /* (7) */
    R[6] = cth * sph; R[7] = -sth; R[8] = cth * cph; /* (7) */
    /* clang-format on */
}

/* d/dt of the rates of heading and roll in a drift: a motion with constant wX,
 * in which wY and wZ are functions of theta. */
typedef struct PRIV(drift_slopes) {
    real phi, psi;
} PRIV(drift_slopes);

COIN_PRIV_INLINE PRIV(drift_slopes)
    PRIV(drift_slopes_of)(const PRIV(body) * b, const PRIV(variables) * y)
{
    const real wX = y->wX, wY = y->wY, tth = y->tth;
    const real dwY = wY * tth + b->k1 * y->wZ; /* (15) over wX */
    const PRIV(drift_slopes) r = {
        wX * y->q * (dwY + wY * tth),
        wX * (b->k2 * wY + dwY * tth + wY * (K(1) + tth * tth)),
    };
    return r;
}

/* d/dtheta of d(wX)/dt along a drift.  In a steady motion it is minus the
 * square of the frequency of small oscillations. */
COIN_PRIV_INLINE real PRIV(fall_slope)(const PRIV(body) * b,
                                       const PRIV(variables) * y)
{
    const real wY = y->wY, wZ = y->wZ, tth = y->tth;
    const real dwY = wY * tth + b->k1 * wZ, dwZ = b->k2 * wY;
    return b->GJ * y->cth - b->KJ * (dwY * wZ + wY * dwZ) -
           b->XJ * wY * (2 * dwY * tth + wY * (K(1) + tth * tth)); /* (44) */
}

#endif
