/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/random.h"
#include "support/table.h"

#include "angles.h"

#include <math.h>

/* Distance to the next double away from 0. */
static double ulp(double x)
{
    return nextafter(fabs(x), INFINITY) - fabs(x);
}

/* The files hold value + low, which is exact. */
static double error_in_ulp(double got, double value, double low)
{
    return fabs((got - value) - low) / ulp(value);
}

TEST(both_are_within_one_ulp_up_to_2_to_the_20)
{
    struct table t;
    table_load(&t, "sincos.csv");
    for (size_t i = 0; i < t.rows; ++i) {
        const double x = table_at(&t, i, "x");
        const coin_priv_sc got = coin_priv_sincos(x);
        const double s = error_in_ulp(got.s, table_at(&t, i, "sin"),
                                      table_at(&t, i, "sin_low"));
        const double c = error_in_ulp(got.c, table_at(&t, i, "cos"),
                                      table_at(&t, i, "cos_low"));
        if (fabs(x) > 0x1p20)
            continue;
        check_note("x = %.17g", x);
        check_within(s, 0, 1);
        check_within(c, 0, 1);
    }
}

/* Beyond, the reduction still leaves an absolute error of rounding only. */
TEST(both_are_within_2_u_up_to_2_to_the_31)
{
    struct table t;
    size_t beyond = 0;
    table_load(&t, "sincos.csv");
    for (size_t i = 0; i < t.rows; ++i) {
        const double x = table_at(&t, i, "x");
        const coin_priv_sc got = coin_priv_sincos(x);
        beyond += fabs(x) > 0x1p20;
        check_note("x = %.17g", x);
        check_near(got.s - table_at(&t, i, "sin"), table_at(&t, i, "sin_low"),
                   2 * U);
        check_near(got.c - table_at(&t, i, "cos"), table_at(&t, i, "cos_low"),
                   2 * U);
    }
    check(beyond > 10);
}

/* libm's are within an ulp too, in every libm in use. */
TEST(both_agree_with_libm_to_2_ulp)
{
    struct random r = random_begin(2);
    for (int i = 0; i < 20000; ++i) {
        const double x = random_between(&r, -20, 20);
        const coin_priv_sc got = coin_priv_sincos(x);
        check_note("x = %.17g", x);
        check_near(got.s, sin(x), 2 * ulp(sin(x)));
        check_near(got.c, cos(x), 2 * ulp(cos(x)));
    }
}

TEST(sine_is_odd_and_cosine_even_bit_for_bit)
{
    struct random r = random_begin(3);
    for (int i = 0; i < 2000; ++i) {
        const double x = random_between(&r, 0, 1) * pow(2, i % 31);
        const coin_priv_sc a = coin_priv_sincos(x), b = coin_priv_sincos(-x);
        check_note("x = %.17g", x);
        check(a.s == -b.s && a.c == b.c);
    }
}

TEST(angles_that_are_no_numbers_give_nan)
{
    const double bad[] = {NAN, INFINITY, -INFINITY};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        const coin_priv_sc got = coin_priv_sincos(bad[i]);
        check_note("x = %g", bad[i]);
        check(isnan(got.s) && isnan(got.c));
    }
}

/* Beyond it callers have refused the angle. */
TEST(the_range_ends_at_2_to_the_31)
{
    for (int side = -1; side <= 1; side += 2) {
        const double x = side * 0x1p31;
        const coin_priv_sc got = coin_priv_sincos(x);
        check_near(got.s, (double)sinl(x), U);
        check_near(got.c, (double)cosl(x), U);
    }
}

TEST(half_pi_and_its_rest_are_right)
{
    /* cos(HALF_PI) = sin(rest) = rest to 3e-32. */
    const coin_priv_sc got = coin_priv_sincos(COIN_PRIV_HALF_PI);
    check_near(got.c, COIN_PRIV_HALF_PI_LOW, ulp(COIN_PRIV_HALF_PI_LOW));
    check(got.s == 1);
}

/* --------------------------------------------------------------- and back */
TEST(the_angle_of_a_pair_is_the_angle)
{
    struct random r = random_begin(47);
    for (int i = 0; i < 20000; ++i) {
        const double x = random_between(&r, -3.14159, 3.14159);
        const double small = x * pow(2, -i % 60);
        check_note("x = %.17g", x);
        /* 2^-52 up to pi/2; an ulp is twice that beyond. */
        check_near(coin_priv_angle(coin_priv_sincos(x)), x,
                   fabs(x) < 1.57 ? 2 * U : 4 * U);
        check_near(coin_priv_angle(coin_priv_sincos(small)), small,
                   4 * ulp(small));
    }
}

TEST(the_angle_knows_its_quadrant_and_the_axes)
{
    const double half_pi = COIN_PRIV_HALF_PI, r = sqrt(0.5);
    const struct {
        coin_priv_sc pair;
        double angle;
    } cases[] = {
        {{0, 1}, 0},
        {{r, r}, half_pi / 2},
        {{1, 0}, half_pi},
        {{r, -r}, 3 * (half_pi / 2)},
        {{0, -1}, 2 * half_pi},
        {{-r, -r}, -3 * (half_pi / 2)},
        {{-1, 0}, -half_pi},
        {{-r, r}, -half_pi / 2},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        check_note("case %zu", i);
        check_near(coin_priv_angle(cases[i].pair), cases[i].angle, 4 * U);
    }
}

TEST(the_angle_of_a_nan_is_nan)
{
    const coin_priv_sc none[] = {{NAN, 1}, {1, NAN}, {NAN, NAN}};
    for (size_t i = 0; i < 3; ++i)
        check(isnan(coin_priv_angle(none[i])));
}

/* ------------------------------------------------------------- hypotenuse */
TEST(the_hypotenuse_neither_over_nor_underflows)
{
    const double scales[] = {1, 0x1p1000, 0x1p-1000};
    for (size_t i = 0; i < 3; ++i) {
        const double k = scales[i];
        check_note("scale %g", k);
        check_near(coin_priv_hypot(3 * k, -4 * k) / k, 5, 8 * U);
        check_near(coin_priv_hypot(-4 * k, 3 * k) / k, 5, 8 * U);
        check(coin_priv_hypot(0, -k) == k && coin_priv_hypot(k, 0) == k);
    }
    check(coin_priv_hypot(0, 0) == 0);
}
