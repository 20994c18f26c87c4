/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_STATE_H
#define ROLLCOIN_STATE_H

#include "body.h"

/* Lean, heading and roll alone. */
COIN_PRIV_INLINE int PRIV(angles_hold)(const COIN(state) * s)
{
    return FABS(s->theta) < COIN_PRIV_HALF_PI &&
           FABS(s->phi) <= COIN_PRIV_ANGLE_MAX &&
           FABS(s->psi) <= COIN_PRIV_ANGLE_MAX;
}

/* Whether all members are in range, with x and z up to `far` and the squares of
 * the rates up to w2_max.  NaN is not. */
COIN_PRIV_INLINE int PRIV(state_within)(const COIN(state) * s, real far,
                                        real w2_max)
{
    const real wX = s->wX, wY = s->wY, wZ = s->wZ;
    return COIN_PRIV_LOW_HOLDS(s) && PRIV(angles_hold)(s) &&
           FABS(s->x) <= far && FABS(s->z) <= far && wX * wX <= w2_max &&
           wY * wY <= w2_max && wZ * wZ <= w2_max;
}

COIN_PRIV_INLINE int PRIV(state_holds)(const COIN(state) * s,
                                       const PRIV(body) * b)
{
    return PRIV(state_within)(s, COIN_PRIV_PLACE_MAX * b->a, b->w2_max);
}

/* Whether a step or a time is in range.  NaN is not. */
COIN_PRIV_INLINE int PRIV(time_holds)(real t, const PRIV(body) * b)
{
    return t * t * b->g_a <= COIN_PRIV_TIME_MAX * COIN_PRIV_TIME_MAX;
}

/* A lean that rounding took beyond the last one is the last one. */
COIN_PRIV_INLINE real PRIV(lean_within)(real theta)
{
    const real most = COIN_PRIV_HALF_PI - COIN_PRIV_EPSILON;
    return theta > most ? most : theta < -most ? -most : theta;
}

/* The error for a step that cannot be made from *s. */
int32_t PRIV(refusal)(const COIN(state) * s, real a);

/* The checks that need no parameters: COIN_OK or COIN_ESTATE.  s is not null.
 */
COIN_PRIV_INLINE int32_t PRIV(check_members)(const COIN(state) * s)
{
    const int good = PRIV(angles_hold)(s) && PRIV(is_finite)(s->x) &&
                     PRIV(is_finite)(s->z) && PRIV(is_finite)(s->wX) &&
                     PRIV(is_finite)(s->wY) && PRIV(is_finite)(s->wZ) &&
                     COIN_PRIV_LOW_HOLDS(s);
    return good ? COIN_OK : COIN_ESTATE;
}

/* The checks that nearly every public function begins with: COIN_EARG,
 * COIN_EPARAMS, COIN_ESTATE in this order.  After COIN_OK *b holds the body.
 * Inline in the caller, for functions that take no longer than their checks.
 */
COIN_PRIV_INLINE int32_t PRIV(check_inline)(const COIN(state) * s,
                                            const COIN(params) * p,
                                            PRIV(body) * b)
{
    if (!s || !p)
        return COIN_EARG;
    const int32_t status = PRIV(check_body)(b, p);
    if (status != COIN_OK)
        return status;
    return PRIV(state_holds)(s, b) ? COIN_OK : COIN_ESTATE;
}

/* The same as a function. */
int32_t PRIV(check)(const COIN(state) * s, const COIN(params) * p,
                    PRIV(body) * b);

/* Copies a state number by number.  An assignment uses wider moves.  Each of
 * them would wait until numbers just written have left the processor's store
 * buffer, 10 ns. */
COIN_PRIV_INLINE void PRIV(copy_state)(COIN(state) * to,
                                       const COIN(state) * from)
{
    real *const numbers = (real *)to;
#pragma GCC unroll 16
    for (size_t i = 0; i < sizeof *to / sizeof *numbers; ++i)
        numbers[i] = ((const real *)from)[i];
}

#endif
