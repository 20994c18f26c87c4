/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "steady.h"
#include "steady_at.h"

static coin_priv_steady rates_of(const coin_state *s,
                                 const coin_priv_constants *b)
{
    const coin_priv_variables y = coin_priv_variables_of(s);
    const coin_priv_field f = coin_priv_field_of(b, 1);
    const coin_priv_pose v = coin_priv_pose_slopes(&f, &y);
    const coin_priv_steady rates = {v.phi, v.psi, b->a * s->wZ};
    return rates;
}

void coin_priv_steady_move(coin_state *s, const coin_priv_steady *rates,
                           double t)
{
    const double half = rates->heading * t / 2; /* (56) */
    const coin_priv_sc h = coin_priv_sincos(half),
                       ph = coin_priv_sincos(s->phi);
    /* The operands are chosen before one division, so that no compiler can make
     * it divide 0 by 0. */
    const int turns = half != 0;
    const double sinc = (turns ? h.s : 1) / (turns ? half : 1);
    const double way = rates->speed * t * sinc; /* (56) */
    s->wX = 0;
    s->phi += 2 * half;        /* (56) */
    s->psi += rates->roll * t; /* (56) */
    /* The direction is phi + half.  That sum is not computed, as it would be
     * rounded if phi is large. */
    s->x -= way * (ph.c * h.c - ph.s * h.s); /* (56) */
    s->z += way * (ph.s * h.c + ph.c * h.s); /* (56) */
}

int32_t coin_steady_at(const coin_state *s, const coin_params *p, double t,
                       coin_state *out)
{
    coin_priv_constants b;
    coin_priv_sc th;
    int32_t status = out ? coin_priv_check_steady(s, p, &b, &th) : COIN_EARG;
    if (status == COIN_OK || status == COIN_EDOMAIN)
        status = coin_priv_time_in_range(t, &b) ? status : COIN_ESTEP;
    if (status != COIN_OK)
        return status;
    const coin_priv_steady rates = rates_of(s, &b);
    coin_state at = *s;
    coin_priv_steady_move(&at, &rates, t);
    if (!coin_priv_state_in_range(&at, &b))
        return COIN_ERANGE;
    *out = at;
    return COIN_OK;
}
