/* SPDX-License-Identifier: MIT */
/* Where the quasi-steady model has no answer. */
#include "support/check.h"
#include "support/coins.h"

#include <math.h>

#define HALF_PI 1.5707963267948966

static const coin_losses dry = {.dry = 1e-3};
static const coin_losses viscous = {.viscous = 1e-3};

static coin_state spin(const coin_params *p, double angle)
{
    coin_state s;
    check_status(coin_steady_spin(&s, p, HALF_PI - angle), COIN_OK);
    return s;
}

static void without_a_loss_that_stops_it_the_time_is_infinite(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses none = {0}, turn = {.spin = 0.01};
    const coin_state s = spin(&p, 0.5);
    coin_state up, out, want;
    check(coin_time_to_rest(&s, &p, &none) == (double)INFINITY);
    check(coin_time_to_rest(&s, &p, &turn) == (double)INFINITY);
    check_status(coin_steady_upright_spin(&up, &p, 3), COIN_OK);
    check(coin_time_to_rest(&up, &p, &dry) == (double)INFINITY);
    const coin_losses both = {.dry = 1e-3, .spin = 0.01};
    check(coin_time_to_rest(&up, &p, &both) != (double)INFINITY);
    /* And then the motion is a steady one for ever. */
    check_status(coin_quasisteady_at(&up, &p, &dry, 1e3, &out), COIN_OK);
    check_status(coin_steady_at(&up, &p, 1e3, &want), COIN_OK);
    check_same(&out, &want, sizeof out);
    /* By pivoting alone the coin comes to a circle that has none. */
    check_status(coin_quasisteady_at(&s, &p, &turn, 1e7, &out), COIN_OK);
    check_near(out.wY * cos(out.theta), out.wZ * sin(out.theta), 1e-6);
}

static void a_roll_that_slows_becomes_unstable(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = viscous;
    coin_state s, out = {.phi = 7};
    check_status(coin_steady_roll(&s, &p, 2), COIN_OK);
    /* wZ = 2 exp(-m t/K) reaches the critical rate. */
    const double edge = 1.5 / 1e-3 * log(2 / coin_critical_roll(&p));
    check(isnan(coin_time_to_rest(&s, &p, &l)));
    check_status(coin_quasisteady_at(&s, &p, &l, edge * 0.999, &out), COIN_OK);
    out.phi = 7;
    check_status(coin_quasisteady_at(&s, &p, &l, edge * 1.001, &out),
                 COIN_EDOMAIN);
    check(out.phi == 7);
}

static void a_state_that_swings_or_is_unstable_is_refused(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    coin_losses l = dry;
    const coin_losses before = l;
    coin_state s = spin(&p, 0.3), out = {.phi = 7};
    s.theta += 0.02; /* of 0.3 */
    check(coin_time_to_rest(&s, &p, &l) > 0);
    s.theta -= 0.22;
    check(isnan(coin_time_to_rest(&s, &p, &l)));
    s = spin(&p, 0.3);
    s.wX = 0.1;
    check(isnan(coin_time_to_rest(&s, &p, &l)));
    check_status(coin_quasisteady_at(&s, &p, &l, 1, &out), COIN_EDOMAIN);
    check_status(coin_losses_fit(&l, &s, &p, 8), COIN_EDOMAIN);
    check_status(coin_steady_roll(&s, &p, 0.1), COIN_OK);
    const coin_losses none = {0};
    check(isnan(coin_time_to_rest(&s, &p, &none)));
    check_status(coin_quasisteady_at(&s, &p, &l, 1, &out), COIN_EDOMAIN);
    s = (coin_state){.theta = 0.3}; /* falls on its side */
    check_status(coin_quasisteady_at(&s, &p, &l, 1, &out), COIN_EDOMAIN);
    s = (coin_state){.theta = 1.570796, .wZ = 0.3}; /* falls, next to flat */
    check_status(coin_quasisteady_at(&s, &p, &l, 1, &out), COIN_EDOMAIN);
    s = (coin_state){.theta = -0.289, .wX = -0.0025, .wZ = -0.0077};
    s.wY = -0.0053; /* far from a roll that is unstable */
    check_status(coin_quasisteady_at(&s, &p, &l, 1, &out), COIN_EDOMAIN);
    check(out.phi == 7);
    check_same(&l, &before, sizeof l);
}

/* An absurdly fast spin, which friction hardly slows. */
static void a_motion_of_too_many_steps_is_refused(void **unused)
{
    (void)unused;
    check_million();
    coin_params p;
    coin_state s, out;
    const coin_losses l = {.viscous = 0x1.6c45707bd991p-64,
                           .layer = 0x1.d83bf6a7e4f4ep-177,
                           .spin = 0x1.030ca69ef3ad4p+1,
                           .soft = 0x1.356ae898352f1p-6};
    check_status(coin_params_disc(&p, 0x1.9b659b961047p+4, 0x1.486d016f0b85p-32,
                                  0x1.ca1ccc63f8173p-29),
                 COIN_OK);
    check_status(coin_steady_spin(&s, &p, 0x1.921e107914234p+0), COIN_OK);
    check(isnan(coin_time_to_rest(&s, &p, &l)));
    check_status(coin_quasisteady_at(&s, &p, &l, 1e300, &out), COIN_EDOMAIN);
}

static void at_rest_it_rests(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    coin_losses l = dry;
    coin_state s = spin(&p, 0.3), out;
    check_status(coin_settle(&s, &p, &l, 1e4, 1e-6, NULL), COIN_RESTS);
    check(coin_time_to_rest(&s, &p, &l) == 0);
    check_status(coin_quasisteady_at(&s, &p, &l, 1, &out), COIN_RESTS);
    check(out.theta == s.theta && out.wX == 0 && out.wZ == s.wZ);
    check_status(coin_losses_fit(&l, &s, &p, 8), COIN_EDOMAIN);
    s.wX = -1; /* it rises */
    check(isnan(coin_time_to_rest(&s, &p, &l)));
    check_status(coin_quasisteady_at(&s, &p, &l, 1, &out), COIN_EDOMAIN);
}

/* -------------------------------------------------------------------- errors
 */
static void a_heading_out_of_range_is_refused(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.viscous = 1e-9};
    coin_state s = spin(&p, 0.3), out = {.phi = 7};
    s.phi = 0x1p31 - 5;
    check_status(coin_quasisteady_at(&s, &p, &l, 100, &out), COIN_ESTEP);
    check(out.phi == 7);
}

static void a_fit_beyond_the_range_of_losses_is_refused(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    coin_losses l = {.dry = 1e59};
    const coin_losses before = l;
    const coin_state s = spin(&p, 0.3);
    check_status(coin_losses_fit(&l, &s, &p, 1e-100), COIN_EDOMAIN);
    check_same(&l, &before, sizeof l);
}

static void errors_come_in_their_order(void **unused)
{
    (void)unused;
    const coin_params good = disc();
    coin_params bad = good;
    bad.mass = -1;
    const coin_losses fine = dry, wrong = {.dry = -1};
    coin_losses l = fine;
    const coin_state s = spin(&good, 0.3), flat = {.theta = 2};
    coin_state out = {.phi = 7};
    const coin_state swings = {.theta = 0.3};
    check_status(coin_quasisteady_at(&flat, &bad, &wrong, NAN, NULL),
                 COIN_EARG);
    check_status(coin_quasisteady_at(NULL, &bad, &wrong, NAN, &out), COIN_EARG);
    check_status(coin_quasisteady_at(&flat, NULL, &wrong, NAN, &out),
                 COIN_EARG);
    check_status(coin_quasisteady_at(&flat, &bad, NULL, NAN, &out), COIN_EARG);
    check_status(coin_quasisteady_at(&flat, &bad, &fine, NAN, &out),
                 COIN_EPARAMS);
    check_status(coin_quasisteady_at(&flat, &good, &wrong, NAN, &out),
                 COIN_EPARAMS);
    check_status(coin_quasisteady_at(&flat, &good, &fine, NAN, &out),
                 COIN_ESTATE);
    const double times[] = {NAN, -1, INFINITY};
    for (int i = 0; i < 3; ++i)
        check_status(coin_quasisteady_at(&swings, &good, &fine, times[i], &out),
                     COIN_ESTEP);
    check_status(coin_quasisteady_at(&swings, &good, &fine, 1, &out),
                 COIN_EDOMAIN);
    check(out.phi == 7);
    check(isnan(coin_time_to_rest(NULL, &good, &fine)));
    check(isnan(coin_time_to_rest(&s, NULL, &fine)));
    check(isnan(coin_time_to_rest(&s, &good, NULL)));
    check(isnan(coin_time_to_rest(&s, &bad, &fine)));
    check(isnan(coin_time_to_rest(&s, &good, &wrong)));
    check(isnan(coin_time_to_rest(&flat, &good, &fine)));
    const double bad_times[] = {0, -1, NAN, INFINITY};
    for (int i = 0; i < 4; ++i)
        check_status(coin_losses_fit(&l, &flat, &bad, bad_times[i]), COIN_EARG);
    check_status(coin_losses_fit(NULL, &s, &good, 1), COIN_EARG);
    check_status(coin_losses_fit(&l, &s, &bad, 1), COIN_EPARAMS);
    check_status(coin_losses_fit(&l, &flat, &good, 1), COIN_ESTATE);
    check_same(&l, &fine, sizeof l);
}

/* What counts is whether the steady motion rolls, not a state beside it. */
static void a_roll_that_stands_for_an_instant_is_lost_all_the_same(
    void **unused)
{
    (void)unused;
    const coin_params p = disc();
    coin_state s = {.theta = 0.072332763817316278,
                    .wY = 2.7330413371012741,
                    .wZ = -0.19803392713121115};
    coin_state moves = s, out, want;
    moves.wZ *= 1 + 1e-12;
    const double T = coin_time_to_rest(&s, &p, &dry);
    check_within(T, 1000, 2000);
    check_near(T, coin_time_to_rest(&moves, &p, &dry), 1e-6 * T);
    check_status(coin_quasisteady_at(&s, &p, &dry, 0.9 * T, &out), COIN_OK);
    check_status(coin_quasisteady_at(&moves, &p, &dry, 0.9 * T, &want),
                 COIN_OK);
    check_near(out.theta, want.theta, 1e-6);
}

static void near_to_flat_the_time_goes_by_the_law_too(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const double angles[] = {1e-4, 1e-7, 1e-8};
    for (int i = 0; i < 3; ++i) {
        const double c = angles[i];
        const coin_losses l = {.dry = c * sqrt(c) / 2};
        const coin_state s = spin(&p, c);
        check_near(coin_time_to_rest(&s, &p, &l), 1, 1e-6 + c);
    }
}

static void a_loss_that_would_be_subnormal_is_refused(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_state s = spin(&p, 0.2);
    coin_losses l = {.dry = 1e-20};
    check_status(coin_losses_fit(&l, &s, &p, 1e308), COIN_EDOMAIN);
    check(l.dry == 1e-20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(without_a_loss_that_stops_it_the_time_is_infinite),
        TEST(a_roll_that_slows_becomes_unstable),
        TEST(a_state_that_swings_or_is_unstable_is_refused),
        TEST(a_motion_of_too_many_steps_is_refused),
        TEST(at_rest_it_rests),
        TEST(a_heading_out_of_range_is_refused),
        TEST(a_fit_beyond_the_range_of_losses_is_refused),
        TEST(errors_come_in_their_order),
        TEST(near_to_flat_the_time_goes_by_the_law_too),
        TEST(a_roll_that_stands_for_an_instant_is_lost_all_the_same),
        TEST(a_loss_that_would_be_subnormal_is_refused),
    };
    return RUN_TESTS(tests);
}
