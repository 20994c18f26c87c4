/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/observable.h"
#include "support/random.h"

#include <math.h>

static void values(const coin_state *s, const coin_params *p, double *out)
{
    out[0] = coin_fastest_rate(s, p);
}

/* All terms of W^2 are positive: W itself is their size. */
static void terms(const coin_state *s, const coin_params *p, double *out)
{
    const struct parts r = parts_of(s, p);
    const double turn = hypot(hypot(r.wX, r.wY) / r.cth, r.wZ);
    out[0] = hypot(turn, sqrt(r.g / (r.a * r.cth)));
}

static const struct observable rate = {values, terms, 4, {"W"}};

TEST(the_fastest_rate_is_the_reference_s)
{
    observable_at_exact_states(&rate);
}

/* What coin.h says of COIN_COARSE holds for the W that this function gives. */
TEST(steps_are_coarse_beyond_the_limits_over_it)
{
    static const double limits[] = {0.35, 1, 0.08, 0.16};
    struct random r = random_begin(31);
    for (int i = 0; i < 400; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.5);
        const double dt = (i & 4 ? -limits[i % 4] : limits[i % 4]) /
                          coin_fastest_rate(&s, &p);
        const double mu = INFINITY;
        check((coin_check(&s, &p, i % 4, dt * (1 - 8 * U), mu) & COIN_COARSE) ==
              0);
        check(coin_check(&s, &p, i % 4, dt * (1 + 8 * U), mu) & COIN_COARSE);
    }
}

/* Straight rolling at wZ: sqrt(wZ^2 + g/a). */
TEST(it_is_known_of_an_upright_coin)
{
    coin_params p;
    const coin_state s = {0, 1, 2, 3, 4, 0, 0, 4};
    check_status(coin_params_disc(&p, 7, 0.5, 4.5), COIN_OK);
    check(coin_fastest_rate(&s, &p) == 5);
}
