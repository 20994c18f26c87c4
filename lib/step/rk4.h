/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_RK4_H
#define ROLLCOIN_RK4_H

#include "progress.h"

#include "rk4.t.h"

COIN_PRIV_INLINE PRIV(rk4_fields)
    PRIV(rk4_fields_of)(const PRIV(body) * b, real dt)
{
    const PRIV(rk4_fields) k = {
        PRIV(field_of)(b, dt / 2),
        PRIV(field_of)(b, dt),
        PRIV(field_of)(b, dt / 6),
    };
    return k;
}

COIN_PRIV_INLINE void PRIV(rk4_step)(PRIV(step_end) * end,
                                     PRIV(variables) * next,
                                     const PRIV(variables) * y,
                                     const void *fields)
{
    const PRIV(sc) lean = {y->sth, y->cth}, heading = {y->sph, y->cph};
    PRIV(rk4_lean) after;
    *end = PRIV(rk4_end)(&after, y, (const PRIV(rk4_fields) *)fields);
    if (COIN_PRIV_RARELY(!(FABS(after.late) <= COIN_PRIV_LITTLE_TURN)))
        after.th = PRIV(turned)(lean, end->adds.theta);
    *next =
        PRIV(variables_at)(end, after.th, PRIV(turned)(heading, end->adds.phi));
}

#endif
