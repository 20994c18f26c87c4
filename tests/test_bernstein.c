/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/random.h"

#include "bernstein.h"

#include <math.h>

enum { LAST = COIN_PRIV_JOINED, SQUARE = COIN_PRIV_SQUARED };

/* The product of (x - zeros[i]), times a sign, in Bernstein's form: from a
 * degree n to n + 1 with 1 - x and x. */
static void with_zeros(double b[SQUARE + 1], const double *zeros, int count,
                       double sign)
{
    b[0] = sign;
    for (int n = 0; n < SQUARE; ++n) {
        /* Beyond the zeros, times 1. */
        const double at_0 = n < count ? -zeros[n] : 1;
        const double at_1 = n < count ? 1 - zeros[n] : 1;
        b[n + 1] = at_1 * b[n];
        for (int k = n; k > 0; --k)
            b[k] = (k * at_1 * b[k - 1] + (n + 1 - k) * at_0 * b[k]) / (n + 1);
        b[0] *= at_0;
    }
}

static double product(double x, const double *zeros, int count, double sign)
{
    for (int i = 0; i < count; ++i)
        sign *= x - zeros[i];
    return sign;
}

static void a_value_is_that_of_the_product(void **unused)
{
    (void)unused;
    struct random r = random_begin(201);
    for (int n = 0; n < 300; ++n) {
        double zeros[6], b[SQUARE + 1];
        for (int i = 0; i < 6; ++i)
            zeros[i] = random_between(&r, -0.5, 1.5);
        with_zeros(b, zeros, 6, 1);
        for (double x = 0; x <= 1; x += 0.0625)
            check_near(coin_priv_bernstein_value(b, SQUARE, x),
                       product(x, zeros, 6, 1), 200 * U * pow(1.5, 6));
    }
}

static int ascending(double *x, int count)
{
    for (int i = 1; i < count; ++i)
        for (int k = i; k > 0 && x[k] < x[k - 1]; --k) {
            const double keep = x[k];
            x[k] = x[k - 1];
            x[k - 1] = keep;
        }
    for (int i = 1; i < count; ++i)
        if (x[i] - x[i - 1] < 0.002)
            return 0;
    return 1;
}

/* All rises one after another: at each second zero, in order. */
static void each_rise_is_found_in_order(void **unused)
{
    (void)unused;
    struct random r = random_begin(202);
    int tried = 0;
    while (tried < 300) {
        double zeros[5], b[SQUARE + 1], from = -1;
        for (int i = 0; i < 5; ++i)
            zeros[i] = random_between(&r, 0.001, 0.999);
        if (!ascending(zeros, 5))
            continue;
        const int first = ++tried % 2;
        with_zeros(b, zeros, 5, first ? -1 : 1);
        if (first) /* positive at 0: that counts as a rise */
            check((from = coin_priv_first_positive(b, SQUARE, from)) == 0);
        for (int i = first; i < 5; i += 2) {
            from = coin_priv_first_positive(b, SQUARE, from);
            check_near(from, zeros[i], 1e-6);
        }
        check(coin_priv_first_positive(b, SQUARE, from) == 2);
    }
}

/* Two zeros d apart, which are told apart down to 2^-13. */
static void brief_excursions_are_found(void **unused)
{
    (void)unused;
    struct random r = random_begin(203);
    for (int n = 0; n < 300; ++n) {
        const double at = random_between(&r, 0.1, 0.9);
        const double d = ldexp(1, -13) * random_between(&r, 1, 3);
        const double zeros[] = {at, at + d};
        double b[SQUARE + 1];
        with_zeros(b, zeros, 2, -1);
        check_near(coin_priv_first_positive(b, SQUARE, -1), at, 1e-9);
    }
}

static void what_only_touches_or_falls_is_no_rise(void **unused)
{
    (void)unused;
    const double twice[] = {0.3, 0.3}, falls[] = {0.3}, end[] = {1};
    const double none[SQUARE + 1] = {0};
    check(coin_priv_first_positive(none, SQUARE, -1) == 2);
    double b[SQUARE + 1];
    with_zeros(b, twice, 2, -1);
    check(coin_priv_first_positive(b, SQUARE, -1) == 2);
    with_zeros(b, falls, 1, -1);
    check(coin_priv_first_positive(b, SQUARE, 0) == 2);
    with_zeros(b, end, 1, -1);
    check(coin_priv_first_positive(b, SQUARE, 0) == 2);
}

/* A zero at a place where [0, 1] is cut. */
static void a_rise_at_a_cut_is_found(void **unused)
{
    (void)unused;
    const double zeros[] = {0.25, 0.5, 0.75};
    double b[SQUARE + 1];
    with_zeros(b, zeros, 3, 1);
    check_near(coin_priv_first_positive(b, SQUARE, -1), 0.25, 1e-12);
    check_near(coin_priv_first_positive(b, SQUARE, 0.5), 0.75, 1e-12);
}

static void the_cone_is_x_squared_plus_y_squared_less_z_squared(void **unused)
{
    (void)unused;
    struct random r = random_begin(204);
    for (int n = 0; n < 100; ++n) {
        double x[LAST + 1], y[LAST + 1], z[LAST + 1], cone[SQUARE + 1];
        for (int k = 0; k <= LAST; ++k) {
            x[k] = random_between(&r, -1, 1);
            y[k] = random_between(&r, -1, 1);
            z[k] = random_between(&r, -1, 1);
        }
        coin_priv_cone_polynomial(cone, x, y, z);
        for (double t = 0; t <= 1; t += 0.0625) {
            const double a = coin_priv_bernstein_value(x, LAST, t);
            const double b = coin_priv_bernstein_value(y, LAST, t);
            const double c = coin_priv_bernstein_value(z, LAST, t);
            check_near(coin_priv_bernstein_value(cone, SQUARE, t),
                       a * a + b * b - c * c, 100 * U);
        }
    }
}

static const int all_terms[] = {COIN_PRIV_FORCE_FEW, COIN_PRIV_FORCE_SOME,
                                COIN_PRIV_FORCE_TERMS};

/* By either way to cut. */
static void two_halves_are_the_whole(void **unused)
{
    (void)unused;
    struct random r = random_begin(205);
    for (int n = 0; n < 100; ++n) {
        const int terms = all_terms[n % 3];
        const int degree = COIN_PRIV_DEGREE(terms);
        double whole[LAST + 1], first[LAST + 1], second[LAST + 1];
        for (int k = 0; k <= degree; ++k)
            second[k] = whole[k] = random_between(&r, -1, 1);
        if (n % 2)
            coin_priv_halve(first, second, degree);
        else
            coin_priv_halve_joined(first, second, terms);
        for (double t = 0; t <= 1; t += 0.0625) {
            check_near(coin_priv_bernstein_value(first, degree, t),
                       coin_priv_bernstein_value(whole, degree, t / 2),
                       100 * U);
            check_near(coin_priv_bernstein_value(second, degree, t),
                       coin_priv_bernstein_value(whole, degree, (1 + t) / 2),
                       100 * U);
        }
    }
}

/* From b = x^2: its series at both ends, times 3. */
static void a_joined_polynomial_has_the_terms_of_both_ends(void **unused)
{
    (void)unused;
    const coin_priv_ends ends[COIN_PRIV_FORCE_TERMS] = {
        {{0, 1}}, {{0, 1}}, {{0.25, 0.25}}};
    for (int i = 0; i < 3; ++i) {
        const int terms = all_terms[i];
        double b[LAST + 1];
        coin_priv_join(b, ends, 2, 3, terms);
        for (double x = 0; x <= 1; x += 0.0625)
            check_near(coin_priv_bernstein_value(b, COIN_PRIV_DEGREE(terms), x),
                       3 * x * x, 40 * U);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_value_is_that_of_the_product),
        TEST(each_rise_is_found_in_order),
        TEST(brief_excursions_are_found),
        TEST(what_only_touches_or_falls_is_no_rise),
        TEST(a_rise_at_a_cut_is_found),
        TEST(the_cone_is_x_squared_plus_y_squared_less_z_squared),
        TEST(two_halves_are_the_whole),
        TEST(a_joined_polynomial_has_the_terms_of_both_ends),
    };
    return RUN_TESTS(tests);
}
