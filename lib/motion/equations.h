/* SPDX-License-Identifier: MIT */
/* The equations of motion, and what follows from them. */
#ifndef ROLLCOIN_EQUATIONS_H
#define ROLLCOIN_EQUATIONS_H

#include "equations.t.h"

/* The variables of a state as a function, for callers that may take a little
 * longer than those of variables_inline(). */
coin_priv_variables coin_priv_variables_of(const coin_state *s);

/* Sets the rows of R to e_X, e_Y, e_Z, the axes of the coin, in the coordinates
 * x, y, z of the table. */
COIN_PRIV_INLINE void coin_priv_axes(const coin_priv_variables *y, number R[9])
{
    const number sth = y->sth, cth = y->cth, sph = y->sph, cph = y->cph;
    /* clang-format off */
    R[0] = cph;       R[1] = 0;    R[2] = -sph;      /* (7) */
    R[3] = sth * sph; R[4] = cth;  R[5] = sth * cph; /* (7) */
    R[6] = cth * sph; R[7] = -sth; R[8] = cth * cph; /* (7) */
    /* clang-format on */
}

/* d/dt of the rates of heading and roll in a drift: a motion with constant wX,
 * in which wY and wZ are functions of theta. */
typedef struct coin_priv_drift_slopes {
    number phi, psi;
} coin_priv_drift_slopes;

COIN_PRIV_INLINE coin_priv_drift_slopes coin_priv_drift_slopes_of(
    const coin_priv_constants *b, const coin_priv_variables *y)
{
    const number wX = y->wX, wY = y->wY, tth = y->tth;
    const number dwY = wY * tth + b->k1 * y->wZ; /* (15) over wX */
    const coin_priv_drift_slopes r = {
        wX * y->q * (dwY + wY * tth),
        wX * (b->k2 * wY + dwY * tth + wY * (K(1) + tth * tth)),
    };
    return r;
}

/* d/dtheta of d(wX)/dt along a drift.  In a steady motion it is minus the
 * square of the frequency of small oscillations. */
COIN_PRIV_INLINE number coin_priv_fall_slope(const coin_priv_constants *b,
                                             const coin_priv_variables *y)
{
    const number wY = y->wY, wZ = y->wZ, tth = y->tth;
    const number dwY = wY * tth + b->k1 * wZ, dwZ = b->k2 * wY;
    return b->GJ * y->cth - b->KJ * (dwY * wZ + wY * dwZ) -
           b->XJ * wY * (2 * dwY * tth + wY * (K(1) + tth * tth)); /* (44) */
}

#endif
