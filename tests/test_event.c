/* SPDX-License-Identifier: MIT */
/* Events whose place is known in closed form, or by the signs of N. */
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

/* tol is in natural units of time, which are a thousandth here.  Where the coin
 * lifts off, N/Mg changes by 0.62 per natural unit. */
static void the_place_is_as_accurate_for_a_fast_coin(void **unused)
{
    (void)unused;
    const double tol = 1e-11;
    coin_params p;
    for (double lean = 1e-6; lean < 1e-3; lean *= 1.5) {
        coin_state s = {lean, 0, 0, 0, 0, 0, 0, 0};
        check_status(coin_params_disc(&p, 1, 1e-3, 1e3), COIN_OK);
        check_status(
            coin_advance_until(&s, &p, 1, tol, INFINITY, COIN_LIFTS, NULL),
            COIN_LIFTS);
        /* N/Mg as above, with the energy of the lean at the start. */
        const double c = cos(s.theta), top = cos(lean);
        check_near(1 - 0.8 * (1 + 2 * top * c - 3 * c * c), 0, tol);
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

/* The place where F/N exceeds a large mu is as narrow as 1/mu, and lies next to
 * where N = 0.  The signs of N show the moment of lift-off. */
static void lift_off_is_not_passed_over_whatever_mu_is(void **unused)
{
    (void)unused;
    static const struct {
        double theta, wX, wY, wZ, tol;
    } scenes[] = {
        {0x1.3b88ee61b28p-3, 0x1.5b534fe004cp-5, 0, 0, 1e-9},
        {-0x1.66ecf87d291p-3, -0x1.491cfebbb6c8p-1, 0, 0x1.2c2565801318p-3,
         1e-12},
        {0x1.9893138b40e8p-2, 0x1.92afba3d899p-1, 0, 0x1.0dedcbade7c4p-2,
         1e-10},
        {0x1.ba464717217p-3, -0x1.532cbff708a8p-1, 0, 0, 1e-9},
        {0x1.0caed430f5f8p-2, 0x1.2cae133ac578p-1, 0, 0, 1e-9},
        {-0x1.62dc7ed28a2p-1, -0x1.62523d3d8f74p-1, 0x1.8c6f6f5d3c54p-2,
         -0x1.a61b5c5ebd48p-3, 1e-10},
    };
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; ++i) {
        const coin_state start = {.theta = scenes[i].theta,
                                  .wX = scenes[i].wX,
                                  .wY = scenes[i].wY,
                                  .wZ = scenes[i].wZ};
        const double tol = scenes[i].tol;
        double lifts;
        coin_state s = start;
        check_status(
            coin_advance_until(&s, &p, 6, tol, INFINITY, COIN_LIFTS, &lifts),
            COIN_LIFTS);
        for (int side = -1; side <= 1; side += 2) {
            coin_force force;
            s = start;
            check_status(coin_advance(&s, &p, lifts + side * 1e-6, 1e-12, NULL),
                         COIN_OK);
            check_status(coin_reaction(&s, &p, &force), COIN_OK);
            check(side < 0 ? force.normal > 0 : force.normal < 0);
        }
        for (int k = 0; k < 8; ++k) {
            const double mu = k < 7 ? pow(10, 4 + k) : INFINITY;
            const int32_t first = k < 7 ? COIN_SLIPS : COIN_LIFTS;
            for (int32_t bits = first; bits <= 3; ++bits) {
                double reached;
                s = start;
                check_note("scene %d, mu %g, bits %d", (int)i, mu, bits);
                const int32_t is =
                    coin_advance_until(&s, &p, 6, tol, mu, bits, &reached);
                check(is > 0);
                check_within(reached, lifts - 30 / mu - 2 * tol,
                             lifts + 2 * tol + 1e-12);
            }
        }
    }
}

/* It begins in the air.  The slip begins where N comes from 0, and has ended
 * 1.4e-11 units later. */
static void the_first_moment_of_a_brief_slip_is_found(void **unused)
{
    (void)unused;
    coin_params p;
    const coin_state start = {.theta = 0x1.9d76b52161f1ep-1,
                              .wX = -0x1.fa644b7f604cep-1,
                              .wY = 0x1.c8673ac70a3c6p-2};
    coin_state s = start;
    coin_force force;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    check_status(coin_advance_until(&s, &p, 1, 1e-13, 2.5e10, COIN_SLIPS, NULL),
                 COIN_SLIPS);
    check_status(coin_reaction(&s, &p, &force), COIN_OK);
    check_within(force.normal, 0, 3e-13);
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
        TEST(lift_off_is_not_passed_over_whatever_mu_is),
        TEST(the_first_moment_of_a_brief_slip_is_found),
    };
    return RUN_TESTS(tests);
}
