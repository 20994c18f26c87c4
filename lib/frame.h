/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_FRAME_H
#define ROLLCOIN_FRAME_H

#include "sincos.h"

#include <coin.h>

/* The coin's frame: sines and cosines of lean and heading, computed once. */
typedef struct coin_priv_frame {
    double sth, cth, sph, cph;
} coin_priv_frame;

static inline coin_priv_frame coin_priv_frame_of(const coin_state *s)
{
    const coin_priv_sc th = coin_priv_sincos(s->theta);
    const coin_priv_sc ph = coin_priv_sincos(s->phi);
    const coin_priv_frame f = {th.s, th.c, ph.s, ph.c};
    return f;
}

/* The rows e_X, e_Y, e_Z in the table frame. */
static inline void coin_priv_frame_rows(const coin_priv_frame *f, double R[9])
{
    const double sth = f->sth, cth = f->cth, sph = f->sph, cph = f->cph;
    /* clang-format off */
    R[0] = cph;       R[1] = 0;    R[2] = -sph;      /* (7) */
    R[3] = sth * sph; R[4] = cth;  R[5] = sth * cph; /* (7) */
    R[6] = cth * sph; R[7] = -sth; R[8] = cth * cph; /* (7) */
    /* clang-format on */
}

#endif
