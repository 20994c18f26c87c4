/* SPDX-License-Identifier: MIT */
/* A way that takes more trials of steps than one call may make: calls of few
 * trials, by what coin_move() calls. */
#include "support/check.h"
#include "support/coins.h"
#include "support/thrown.h"

#include <math.h>

/* A body in natural units on a table, before a call of so many trials. */
static coin_priv_moving begun(const coin_body *b, const coin_table *f,
                              double time, int tries)
{
    const coin_params p = thrown_params(0.25, 0.5);
    coin_priv_moving g;
    coin_priv_constants of;
    check_status(coin_priv_check_coin_body(&g.c, b, &p, &of), COIN_OK);
    check_status(coin_priv_table_law(&g.law, f, &of, 0), COIN_OK);
    coin_priv_begin_call(&g, time, 1e-3, tries);
    return g;
}

/* With one trial more each time: the call says COIN_MORE, or the last word. */
static void suffices(const coin_body *b, const coin_table *f, double time,
                     int32_t last)
{
    double before = 0;
    int tries = 0;
    int32_t status = COIN_MORE;
    for (; status & COIN_MORE && tries < 1000; ++tries) {
        coin_priv_moving g = begun(b, f, time, tries);
        status = coin_priv_go_on(&g);
        check_note("trials %d", tries);
        check(g.moved.sum >= before);
        check(!(status & COIN_MORE && status & COIN_RESTS));
        check(!(status & COIN_MORE) || g.moved.sum < time);
        before = g.moved.sum;
    }
    check(tries > 8);
    check_status(status, last);
}

TEST(a_call_says_more_only_where_its_trials_do_not_suffice)
{
    const coin_body falls = {.s = {.theta = 0.9, .wX = 0.5}, .y = 1.5};
    const coin_body high = {.s = {.wZ = 1}, .y = 2};
    const coin_table ball = {.mu_kinetic = 0, .restitution = 1};
    coin_table felt = {.mu_static = 0.4, .mu_kinetic = 0.3};
    felt.losses.flat = 1e-2;
    for (double time = 20; time < 30; ++time)
        suffices(&high, &ball, time, COIN_LIFTS);
    for (int i = 0; i < 4; ++i) {
        felt.restitution = 0.05 * i;
        suffices(&falls, &felt, 50, COIN_RESTS);
    }
}

/* A ball that bounces for ever: 11,000 flights and impacts. */
TEST(a_call_of_too_many_bounces_says_how_far_it_came)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_kinetic = 0, .restitution = 1};
    coin_body b = {.s = {.wZ = 1}, .y = 1.5}, same = b;
    double reached, again;
    check_status(coin_move(&b, &p, &f, INFINITY, 1e-6, 0, &reached),
                 COIN_LIFTS | COIN_MORE);
    check_near(reached, 5499.5 * 2, 5);
    check_status(coin_move(&same, &p, &f, reached, 1e-6, 0, &again),
                 COIN_LIFTS);
    check(again == reached);
    check_same(&same, &b, sizeof b);
}
