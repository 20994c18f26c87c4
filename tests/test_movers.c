/* SPDX-License-Identifier: MIT */
/* tests/studies/bench/movers.c, which every chart of steps rests on. */
#include "support/check.h"
#include "support/methods.h"

#include "studies/bench/movers.c"
#include "studies/bench/textbook.c"

/* A call that ends and one that begins round the angles, below 16 here, by a
 * few u. */
enum { CALLS = 200 };
#define BOUND (CALLS * 8 * U * 16)

TEST(as_many_calls_of_one_step_come_to_the_same_place)
{
    const coin_state s = {0.5, 0.1, 0.2, 0.3, 0.4, 0.1, 0.4, 0.9};
    coin_params disc;
    check_status(coin_params_disc(&disc, 1, 1, 1), COIN_OK);
    for (int kind = 0; kind < MOVERS; ++kind) {
        mover whole = mover_at((enum mover_kind)kind, &s, &disc, 0.04);
        mover parts = whole;
        check_note("%s", mover_name(whole.kind));
        check(mover_go(&whole, CALLS) == 0);
        for (int i = 0; i < CALLS; ++i)
            check(mover_go(&parts, 1) == 0);
        check(states_apart(&whole.s, &s, &disc) > 0.1);
        check_near(states_apart(&parts.s, &whole.s, &disc), 0, BOUND);
        check_near((double)(parts.t - whole.t), 0, BOUND);
    }
}
