/* SPDX-License-Identifier: MIT */
#include "reaction.h"
#include "../motion/equations.h"
#include "../motion/state.h"

COIN(force) PRIV(reaction)(const PRIV(body) * b, const PRIV(variables) * y)
{
    const real wX = y->wX, wY = y->wY, wZ = y->wZ;
    const real sth = y->sth, cth = y->cth, sph = y->sph, cph = y->cph;
    const real Ma = b->M * b->a;
    const PRIV(field) field = PRIV(field_of)(b, 1);
    const real dwX = PRIV(rates)(&field, y).wX;
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

int32_t COIN(reaction)(const COIN(state) * s, const COIN(params) * p,
                       COIN(force) * out)
{
    PRIV(body) b;
    const int32_t status = out ? PRIV(check_here)(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const PRIV(variables) y = PRIV(variables_of)(s);
    *out = PRIV(reaction)(&b, &y);
    return COIN_OK;
}
