/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_REACTION_H
#define ROLLCOIN_REACTION_H

#include "../motion/equations.h"

/* The force of the table on a coin with these variables. */
COIN_PRIV_INLINE coin_force coin_priv_reaction(const coin_priv_constants *b,
                                               const coin_priv_variables *y)
{
    const number wX = y->wX, wY = y->wY, wZ = y->wZ;
    const number sth = y->sth, cth = y->cth, sph = y->sph, cph = y->cph;
    const number Ma = b->M * b->a;
    const coin_priv_field field = coin_priv_field_of(b, 1);
    const number dwX = coin_priv_slopes_at(&field, y).wX;
    /* Along e_X, and along the horizontal e_h = (sin phi, 0, cos phi). */
    const number RX = Ma * (wX * wY * (b->IZ / b->K)); /* (25) */
    const number Rh =
        Ma * (dwX * cth + wY * wZ * y->q - wX * wX * sth); /* (26) */
    coin_force f;
    f.R[0] = RX * cph + Rh * sph;                      /* (28) */
    f.R[1] = b->Mg - Ma * (wX * wX * cth + dwX * sth); /* (27) */
    f.R[2] = Rh * cph - RX * sph;                      /* (28) */
    f.normal = f.R[1];
    f.friction = coin_priv_hypot(RX, Rh); /* (28) */
    f.ratio = f.normal > 0 ? f.friction / f.normal : (number)INFINITY;
    return f;
}

#endif
