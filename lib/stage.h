/* SPDX-License-Identifier: MIT */
/* What a state and a body are to the equations of motion. */
#ifndef ROLLCOIN_STAGE_H
#define ROLLCOIN_STAGE_H

#include "frame.h"
#include "motion.h"
#include "params.h"

static inline coin_priv_stage coin_priv_stage_of(const coin_state *s)
{
    const coin_priv_frame f = coin_priv_frame_of(s);
    const coin_priv_stage y = {
        s->wX,     s->wY,         s->wZ, f.sth, f.cth,
        1 / f.cth, f.sth / f.cth, f.sph, f.cph,
    };
    return y;
}

static inline coin_priv_field coin_priv_field_of(const coin_priv_body *b,
                                                 double h)
{
    const coin_priv_field f = {
        h, h * b->GJ, h * b->KJ, b->XJ, h * b->k1, h * b->k2,
    };
    return f;
}

#endif
