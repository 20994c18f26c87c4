/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/observable.h"
#include "support/random.h"
#include "support/steadies.h"

#include <fenv.h>
#include <math.h>
#include <string.h>

/* ------------------------------------------------------------ the families */
TEST(circles_turn_as_the_reference_s)
{
    struct table t;
    table_load(&t, "circles.csv");
    for (size_t row = 0; row < t.rows; ++row) {
        const struct circle c = circle_at(&t, row);
        coin_state want = c.state;
        const coin_state s = circle(&c.params, c.theta, c.wZ, c.branch);
        check_terms(s.wY, c.wY, 8, fabs(c.wY));
        want.wY = s.wY;
        check_same(&s, &want, sizeof s);
    }
}

/* A wY^2 + B wY = C has two roots: their sum and product are Vieta's, and
 * f+ is the one with the plus before the root of Eq. (40). */
TEST(the_branches_are_the_two_roots)
{
    struct random r = random_begin(23);
    for (int i = 0; i < 500; ++i) {
        const coin_params p = random_coin(&r);
        const double w = 1 / natural_time(&p);
        const double theta = random_sized(&r, 1e-3, 1.5);
        const double wZ = random_between(&r, -2 * w, 2 * w);
        const double m = p.mass * p.radius * p.radius;
        const double A = p.inertia_X * tan(theta), B = (p.inertia_Z + m) * wZ;
        const double C = p.mass * p.gravity * p.radius * sin(theta);
        const double plus = circle(&p, theta, wZ, 1).wY;
        const double minus = circle(&p, theta, wZ, -1).wY;
        const double size = fabs(plus) + fabs(minus);
        check_note("theta = %g, wZ = %g", theta, wZ);
        check_near(plus + minus, -B / A, 16 * U * size);
        check_near(plus * minus, -C / A, 24 * U * fabs(plus * minus));
        check((plus - minus) * A > 0);
    }
}

TEST(the_branches_mirror_each_other_bit_for_bit)
{
    struct random r = random_begin(24);
    for (int i = 0; i < 500; ++i) {
        const coin_params p = random_coin(&r);
        const double w = 1 / natural_time(&p);
        const double theta = random_sized(&r, 1e-3, 1.5);
        const double wZ = random_between(&r, -2 * w, 2 * w);
        const int32_t branch = i % 2 ? 1 : -1;
        const double f = circle(&p, theta, wZ, branch).wY;
        check(f == -circle(&p, theta, -wZ, -branch).wY);
        check(f == circle(&p, -theta, -wZ, -branch).wY);
    }
}

/* Without roll the circle shrinks to a spin, either way round. */
TEST(without_roll_the_circles_are_the_two_spins)
{
    const coin_params p = disc();
    const double leans[] = {0.6, -0.6};
    for (size_t i = 0; i < 2; ++i)
        for (int32_t branch = -1; branch <= 1; branch += 2) {
            const double want = 2 * sqrt(cos(0.6)) * (i ? -branch : branch);
            check_note("theta = %g, branch %d", leans[i], (int)branch);
            check_near(circle(&p, leans[i], 0.0, branch).wY, want, 16 * U);
        }
}

/* wY -> M g a theta/(K wZ) for small theta: the textbook's root cancels to
 * nothing there. */
TEST(large_circles_do_not_cancel)
{
    const coin_params p = disc();
    const double K = 1.5;
    for (int e = 5; e <= 290; e += 15) {
        const double theta = pow(10, -e);
        const coin_state s = circle(&p, theta, 2, 1);
        check_note("theta = 1e-%d", e);
        /* The next order is theta^3. */
        check_near(s.wY, theta / (K * 2), (8 * U + theta * theta) * s.wY);
    }
}

TEST(spins_have_their_centre_at_rest)
{
    struct random r = random_begin(25);
    for (int i = 0; i < 200; ++i) {
        const coin_params p = random_coin(&r);
        const double theta = random_between(&r, -1.57, 1.57);
        const double w2 = p.mass * p.gravity * p.radius / p.inertia_X;
        coin_state s, want = {0};
        check_status(coin_steady_spin(&s, &p, theta), COIN_OK);
        want.theta = theta;
        want.wY = s.wY;
        check_same(&s, &want, sizeof s);
        check(s.wY > 0);
        check_near(s.wY, sqrt(w2 * cos(theta)), 8 * U * s.wY);
    }
}

TEST(upright_motions_have_any_rate_in_range)
{
    const coin_params p = disc();
    const double rates[] = {0, -3, 1e-300, 1e6};
    for (size_t i = 0; i < 4; ++i) {
        const coin_state roll = {0, 0, 0, 0, 0, 0, 0, rates[i]};
        const coin_state spin = {0, 0, 0, 0, 0, 0, rates[i], 0};
        coin_state s;
        check_status(coin_steady_roll(&s, &p, rates[i]), COIN_OK);
        check_same(&s, &roll, sizeof s);
        check_status(coin_steady_upright_spin(&s, &p, rates[i]), COIN_OK);
        check_same(&s, &spin, sizeof s);
    }
}

/* One of each family, drawn at random. */
static coin_state any_steady(struct random *r, const coin_params *p, int kind)
{
    const double w = 1 / natural_time(p);
    const double wZ = random_between(r, -2 * w, 2 * w);
    const double theta = random_between(r, -1.5, 1.5);
    coin_state s;
    if (kind == 0)
        check_status(coin_steady_roll(&s, p, wZ), COIN_OK);
    else if (kind == 1)
        check_status(coin_steady_spin(&s, p, theta), COIN_OK);
    else if (kind == 2)
        check_status(coin_steady_upright_spin(&s, p, wZ), COIN_OK);
    else
        s = circle(p, theta, wZ, kind == 3 ? 1 : -1);
    return s;
}

TEST(no_rate_of_turning_changes_in_any_of_them)
{
    struct random r = random_begin(26);
    for (int i = 0; i < 500; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = any_steady(&r, &p, i % 5);
        coin_state rates;
        check_note("family %d, theta = %g", i % 5, s.theta);
        check_status(coin_rates(&s, &p, &rates), COIN_OK);
        check(rates.theta == 0 && rates.wY == 0 && rates.wZ == 0);
        /* 8 u of wY, which enters squared, and 8 u of the rates. */
        check_near(rates.wX, 0, 24 * U * parts_of(&s, &p).dwX);
    }
}

/* ----------------------------------------------------------------- radii */
TEST(radii_are_the_reference_s)
{
    struct table t;
    table_load(&t, "circles.csv");
    for (size_t row = 0; row < t.rows; ++row) {
        const struct circle c = circle_at(&t, row);
        double center, contact;
        check_status(coin_steady_radii(&c.state, &c.params, &center, &contact),
                     COIN_OK);
        const double R_G = table_at(&t, row, "R_G");
        check_terms(center, R_G, 8, R_G);
        check_terms(contact, table_at(&t, row, "R_C"), 8,
                    R_G + c.params.radius * fabs(sin(c.theta)));
    }
}

TEST(straight_and_resting_motions_have_plain_radii)
{
    const coin_params p = disc();
    double center, contact;
    coin_state s;
    check_status(coin_steady_roll(&s, &p, 3), COIN_OK);
    check_status(coin_steady_radii(&s, &p, &center, &contact), COIN_OK);
    check(isinf(center) && center > 0 && isinf(contact) && contact > 0);
    check_status(coin_steady_roll(&s, &p, 0), COIN_OK);
    check_status(coin_steady_radii(&s, &p, &center, &contact), COIN_OK);
    check(isinf(center) && isinf(contact));
    check_status(coin_steady_spin(&s, &p, -0.6), COIN_OK);
    check_status(coin_steady_radii(&s, &p, &center, &contact), COIN_OK);
    check(center == 0);
    check_near(contact, sin(0.6), 4 * U);
    check_status(coin_steady_upright_spin(&s, &p, 3), COIN_OK);
    check_status(coin_steady_radii(&s, &p, &center, &contact), COIN_OK);
    check(center == 0 && contact == 0);
}

TEST(circles_of_1e9_a_and_more_count_as_straight)
{
    coin_params p;
    coin_state s;
    double center, contact;
    check_status(coin_params_disc(&p, 1, 1e15, 1e15), COIN_OK);
    check_status(coin_steady_turn(&s, &p, 0.3, 0.999e24), COIN_OK);
    check_status(coin_steady_radii(&s, &p, &center, &contact), COIN_OK);
    check_near(center, 0.999e24, 16 * U * center);
    for (double wY = 0.5e-9; wY > 1e-310; wY /= 3) {
        const coin_state upright = {.wY = wY, .wZ = 1};
        check_note("wY = %g", wY);
        feclearexcept(FE_ALL_EXCEPT);
        check_status(coin_steady_radii(&upright, &p, &center, &contact),
                     COIN_OK);
        check(!fetestexcept(FE_OVERFLOW));
        check(isinf(center) && isinf(contact));
    }
}

/* ---------------------------------------------------------- what is steady */
static int32_t radii_status(const coin_state *s, const coin_params *p)
{
    double center = 1, contact = 2;
    const int32_t status = coin_steady_radii(s, p, &center, &contact);
    check(status >= 0 || (center == 1 && contact == 2));
    return status;
}

/* Off by part * 1e-9 in the quantity named. */
TEST(deviations_up_to_1e_9_of_the_largest_are_steady)
{
    const coin_params p = disc();
    const coin_state good = circle(&p, 0.4, 1, 1);
    /* The slope of Eq. (39) in wY; its largest term is M g a = 1.  The
     * largest rate is wZ = sqrt(g/a) = 1. */
    const double slope = 1.5 + 2 * 0.25 * good.wY * tan(0.4);
    for (int sign = -1; sign <= 1; sign += 2) {
        coin_state s = good;
        s.wX = sign * 0.999e-9;
        check_status(radii_status(&s, &p), COIN_OK);
        s.wX = sign * 1.001e-9;
        check_status(radii_status(&s, &p), COIN_EDOMAIN);
        s = good;
        s.wY += sign * 0.999e-9 / slope;
        check_status(radii_status(&s, &p), COIN_OK);
        s.wY = good.wY + sign * 1.001e-9 / slope;
        check_status(radii_status(&s, &p), COIN_EDOMAIN);
    }
}

/* Each of |wY|, |wZ|, sqrt(g/a) can be the largest rate, and each term of Eq.
 * (39) the largest torque. */
TEST(any_rate_or_torque_may_be_the_largest)
{
    const coin_params p = disc();
    const coin_state states[] = {
        {0, 0, 0, 0, 0, 0, 1e3, 0},
        {0, 0, 0, 0, 0, 0, 0, 1e3},
        circle(&p, 0.4, 1e3, -1),
    };
    for (size_t i = 0; i < 3; ++i) {
        coin_state s = states[i];
        const double w = fmax(fabs(s.wY), fabs(s.wZ));
        check_note("state %zu", i);
        s.wX = 0.999e-9 * w;
        check_status(radii_status(&s, &p), COIN_OK);
        s.wX = 1.001e-9 * w;
        check_status(radii_status(&s, &p), COIN_EDOMAIN);
    }
    /* On the fast branch both large terms are wY (K wZ) and its opposite. */
    coin_state s = states[2];
    s.wY *= 1 + 0.999e-9;
    check_status(radii_status(&s, &p), COIN_OK);
    s.wY = states[2].wY * (1 + 1.001e-9);
    check_status(radii_status(&s, &p), COIN_EDOMAIN);
}

/* ---------------------------------------------------------------- refusals */
TEST(bad_arguments_are_refused_in_order)
{
    const coin_params good = disc();
    coin_params bad = good;
    bad.mass = -1;
    const struct {
        const coin_params *p;
        double theta, wZ;
        int32_t branch, want;
    } cases[] = {
        {&bad, 0, NAN, 0, COIN_EARG},
        {&bad, 0, NAN, 2, COIN_EARG},
        {&good, 0.3, 1, -2, COIN_EARG},
        {&bad, 0, NAN, 1, COIN_EPARAMS},
        {&good, 0, NAN, 1, COIN_ESTATE},
        {&good, NAN, 1, 1, COIN_ESTATE},
        {&good, 1.5708, 1, 1, COIN_ESTATE},
        {&good, -2, 1, -1, COIN_ESTATE},
        {&good, 0.3, INFINITY, 1, COIN_ESTATE},
        {&good, 0.3, 1e200, 1, COIN_ESTATE},
        {&good, 1e-290, 1, -1, COIN_ESTATE}, /* wY = -6e290 */
        {&good, 5e-324, 0, 1, COIN_EDOMAIN}, /* wY is 0/0 */
        {&good, 0, 1, 1, COIN_EDOMAIN},
        {&good, -0.0, 1, -1, COIN_EDOMAIN},
    };
    const coin_state before = {1, 2, 3, 4, 5, 6, 7, 8};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coin_state s = before;
        check_note("case %zu", i);
        check_status(coin_steady_circle(&s, cases[i].p, cases[i].theta,
                                        cases[i].wZ, cases[i].branch),
                     cases[i].want);
        check_same(&s, &before, sizeof s);
    }
}

TEST(rates_and_leans_out_of_range_are_refused)
{
    const coin_params p = disc();
    const double rates[] = {NAN, INFINITY, -INFINITY, 1e200};
    const double leans[] = {NAN, INFINITY, 1.5707963267948966, -1.6};
    const coin_state before = {1, 2, 3, 4, 5, 6, 7, 8};
    for (size_t i = 0; i < 4; ++i) {
        coin_state s = before;
        check_note("case %zu", i);
        check_status(coin_steady_roll(&s, &p, rates[i]), COIN_ESTATE);
        check_status(coin_steady_upright_spin(&s, &p, rates[i]), COIN_ESTATE);
        check_status(coin_steady_spin(&s, &p, leans[i]), COIN_ESTATE);
        check_same(&s, &before, sizeof s);
    }
}
