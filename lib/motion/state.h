/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_STATE_H
#define ROLLCOIN_STATE_H

#include "params.h"

/* COIN_NEARLY_FLAT begins below this cos theta (coin.h). */
#define COIN_PRIV_NEARLY_FLAT 0.01

/* The last lean that coin_state_check() accepts: that of a coin at rest. */
#define COIN_PRIV_LAST_LEAN (COIN_PRIV_HALF_PI - COIN_PRIV_EPSILON)

/* Whether all members are in range, with x and z up to `far` and the squares of
 * the rates up to w2_max.  NaN is not. */
COIN_PRIV_INLINE int coin_priv_members_in_range(const coin_state *s, number far,
                                                number w2_max)
{
    const number wX = s->wX, wY = s->wY, wZ = s->wZ;
    return COIN_PRIV_LOW_IN_RANGE(s) && FABS(s->theta) < COIN_PRIV_HALF_PI &&
           FABS(s->phi) <= COIN_PRIV_ANGLE_MAX &&
           FABS(s->psi) <= COIN_PRIV_ANGLE_MAX && FABS(s->x) <= far &&
           FABS(s->z) <= far && wX * wX <= w2_max && wY * wY <= w2_max &&
           wZ * wZ <= w2_max;
}

COIN_PRIV_INLINE int coin_priv_state_in_range(const coin_state *s,
                                              const coin_priv_constants *b)
{
    return coin_priv_members_in_range(s, COIN_PRIV_PLACE_MAX * b->a, b->w2_max);
}

/* Whether a step or a time is in range.  NaN is not. */
COIN_PRIV_INLINE int coin_priv_time_in_range(number t,
                                             const coin_priv_constants *b)
{
    return t * t * b->g_a <= COIN_PRIV_TIME_MAX * COIN_PRIV_TIME_MAX;
}

/* A lean that rounding took beyond the last one is the last one. */
COIN_PRIV_INLINE number coin_priv_lean_clamped(number theta)
{
    const number most = COIN_PRIV_LAST_LEAN;
    return theta > most ? most : theta < -most ? -most : theta;
}

/* The error for a step that cannot be made from *s. */
int32_t coin_priv_refusal(const coin_state *s, number a);

/* The checks that need no parameters: whether a state is in the range of some
 * coin. */
COIN_PRIV_INLINE int coin_priv_state_in_some_range(const coin_state *s)
{
    const number most = COIN_PRIV_RATE_MAX * COIN_PRIV_MOST;
    return coin_priv_members_in_range(s, COIN_PRIV_PLACE_MAX * COIN_PRIV_MOST,
                                      most * most);
}

/* The checks that nearly every public function begins with: COIN_EARG,
 * COIN_EPARAMS, COIN_ESTATE in this order.  COIN_OK sets *b.  Inline in the
 * caller, for functions that take no longer than their checks. */
COIN_PRIV_INLINE int32_t coin_priv_check_inline(const coin_state *s,
                                                const coin_params *p,
                                                coin_priv_constants *b)
{
    if (!s || !p)
        return COIN_EARG;
    const int32_t status = coin_priv_check_params(b, p);
    if (status != COIN_OK)
        return status;
    if (COIN_PRIV_RARELY(!coin_priv_state_in_range(s, b)))
        return COIN_ESTATE;
    return COIN_OK;
}

/* The same as a function. */
int32_t coin_priv_check(const coin_state *s, const coin_params *p,
                        coin_priv_constants *b);

/* Copies a state number by number.  An assignment uses wider moves.  Each of
 * them would wait until numbers just written have left the processor's store
 * buffer. */
COIN_PRIV_INLINE void coin_priv_copy_state(coin_state *to,
                                           const coin_state *from)
{
    number *const numbers = (number *)to;
#pragma GCC unroll 16
    for (size_t i = 0; i < sizeof *to / sizeof *numbers; ++i)
        numbers[i] = ((const number *)from)[i];
}

/* Whether a coin lies flat. */
COIN_PRIV_INLINE int coin_priv_lies_flat(const coin_state *s)
{
    return FABS(s->theta) >= COIN_PRIV_LAST_LEAN && s->wY == 0 &&
           s->wX * s->theta >= 0;
}

#endif
