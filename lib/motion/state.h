/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_STATE_H
#define ROLLCOIN_STATE_H

#include "body.h"

/* Whether the path has not overflowed. */
COIN_PRIV_INLINE int PRIV(path_holds)(const COIN(state) * s)
{
    return PRIV(is_finite)(s->x) && PRIV(is_finite)(s->z);
}

/* Lean, heading, roll and path alone. */
COIN_PRIV_INLINE int PRIV(pose_holds)(const COIN(state) * s)
{
    return FABS(s->theta) < COIN_PRIV_HALF_PI &&
           FABS(s->phi) <= COIN_PRIV_ANGLE_MAX &&
           FABS(s->psi) <= COIN_PRIV_ANGLE_MAX && PRIV(path_holds)(s) &&
           COIN_PRIV_LOW_HOLDS(s);
}

/* A lean that rounding took beyond the last one is the last one. */
COIN_PRIV_INLINE real PRIV(lean_within)(real theta)
{
    const real most = COIN_PRIV_HALF_PI - COIN_PRIV_EPSILON;
    return theta > most ? most : theta < -most ? -most : theta;
}

/* The error for a step that cannot be made from *s.  No step turns phi or psi
 * by 16 rad. */
COIN_PRIV_INLINE int32_t PRIV(refusal)(const COIN(state) * s)
{
    const real last = COIN_PRIV_ANGLE_MAX - 16;
    return FABS(s->phi) > last || FABS(s->psi) > last ? COIN_ERANGE
                                                      : COIN_ESTEP;
}

/* The checks that need no parameters: COIN_OK or COIN_ESTATE.  s is not null.
 */
COIN_PRIV_INLINE int32_t PRIV(check_members)(const COIN(state) * s)
{
    const int good = PRIV(pose_holds)(s) && PRIV(is_finite)(s->wX) &&
                     PRIV(is_finite)(s->wY) && PRIV(is_finite)(s->wZ);
    return good ? COIN_OK : COIN_ESTATE;
}

/* The checks of a state whose body is known.  After COIN_OK no energy, force or
 * rate of it overflows. */
COIN_PRIV_INLINE int32_t PRIV(check_state)(const COIN(state) * s,
                                           const PRIV(body) * b)
{
    const real wX = s->wX, wY = s->wY, wZ = s->wZ;
    const int good =
        wX * wX + wY * wY + wZ * wZ <= b->w2_max && PRIV(pose_holds)(s);
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
    int32_t status = PRIV(check_body)(b, p);
    if (status != COIN_OK)
        return status;
    status = PRIV(check_state)(s, b);
    if (COIN_PRIV_RARELY(status != COIN_OK)) {
        PRIV(check_any_body)(b, p); /* has the exact limit of |omega|^2 */
        status = PRIV(check_state)(s, b);
    }
    return status;
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
