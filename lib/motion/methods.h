/* SPDX-License-Identifier: MIT */
/* The methods by which a coin is stepped. */
#ifndef ROLLCOIN_METHODS_H
#define ROLLCOIN_METHODS_H

/* Steps of a block; blocks are counted from the start of a run, so that its
 * bits do not depend on where it is looked at. */
#define COIN_PRIV_BLOCK 64

/* Twice what the 64 steps of a block can turn phi or psi by, and move the
 * centre by in radii.  A step turns phi by at most TURN_MAX, psi by at most
 * sqrt(2) |dt| W, and moves the centre by at most |dt| W: all by less than 2.
 */
#define COIN_PRIV_BLOCK_MOVES 256.0

#include "methods.t.h"

/* The methods in the order of their numbers, from 0.  A row has the number; the
 * name, which its function has too, coin_priv_rk4(); and two limits of |dt| W,
 * Eq. (47): beyond one a step is COIN_COARSE, beyond the other it is refused.
 *
 * Up to the first limit a step adds errors of at most 5e-4 (RK4), 2e-4 (RK8),
 * 3e-4 and 4e-6 (symplectic2 and 4), in radians, radii and parts of W:
 * docs/limits.md, test_step_law.  Beyond 1.2 a step of RK4 or RK8 may jump over
 * a whole pass near flat.  Up to the second limits of the symplectic methods
 * the series of their drift suffices. */
#define COIN_PRIV_METHODS(ROW)                                                 \
    ROW(COIN_RK4, rk4, 0.35, 1.2)                                              \
    ROW(COIN_RK8, rk8, 1, 1.2)                                                 \
    ROW(COIN_SYMPLECTIC2, symplectic2, 0.08, 1)                                \
    ROW(COIN_SYMPLECTIC4, symplectic4, 0.16, 1.4)

/* The two limits of each method. */
typedef struct coin_priv_reach {
    number coarse, refusal;
} coin_priv_reach;
#define COIN_PRIV_REACH(method, name, coarse, refusal) {K(coarse), K(refusal)},
static const coin_priv_reach coin_priv_reaches[] = {
    COIN_PRIV_METHODS(COIN_PRIV_REACH)};

/* Whether there is such a method.  Floats have RK4 alone. */
COIN_PRIV_INLINE int coin_priv_method_is_known(int32_t method)
{
#ifdef COIN_PRIV_FLOAT
    return method == COIN_RK4;
#else
    const size_t count = sizeof coin_priv_reaches / sizeof *coin_priv_reaches;
    return (size_t)method < count;
#endif
}

/* The limits of steps of dt.  All are refused if dt is not finite. */
COIN_PRIV_INLINE coin_priv_limits
coin_priv_limits_of(const coin_priv_constants *b, int32_t method, number dt)
{
    const coin_priv_reach reach = coin_priv_reaches[method];
    const number coarse = reach.coarse, most = reach.refusal;
    const number size = FABS(dt);
    const number kept = size < COIN_PRIV_DT_LEAST ? COIN_PRIV_DT_LEAST : size;
    const number over = 1 / (kept * kept);
    const coin_priv_limits limits = {
        b->g_a, coarse * coarse * over, most * most * over, b->a, 0, 0, 0,
    };
    return limits;
}

#endif
