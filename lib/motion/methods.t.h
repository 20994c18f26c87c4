/* SPDX-License-Identifier: MIT */
/* Whether a step is made, and whether it is COIN_COARSE. */
#include "equations.h"

#include "kind.h"

/* Limits of W^2 in a run: COIN_COARSE beyond coarse2, COIN_ESTEP beyond most2,
 * both compared where each step begins and ends.  And what the limit of its
 * path needs: the radius, and where the path starts. */
typedef struct coin_priv_limits {
    number g_a, coarse2, most2; /* coarse2 <= most2 */
    number a, x, z;
    integer coarse; /* all ones once a step was COIN_COARSE */
} coin_priv_limits;

/* Whether W^2 allows a step from *y.  Notes if the step is COIN_COARSE.  NaN
 * allows none. */
COIN_PRIV_INLINE integer coin_priv_admit_start(coin_priv_limits *limits,
                                               const coin_priv_variables *y)
{
    const number rate2 = coin_priv_rate2(limits->g_a, y);
    limits->coarse |= ~coin_priv_truth(rate2 <= limits->coarse2);
    return coin_priv_truth(rate2 <= limits->most2);
}

/* Whether a step is made, by what is known where it ends.  It is refused if
 * admit_start() refuses the next one from there, or if it turned lean or
 * heading by more than COIN_PRIV_TURN_MAX.  A step through the table needs no
 * test: if it begins at |dt| W = r, it ends near r/(r - 1), beyond the limit.
 */
COIN_PRIV_INLINE integer coin_priv_admit_step(coin_priv_limits *limits,
                                              const coin_priv_step_end *end,
                                              const coin_priv_variables *next)
{
    const number turn = coin_priv_magnitude(end->adds.theta);
    const number heading = coin_priv_magnitude(end->adds.phi);
    return coin_priv_truth(turn <= K(COIN_PRIV_TURN_MAX)) &
           coin_priv_truth(heading <= K(COIN_PRIV_TURN_MAX)) &
           coin_priv_admit_start(limits, next);
}

/* Whether a step is made for every coin.  One that ends with a W within the
 * coarse limit turns lean and heading by at most 1.2 rad, and stays above the
 * table: W is all that is computed then (test_step_law). */
COIN_PRIV_INLINE int coin_priv_admit_each(coin_priv_limits *limits,
                                          const coin_priv_step_end *end,
                                          const coin_priv_variables *next)
{
    const number rate2 = coin_priv_rate2(limits->g_a, next);
    return coin_priv_every(rate2 <= limits->coarse2) ||
           coin_priv_every(coin_priv_admit_step(limits, end, next) != 0);
}
