/* SPDX-License-Identifier: MIT */
#include "support/check.h"

#include <math.h>

static void check_body(const coin_params *p, double IX, double IZ)
{
    check(p->mass == 2 && p->radius == 4 && p->gravity == 8);
    check(p->inertia_X == IX && p->inertia_Z == IZ);
    check(p->reserved[0] == 0 && p->reserved[1] == 0 && p->reserved[2] == 0);
}

static void each_shape_has_its_inertia(void **unused)
{
    (void)unused;
    coin_params p;
    check_status(coin_params_disc(&p, 2, 4, 8), COIN_OK);
    check_body(&p, 2 * 16 / 4.0, 2 * 16 / 2.0);
    check_status(coin_params_ring(&p, 2, 4, 0, 8), COIN_OK);
    check_body(&p, 8, 16);
    check_status(coin_params_ring(&p, 2, 4, 2, 8), COIN_OK);
    check_body(&p, 2 * (16 + 4) / 4.0, 2 * (16 + 4) / 2.0);
    check_status(coin_params_ring(&p, 2, 4, 4, 8), COIN_OK);
    check_body(&p, 2 * 32 / 4.0, 2 * 32 / 2.0);
    check_status(coin_params_body(&p, 2, 4, 8, 3, 5), COIN_OK);
    check_body(&p, 3, 5);
}

/* A uniform disc is a stack of hoops: its inertia by a sum over 1000. */
static void a_disc_is_made_of_hoops(void **unused)
{
    (void)unused;
    coin_params disc, hoop;
    double IX = 0, IZ = 0;
    const int n = 1000;
    check_status(coin_params_disc(&disc, 3, 2, 1), COIN_OK);
    for (int i = 0; i < n; ++i) {
        const double r = 2 * (i + 0.5) / n, mass = 3 * 2 * r / 4 * 2 / n;
        check_status(coin_params_ring(&hoop, mass, r, r, 1), COIN_OK);
        IX += hoop.inertia_X;
        IZ += hoop.inertia_Z;
    }
    /* The midpoint rule on r^3 leaves half of 1/n^2. */
    check_near(IX, disc.inertia_X, 0.6 / (n * n) * disc.inertia_X);
    check_near(IZ, disc.inertia_Z, 0.6 / (n * n) * disc.inertia_Z);
}

/* One member at a time, from a good body. */
static const double bad_numbers[] = {0,         -1,   NAN,   INFINITY,
                                     -INFINITY, -0.0, 1e-310};

static void check_member(coin_params *p, double *member, double value)
{
    const double kept = *member;
    *member = value;
    check_note("member %d is %g", (int)(member - &p->mass), value);
    check_status(coin_params_check(p), COIN_EPARAMS);
    *member = kept;
}

static void every_member_must_be_positive_and_finite(void **unused)
{
    (void)unused;
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    double *const members[] = {&p.mass, &p.radius, &p.gravity, &p.inertia_X,
                               &p.inertia_Z};
    for (size_t m = 0; m < 5; ++m)
        for (size_t i = 0; i < sizeof bad_numbers / sizeof *bad_numbers; ++i)
            check_member(&p, members[m], bad_numbers[i]);
    check_status(coin_params_check(&p), COIN_OK);
}

static void every_reserved_member_must_be_zero(void **unused)
{
    (void)unused;
    const double bad[] = {1, -1, 5e-324, NAN, INFINITY};
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    for (size_t m = 0; m < 3; ++m)
        for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i)
            check_member(&p, &p.reserved[m], bad[i]);
    p.reserved[1] = -0.0;
    check_status(coin_params_check(&p), COIN_OK);
}

static void axial_inertia_is_at_most_twice_the_diametral(void **unused)
{
    (void)unused;
    coin_params p;
    check_status(coin_params_body(&p, 1, 1, 1, 0.3, 0.6), COIN_OK);
    check_status(coin_params_body(&p, 1, 1, 1, 0.3, 0.6 * (1 + 5e-13)),
                 COIN_OK);
    check_status(coin_params_body(&p, 1, 1, 1, 0.3, 0.6 * (1 + 2e-12)),
                 COIN_EPARAMS);
    check_status(coin_params_body(&p, 1, 1, 1, 0.3, 1e-9), COIN_OK);
}

static void the_hole_lies_within_the_coin(void **unused)
{
    (void)unused;
    const double bad[] = {-1e-300,  -1,        nextafter(4, 5),
                          INFINITY, -INFINITY, NAN};
    coin_params p;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        check_note("inner radius %g", bad[i]);
        check_status(coin_params_ring(&p, 2, 4, bad[i], 8), COIN_EPARAMS);
    }
    check_status(coin_params_ring(&p, 2, 4, -0.0, 8), COIN_OK);
}

static void a_null_pointer_is_noticed_before_anything_else(void **unused)
{
    (void)unused;
    check_status(coin_params_ring(NULL, 2, 4, -1, 8), COIN_EARG);
    check_status(coin_params_ring(NULL, -2, 4, 5, 8), COIN_EARG);
    check_status(coin_params_disc(NULL, NAN, 4, 8), COIN_EARG);
    check_status(coin_params_body(NULL, 2, 4, 8, 0, 0), COIN_EARG);
    check_status(coin_params_check(NULL), COIN_EARG);
}

/* M, a, g whose products or quotients no double holds. */
static void products_must_not_leave_the_range_of_doubles(void **unused)
{
    (void)unused;
    const double bad[][3] = {
        {1e200, 1e60, 1},    /* M a^2 */
        {1e-200, 1e-60, 1},  /* M a^2 */
        {1e150, 1, 1e160},   /* M g a */
        {1e-150, 1, 1e-160}, /* M g a */
        {1, 1e-155, 1e155},  /* g/a */
        {1, 1e155, 1e-155},  /* g/a */
    };
    coin_params p;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        const double *b = bad[i];
        check_note("M = %g, a = %g, g = %g", b[0], b[1], b[2]);
        check_status(coin_params_disc(&p, b[0], b[1], b[2]), COIN_EPARAMS);
    }
}

/* One number is at the edge each time, and all others are inside. */
static void numbers_reach_from_1e_300_to_1e300(void **unused)
{
    (void)unused;
    const struct {
        const char *number;
        double mass, radius, gravity, IX, IZ;
        int32_t want;
    } cases[] = {
        {"M", 1.01e-300, 1, 1, 1e-300, 1.1e-300, COIN_OK},
        {"M", 0.99e-300, 1, 1, 1e-300, 1.1e-300, COIN_EPARAMS},
        {"I_Z", 1, 1, 1, 1e-200, 1.01e-300, COIN_OK},
        {"I_Z", 1, 1, 1, 1e-200, 0.99e-300, COIN_EPARAMS},
        {"M g a/J", 1, 1e100, 1.01e-200, 1e150, 5e149, COIN_OK},
        {"M g a/J", 1, 1e100, 0.99e-200, 1e150, 5e149, COIN_EPARAMS},
        {"M g a", 1e200, 0.98, 1e100, 1e200, 1e200, COIN_EPARAMS},
        {"M g a + M g", 1e200, 0.4, 0.7e100, 1e199, 1e199, COIN_OK},
        {"M g a + M g", 1e200, 0.4, 0.8e100, 1e199, 1e199, COIN_EPARAMS},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coin_params p;
        check_note("%s, case %zu", cases[i].number, i);
        check_status(coin_params_body(&p, cases[i].mass, cases[i].radius,
                                      cases[i].gravity, cases[i].IX,
                                      cases[i].IZ),
                     cases[i].want);
    }
}

/* Each body has one ratio that no double holds, or none. */
static void ratios_of_inertias_must_not_leave_the_range_either(void **unused)
{
    (void)unused;
    const struct {
        const char *ratio;
        double mass, radius, gravity, IX, IZ;
        int32_t want;
    } cases[] = {
        {"none", 1, 1, 1, 1e-200, 1e-300, COIN_OK},
        {"I_Z/I_X", 1, 1, 1, 1e200, 1e-200, COIN_EPARAMS},
        {"I_X/J", 1, 1e75, 1, 1e-200, 1e-200, COIN_EPARAMS},
        {"m/K", 1e-200, 1, 1e100, 1e150, 1e150, COIN_EPARAMS},
        {"M g a/J", 1e-200, 1, 1, 1e150, 1e150, COIN_EPARAMS},
        {"critical rate", 1e-150, 1, 1e60, 1e100, 1e-150, COIN_EPARAMS},
        {"none", 1e-150, 1, 1, 1e100, 1e-150, COIN_OK},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coin_params p;
        check_note("%s", cases[i].ratio);
        check_status(coin_params_body(&p, cases[i].mass, cases[i].radius,
                                      cases[i].gravity, cases[i].IX,
                                      cases[i].IZ),
                     cases[i].want);
    }
}

/* Atoms to planets, with room. */
static void every_sensible_scale_is_accepted(void **unused)
{
    (void)unused;
    coin_params p;
    for (int e = -30; e <= 30; e += 10)
        for (int f = -30; f <= 30; f += 10) {
            check_note("mass 1e%d, length 1e%d", e, f);
            check_status(
                coin_params_disc(&p, pow(10, e), pow(10, f), pow(10, -f)),
                COIN_OK);
        }
}

/* a^2 is no normal number, but M a^2 is. */
static void a_square_of_the_radius_may_leave_the_doubles(void **unused)
{
    (void)unused;
    static const double sizes[][2] = {
        {1e200, 1e-160}, {1e250, 1e-170}, {1e-100, 1e155}, {1e-300, 1e299}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        coin_params p;
        const double M = sizes[i][0], a = sizes[i][1], m = M * a * a;
        check_note("mass %g, radius %g", M, a);
        check_status(coin_params_disc(&p, M, a, 1), COIN_OK);
        check_terms(p.inertia_X, m / 4, 4, m / 4);
        check_status(coin_params_ring(&p, M, a, a / 2, 1), COIN_OK);
        check_terms(p.inertia_X, 1.25 * m / 4, 4, m / 4);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(each_shape_has_its_inertia),
        TEST(a_disc_is_made_of_hoops),
        TEST(every_member_must_be_positive_and_finite),
        TEST(every_reserved_member_must_be_zero),
        TEST(axial_inertia_is_at_most_twice_the_diametral),
        TEST(the_hole_lies_within_the_coin),
        TEST(a_null_pointer_is_noticed_before_anything_else),
        TEST(numbers_reach_from_1e_300_to_1e300),
        TEST(products_must_not_leave_the_range_of_doubles),
        TEST(ratios_of_inertias_must_not_leave_the_range_either),
        TEST(every_sensible_scale_is_accepted),
        TEST(a_square_of_the_radius_may_leave_the_doubles),
    };
    return RUN_TESTS(tests);
}
