/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_REACTION_H
#define ROLLCOIN_REACTION_H

#include "../motion/equations.h"

/* The force of the table on a coin with these variables. */
COIN_PRIV_INLINE COIN(force)
    PRIV(reaction)(const PRIV(body) * b, const PRIV(variables) * y)
{
    const real wX = y->wX, wY = y->wY, wZ = y->wZ;
    const real sth = y->sth, cth = y->cth, sph = y->sph, cph = y->cph;
    const real Ma = b->M * b->a;
    const PRIV(field) field = PRIV(field_of)(b, 1);
    const real dwX = PRIV(slopes_at)(&field, y).wX;
    /* Along e_X, and along the horizontal e_h = (sin phi, 0, cos phi). */
    const real RX = Ma * (wX * wY * (b->IZ / b->K)); /* (25) */
    const real Rh =
        Ma * (dwX * cth + wY * wZ * y->q - wX * wX * sth); /* (26) */
    COIN(force) f;
    f.R[0] = RX * cph + Rh * sph;                      /* (28) */
    f.R[1] = b->Mg - Ma * (wX * wX * cth + dwX * sth); /* (27) */
    f.R[2] = Rh * cph - RX * sph;                      /* (28) */
    f.normal = f.R[1];
    f.friction = PRIV(hypot)(RX, Rh); /* (28) */
    f.ratio = f.normal > 0 ? f.friction / f.normal : (real)INFINITY;
    return f;
}

#endif
