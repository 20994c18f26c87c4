/* SPDX-License-Identifier: MIT */
#include "support/check.h"

#include <math.h>

static void check_body(const coin_params *p, double IX, double IZ)
{
    check(p->mass == 2 && p->radius == 4 && p->gravity == 8);
    check(p->inertia_X == IX && p->inertia_Z == IZ);
    check(p->thickness == 0);
    check(p->reserved[0] == 0 && p->reserved[1] == 0);
}

TEST(each_shape_has_its_inertia)
{
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
TEST(a_disc_is_made_of_hoops)
{
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

TEST(every_member_must_be_positive_and_finite)
{
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    double *const members[] = {&p.mass, &p.radius, &p.gravity, &p.inertia_X,
                               &p.inertia_Z};
    for (size_t m = 0; m < 5; ++m)
        for (size_t i = 0; i < sizeof bad_numbers / sizeof *bad_numbers; ++i)
            check_member(&p, members[m], bad_numbers[i]);
    check_status(coin_params_check(&p), COIN_OK);
}

TEST(a_thickness_is_nothing_or_in_its_range)
{
    const double bad[] = {-1, 5e-324, 0.9e-4, 4.01, NAN, INFINITY};
    const double good[] = {0, 1e-4, 4};
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        check_member(&p, &p.thickness, bad[i]);
        check_status(coin_params_cylinder(&p, 1, 1, bad[i], 1), COIN_EPARAMS);
    }
    for (size_t i = 0; i < sizeof good / sizeof *good; ++i) {
        check_status(coin_params_cylinder(&p, 1, 1, good[i], 1), COIN_OK);
        check(p.thickness == good[i]);
        check_near(p.inertia_X, 0.25 + good[i] * good[i] / 12, 1e-15);
    }
}

TEST(every_reserved_member_must_be_zero)
{
    const double bad[] = {1, -1, 5e-324, NAN, INFINITY};
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    double *const members[] = {&p.reserved[0], &p.reserved[1]};
    for (size_t m = 0; m < 2; ++m)
        for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i)
            check_member(&p, members[m], bad[i]);
    p.reserved[1] = -0.0;
    check_status(coin_params_check(&p), COIN_OK);
}

TEST(axial_inertia_is_at_most_twice_the_diametral)
{
    coin_params p;
    check_status(coin_params_body(&p, 1, 1, 1, 0.3, 0.6), COIN_OK);
    check_status(coin_params_body(&p, 1, 1, 1, 0.3, 0.6 * (1 + 5e-13)),
                 COIN_OK);
    check_status(coin_params_body(&p, 1, 1, 1, 0.3, 0.6 * (1 + 2e-12)),
                 COIN_EPARAMS);
}

TEST(the_hole_lies_within_the_coin)
{
    const double bad[] = {-1e-300,  -1,        nextafter(4, 5),
                          INFINITY, -INFINITY, NAN};
    coin_params p;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        check_note("inner radius %g", bad[i]);
        check_status(coin_params_ring(&p, 2, 4, bad[i], 8), COIN_EPARAMS);
        check_status(coin_params_ring(NULL, 2, 4, bad[i], 8), COIN_EARG);
    }
    check_status(coin_params_ring(&p, 2, 4, -0.0, 8), COIN_OK);
}
