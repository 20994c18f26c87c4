/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/random.h"

#include <math.h>

/* The limit of full accuracy of COIN_RK4, docs/guide.md. */
#define RK4_COARSE 0.35

static int32_t bits(const coin_state *s, const coin_params *p, double dt,
                    double mu)
{
    return coin_check(s, p, COIN_RK4, dt, mu);
}

static void a_coin_slips_beyond_its_friction_coefficient(void **unused)
{
    (void)unused;
    struct random r = random_begin(30);
    unsigned pressed = 0;
    for (int i = 0; i < 300; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.2);
        coin_force f;
        check_status(coin_reaction(&s, &p, &f), COIN_OK);
        if (!(f.normal > 0))
            continue;
        ++pressed;
        check_status(bits(&s, &p, 0, f.ratio * (1 - 1e-12)), COIN_SLIPS);
        check_status(bits(&s, &p, 0, f.ratio * (1 + 1e-12)), COIN_OK);
        check_status(bits(&s, &p, 0, 0), COIN_SLIPS);
        check_status(bits(&s, &p, 0, INFINITY), COIN_OK);
    }
    check_within(pressed, 50, 299);
}

static void a_coin_that_rolls_straight_needs_no_friction(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    coin_state s;
    check_status(coin_steady_roll(&s, &p, 5), COIN_OK);
    check_status(bits(&s, &p, 0, 0), COIN_OK);
}

/* Falling from upright at rest, N changes sign at 60 degrees and again at
 * cos theta = 1/6. */
static void a_coin_lifts_off_where_the_normal_force_ends(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const struct {
        double cosine;
        int32_t want;
    } cases[] = {
        {0.5 * (1 + 1e-12), COIN_OK},
        {0.5 * (1 - 1e-12), COIN_LIFTS},
        {1.0 / 6 * (1 + 1e-12), COIN_LIFTS},
        {1.0 / 6 * (1 - 1e-12), COIN_OK},
    };
    for (size_t i = 0; i < 4; ++i) {
        const double c = cases[i].cosine, wX = sqrt(1.6 * (1 - c));
        const coin_state s = {acos(c), 0, 0, 0, 0, wX, 0, 0};
        check_note("cos theta = %.15g", c);
        check_status(bits(&s, &p, 0, INFINITY), cases[i].want);
        /* Without a normal force there is nothing to slip on. */
        check_status(bits(&s, &p, 0, 0),
                     cases[i].want ? COIN_LIFTS : COIN_SLIPS);
    }
}

static void a_step_is_coarse_beyond_the_method_s_limit(void **unused)
{
    (void)unused;
    struct random r = random_begin(31);
    for (int i = 0; i < 300; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.2);
        const double dt = RK4_COARSE / fastest_rate(&s, &p);
        const int32_t fine = bits(&s, &p, 0, INFINITY);
        for (int sign = -1; sign <= 1; sign += 2) {
            check_status(bits(&s, &p, sign * dt * (1 - 1e-12), INFINITY), fine);
            check_status(bits(&s, &p, sign * dt * (1 + 1e-12), INFINITY),
                         fine | COIN_COARSE);
            check_status(bits(&s, &p, sign * 1e300, INFINITY),
                         fine | COIN_COARSE);
        }
        check_status(bits(&s, &p, 1e-320, INFINITY), fine);
    }
}

/* With a step so short that the state hardly moves, a run warns exactly if
 * the check does. */
static void a_step_says_the_same(void **unused)
{
    (void)unused;
    coin_params p = disc();
    for (int i = -1; i <= 1; i += 2) {
        coin_state s;
        check_status(coin_steady_spin(&s, &p, 0.6), COIN_OK);
        const double dt = RK4_COARSE / fastest_rate(&s, &p) * (1 + i * 1e-12);
        const int32_t want = i > 0 ? COIN_COARSE : COIN_OK;
        check_status(bits(&s, &p, dt, INFINITY), want);
        check_status(coin_step(&s, &p, dt), want);
    }
}

static void a_coin_is_nearly_flat_below_a_cosine_of_0_01(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    for (int side = -1; side <= 1; side += 2) {
        const coin_state low = {
            side * acos(0.01 * (1 - 1e-12)), 0, 0, 0, 0, 0, 0, 0};
        const coin_state high = {
            side * acos(0.01 * (1 + 1e-12)), 0, 0, 0, 0, 0, 0, 0};
        check_status(bits(&low, &p, 0, INFINITY), COIN_NEARLY_FLAT);
        check_status(bits(&high, &p, 0, INFINITY), COIN_OK);
    }
}

static void warnings_come_together(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_state pressed = {1.565, 0, 0, 0, 0, 0, 0.5, 0.5};
    const coin_state lifted = {1.565, 0, 0, 0, 0, 0, 0.5, -40};
    const int32_t both = COIN_COARSE | COIN_NEARLY_FLAT;
    check_status(bits(&pressed, &p, 1, 0.1), COIN_SLIPS | both);
    check_status(bits(&lifted, &p, 1, 0.1), COIN_LIFTS | both);
}

static void the_bad_are_refused_in_order(void **unused)
{
    (void)unused;
    const coin_params good = disc();
    coin_params bad = good;
    bad.radius = 0;
    const coin_state fine = {0.5, 0, 0, 0, 0, 1, 1, 1};
    const coin_state flat = {2, 0, 0, 0, 0, 1, 1, 1};
    const struct {
        const coin_state *s;
        const coin_params *p;
        int32_t method;
        double dt, mu;
        int32_t want;
    } cases[] = {
        {&flat, &bad, -1, NAN, 1, COIN_EARG},
        {&flat, &bad, 99, NAN, 1, COIN_EARG},
        {&flat, &bad, COIN_RK4, NAN, -1e-300, COIN_EARG},
        {&flat, &bad, COIN_RK4, NAN, -INFINITY, COIN_EARG},
        {&flat, &bad, COIN_RK4, NAN, NAN, COIN_EARG},
        {&flat, &bad, COIN_RK4, NAN, 1, COIN_EPARAMS},
        {&flat, &good, COIN_RK4, NAN, 1, COIN_ESTATE},
        {&fine, &good, COIN_RK4, NAN, 1, COIN_ESTEP},
        {&fine, &good, COIN_RK4, INFINITY, 1, COIN_ESTEP},
        {&fine, &good, COIN_RK4, -INFINITY, 1, COIN_ESTEP},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        check_note("case %zu", i);
        check_status(coin_check(cases[i].s, cases[i].p, cases[i].method,
                                cases[i].dt, cases[i].mu),
                     cases[i].want);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_coin_slips_beyond_its_friction_coefficient),
        TEST(a_coin_that_rolls_straight_needs_no_friction),
        TEST(a_coin_lifts_off_where_the_normal_force_ends),
        TEST(a_step_is_coarse_beyond_the_method_s_limit),
        TEST(a_step_says_the_same),
        TEST(a_coin_is_nearly_flat_below_a_cosine_of_0_01),
        TEST(warnings_come_together),
        TEST(the_bad_are_refused_in_order),
    };
    return RUN_TESTS(tests);
}
