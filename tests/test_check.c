/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/random.h"

#include <math.h>

static int32_t bits(const coin_state *s, const coin_params *p, double dt,
                    double mu)
{
    return coin_check(s, p, COIN_RK4, dt, mu);
}

TEST(a_coin_slips_beyond_its_friction_coefficient)
{
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

TEST(a_coin_that_rolls_straight_needs_no_friction)
{
    const coin_params p = disc();
    coin_state s;
    check_status(coin_steady_roll(&s, &p, 5), COIN_OK);
    check_status(bits(&s, &p, 0, 0), COIN_OK);
}

/* ------------------------------------------------- a fall from upright rest */
/* M = a = g = 1, I_X = k; I_Z has no part in it. */
static coin_params body(double k)
{
    coin_params p;
    check_status(coin_params_body(&p, 1, 1, 1, k, 1.5 * k), COIN_OK);
    return p;
}

/* Where it leans by acos(c): Eq. (23). */
static coin_state fallen(double c, double k)
{
    const coin_state s = {.theta = acos(c), .wX = sqrt(2 * (1 - c) / (1 + k))};
    return s;
}

static int32_t bits_fallen(double c, double k, double mu)
{
    const coin_params p = body(k);
    const coin_state s = fallen(c, k);
    check_note("cos theta = %.15g, I_X/m = %.15g, mu = %.15g", c, k, mu);
    return bits(&s, &p, 0, mu);
}

/* Eq. (52): N < 0 just for |3c - 1| < sqrt(1 - 3k).  For the disc that is from
 * 60 degrees to 80.4059. */
TEST(a_falling_coin_lifts_off_where_the_normal_force_ends)
{
    for (int i = 1; i <= 16; ++i) {
        const double k = i / 48.0 - 1e-4, root = sqrt(1 - 3 * k);
        const double first = (1 + root) / 3, last = (1 - root) / 3;
        check_status(bits_fallen(first + 1e-12, k, INFINITY), COIN_OK);
        check_status(bits_fallen(first - 1e-12, k, INFINITY), COIN_LIFTS);
        check_status(bits_fallen(last + 1e-12, k, INFINITY), COIN_LIFTS);
        check_status(bits_fallen(last - 1e-12, k, INFINITY), COIN_OK);
    }
    const double first = acos(0.5) * 180 / acos(-1);
    const double last = acos(1.0 / 6) * 180 / acos(-1);
    check_near(first, 60, 1e-12);
    check_near(last, 80.4059317731, 1e-10);
    check_status(bits_fallen(0.5 - 1e-12, 0.25, INFINITY), COIN_LIFTS);
    check_status(bits_fallen(1.0 / 6 + 1e-12, 0.25, INFINITY), COIN_LIFTS);
    /* Without a normal force there is nothing to slip on. */
    check_status(bits_fallen(0.4, 0.25, 0), COIN_LIFTS);
    check_status(bits_fallen(0.6, 0.25, 0), COIN_SLIPS);
}

/* N is least at c = 1/3, and 0 there for I_X = M a^2/3. */
TEST(a_heavy_rim_never_lifts_off_in_such_a_fall)
{
    const double third = 1.0 / 3;
    check_status(bits_fallen(third, third - 1e-12, INFINITY), COIN_LIFTS);
    for (double k = third + 1e-12; k < 8; k = 1.5 * k)
        for (int i = 1; i < 300; ++i)
            check_status(bits_fallen(i / 300.0, k, INFINITY),
                         i < 3 ? COIN_NEARLY_FLAT : COIN_OK);
}

/* The friction it needs has a peak before it reverses at cos theta = 2/3, and
 * no bound where it lifts off: docs/physics.md, "Where rolling fails". */
TEST(a_falling_coin_slips_before_the_peak_of_its_friction)
{
    const struct {
        double k, degrees, mu;
    } peaks[] = {
        {0.25, 36.2095584929, 0.421574466749},
        {0.3125, 35.346231416, 0.381920336148},
        {0.5, 33.5573097619, 0.301511344578},
    };
    for (size_t i = 0; i < 3; ++i) {
        const double k = peaks[i].k, mu = peaks[i].mu;
        const double c = cos(peaks[i].degrees * acos(-1) / 180);
        check_near((6 * k + 9) * c * c - (2 * k + 12) * c + 4 - 3 * k, 0,
                   1e-11);
        check_status(bits_fallen(c, k, mu * (1 - 1e-11)), COIN_SLIPS);
        for (int n = 201; n < 300; ++n)
            check_status(bits_fallen(n / 300.0, k, mu * (1 + 1e-11)), COIN_OK);
        check_status(bits_fallen(2.0 / 3, k, 1e-12), COIN_OK);
    }
    /* Whatever mu, a disc slips before it lifts off. */
    for (double mu = 0.43; mu < 1e9; mu *= 10)
        check_status(bits_fallen(0.5 + 0.01 / mu, 0.25, mu), COIN_SLIPS);
}

/* Any body: upright N = M g - M a wX^2, whatever wY and wZ; wX = 1.5 does. */
TEST(upright_every_coin_lifts_off_that_leans_fast_enough)
{
    struct random r = random_begin(32);
    for (int i = 0; i < 300; ++i) {
        const coin_params p = random_coin(&r);
        const double unit = natural_time(&p);
        coin_state s = random_state(&r, &p, 1);
        s.theta = 0;
        for (int side = -1; side <= 1; side += 2) {
            s.wX = side * (1 - 1e-12) / unit;
            check_status(bits(&s, &p, 0, INFINITY), COIN_OK);
            s.wX = side * (1 + 1e-12) / unit;
            check_status(bits(&s, &p, 0, INFINITY), COIN_LIFTS);
            s.wX = side * 1.5 / unit;
            check_status(bits(&s, &p, 0, INFINITY), COIN_LIFTS);
        }
    }
    const coin_params p = disc();
    const coin_state s = {.wX = 1}; /* no term of N is rounded: it is 0 */
    check_status(bits(&s, &p, 0, INFINITY), COIN_LIFTS);
}

/* Eq. (53): N = M g in all of them, so that only friction counts. */
TEST(a_steady_motion_never_lifts_off_and_slips_below_its_mu)
{
    struct random r = random_begin(33);
    for (int i = 0; i < 400; ++i) {
        const coin_params p = random_coin(&r);
        const double w = 1 / natural_time(&p);
        const double theta = random_sized(&r, 1e-3, 1.4);
        const double wZ = random_between(&r, -2 * w, 2 * w);
        coin_state s = circle(&p, theta, wZ, i % 2 ? 1 : -1);
        const double mu =
            p.radius * fabs(s.wY * s.wZ) / (p.gravity * cos(theta));
        check_note("theta = %g, mu = %g", theta, mu);
        check_status(bits(&s, &p, 0, mu * (1 - 1e-10)), COIN_SLIPS);
        check_status(bits(&s, &p, 0, mu * (1 + 1e-10)), COIN_OK);
        check_status(coin_steady_spin(&s, &p, theta), COIN_OK);
        check_status(bits(&s, &p, 0, 1e-10), COIN_OK);
        check_status(coin_steady_upright_spin(&s, &p, 100 * wZ), COIN_OK);
        check_status(bits(&s, &p, 0, 0), COIN_OK);
    }
}

/* ---------------------------------------------------------- the other bits */
TEST(a_coin_is_nearly_flat_below_a_cosine_of_0_01)
{
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

TEST(warnings_come_together)
{
    const coin_params p = disc();
    const coin_state pressed = {1.565, 0, 0, 0, 0, 0, 0.5, 0.5};
    const coin_state lifted = {1.565, 0, 0, 0, 0, 0, 0.5, -40};
    const int32_t both = COIN_COARSE | COIN_NEARLY_FLAT;
    check_status(bits(&pressed, &p, 1, 0.1), COIN_SLIPS | both);
    check_status(bits(&lifted, &p, 1, 0.1), COIN_LIFTS | both);
}

TEST(bad_arguments_are_refused_in_order)
{
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
