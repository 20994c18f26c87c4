/* SPDX-License-Identifier: MIT */
/* Events whose place is known in closed form. */
#include "support/check.h"
#include "support/random.h"

#include <math.h>

/* A disc that falls from upright: N/Mg = 1 - (4/5) (1 + 2 c - 3 c^2) is
 * negative from c = 1/2 to 1/6, up to what the start leans. */
static void a_falling_disc_lifts_where_its_energy_says(void **unused)
{
    (void)unused;
    coin_params p;
    coin_state s = {1e-6, 0, 0, 0, 0, 0, 0, 0};
    double reached;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    check_status(
        coin_advance_until(&s, &p, 100, 1e-11, INFINITY, COIN_LIFTS, &reached),
        COIN_LIFTS);
    check_near(cos(s.theta), 0.5, 1e-9);
    check(reached > 1);
    /* Held to the table it comes down on it again, where it would slip. */
    for (double mu = 1; mu < 1e7; mu *= 10) {
        coin_state on = s;
        check_status(
            coin_advance_until(&on, &p, 100, 1e-11, mu, COIN_SLIPS, &reached),
            COIN_SLIPS);
        check_near(cos(on.theta), 1.0 / 6, 1e-9);
    }
}

/* Slow in the end: cos(theta) = 0.01 is passed on the way down. */
static void nearly_flat_begins_at_a_hundredth(void **unused)
{
    (void)unused;
    coin_params p;
    for (double tol = 1e-12; tol < 1e-2; tol *= 10) {
        coin_state s = {0.3, 0, 0, 0, 0, 0, 0.001, 0.001};
        double reached;
        check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
        check_status(
            coin_advance_until(&s, &p, 100, tol, 1, COIN_NEARLY_FLAT, &reached),
            COIN_NEARLY_FLAT);
        check_near(cos(s.theta), 0.01, 2 * tol);
        check(cos(s.theta) < 0.01);
    }
}

/* Just before a fast pass, on the way to it and from it, in one long step. */
static void a_pass_within_a_step_is_found(void **unused)
{
    (void)unused;
    coin_params p;
    coin_state low = {0.3, 0, 0, 0, 0, 0, 0.004, 0.004};
    double reached;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    check_status(
        coin_advance_until(&low, &p, 100, 1e-12, 1, COIN_NEARLY_FLAT, NULL),
        COIN_NEARLY_FLAT);
    for (int i = 1; i < 100; ++i) {
        coin_state s = low;
        const double back = 0.002 * i;
        check_status(coin_advance(&s, &p, -back, 1e-12, NULL), COIN_OK);
        check_status(
            coin_advance_until(&s, &p, 1, 1e-2, 1, COIN_NEARLY_FLAT, &reached),
            COIN_NEARLY_FLAT);
        check_near(reached, back, 1e-2);
    }
}

/* tol is in natural units of time, which are a thousandth here. */
static void the_place_is_as_accurate_for_a_fast_coin(void **unused)
{
    (void)unused;
    coin_params p;
    for (double lean = 1e-6; lean < 1e-3; lean *= 1.5) {
        coin_state s = {lean, 0, 0, 0, 0, 0, 0, 0};
        check_status(coin_params_disc(&p, 1, 1e-3, 1e3), COIN_OK);
        check_status(
            coin_advance_until(&s, &p, 1, 1e-11, INFINITY, COIN_LIFTS, NULL),
            COIN_LIFTS);
        /* N/Mg as above, with the energy of the lean at the start. */
        const double c = cos(s.theta), top = cos(lean);
        check_near(1 - 0.8 * (1 + 2 * top * c - 3 * c * c), 0, 3e-7);
    }
}

/* F/N exceeds any mu where N goes to 0, if only for a moment. */
static void the_briefest_slip_before_it_lifts_is_found(void **unused)
{
    (void)unused;
    for (double mu = 10; mu < 1e10; mu *= 10) {
        coin_params p;
        coin_state s = {0.3, 0, 0, 0, 0, 1.2, 0.5, 0.5};
        coin_force f;
        check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
        check_status(coin_advance_until(&s, &p, 10, 1e-3, mu, COIN_SLIPS, NULL),
                     COIN_SLIPS);
        check_status(coin_reaction(&s, &p, &f), COIN_OK);
        check(f.normal > 0 && f.ratio > mu);
    }
}

/* Where N goes to 0 F/N exceeds every mu before; each search has steps of its
 * own. */
static void a_coin_slips_before_it_lifts_whatever_mu(void **unused)
{
    (void)unused;
    struct random r = random_begin(186);
    for (int lifted = 0; lifted < 300;) {
        const coin_params p = random_coin(&r);
        const coin_state start = random_state(&r, &p, 1.3);
        const double unit = natural_time(&p);
        const double mu = pow(10, random_between(&r, 0, 9));
        coin_state s = start;
        double lifts, slips;
        if (coin_advance_until(&s, &p, 2 * unit, 1e-9, 1, COIN_LIFTS, &lifts) !=
                COIN_LIFTS ||
            lifts == 0)
            continue;
        s = start;
        check_status(
            coin_advance_until(&s, &p, 2 * unit, 1e-6, mu, COIN_SLIPS, &slips),
            COIN_SLIPS);
        check(slips <= lifts + 1e-5 * unit);
        ++lifted;
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_falling_disc_lifts_where_its_energy_says),
        TEST(the_place_is_as_accurate_for_a_fast_coin),
        TEST(nearly_flat_begins_at_a_hundredth),
        TEST(a_pass_within_a_step_is_found),
        TEST(the_briefest_slip_before_it_lifts_is_found),
        TEST(a_coin_slips_before_it_lifts_whatever_mu),
    };
    return RUN_TESTS(tests);
}
