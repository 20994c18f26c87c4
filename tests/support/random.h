/* SPDX-License-Identifier: MIT */
/* Random coins and states.  The seed is in the note of a failing check; set
 * ROLLCOIN_SEED to try another.  ROLLCOIN_TRIES is how many times as many cases
 * are tried as usual. */
#ifndef ROLLCOIN_TESTS_RANDOM_H
#define ROLLCOIN_TESTS_RANDOM_H

#include <coin.h>

struct random {
    uint64_t seed, state;
    unsigned drawn; /* how many scenes */
};

struct random random_begin(uint64_t seed);

int tries_asked(int usual);

/* Whether that is more than once: then no case of a list is left out. */
int all_asked(void);

double random_between(struct random *r, double low, double high);

/* Of either sign, its size between these. */
double random_sized(struct random *r, double least, double most);

/* Mass, radius and gravity within six decades each; any inner radius. */
coin_params random_coin(struct random *r);

/* |theta| <= theta_max, rates up to 2 in natural units, any pose; notes the
 * case. */
coin_state random_state(struct random *r, const coin_params *p,
                        double theta_max);

/* A random state, |theta| <= 1, from which `steps` steps of dt natural units
 * have full accuracy, forward and backward: the motion has no near-flat pass.
 */
coin_state random_motion(struct random *r, const coin_params *p, double dt,
                         uint64_t steps);

/* sqrt(radius/gravity). */
double natural_time(const coin_params *p);

#endif
