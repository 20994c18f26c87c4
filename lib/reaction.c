/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "reaction.h"
#include "stage.h"
#include "state.h"

#include <math.h>

coin_force coin_priv_reaction(const coin_priv_body *b, const coin_priv_stage *y)
{
    const double wX = y->wX, wY = y->wY, wZ = y->wZ;
    const double sth = y->sth, cth = y->cth, sph = y->sph, cph = y->cph;
    const double Ma = b->M * b->a;
    const coin_priv_field field = coin_priv_field_of(b, 1);
    const double dwX = coin_priv_motion(&field, y).wX;
    /* Along e_X, and along the horizontal e_h = (sin phi, 0, cos phi). */
    const double RX = Ma * (wX * wY * (b->IZ / b->K)); /* (25) */
    const double Rh =
        Ma * (dwX * cth + wY * wZ * y->q - wX * wX * sth); /* (26) */
    coin_force f;
    f.R[0] = RX * cph + Rh * sph;                      /* (28) */
    f.R[1] = b->Mg - Ma * (wX * wX * cth + dwX * sth); /* (27) */
    f.R[2] = Rh * cph - RX * sph;                      /* (28) */
    f.normal = f.R[1];
    f.friction = coin_priv_hypot(RX, Rh); /* (28) */
    f.ratio = f.normal > 0 ? f.friction / f.normal : (double)INFINITY;
    return f;
}

int32_t coin_reaction(const coin_state *s, const coin_params *p,
                      coin_force *out)
{
    coin_priv_body b;
    const int32_t status = out ? coin_priv_check(s, p, &b) : COIN_EARG;
    if (status != COIN_OK)
        return status;
    const coin_priv_stage y = coin_priv_stage_of(s);
    *out = coin_priv_reaction(&b, &y);
    return COIN_OK;
}
