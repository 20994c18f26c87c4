/* SPDX-License-Identifier: MIT */
/* Calls of coins that slip: what is refused, and what ends a call early. */
#include "support/check.h"
#include "support/coins.h"
#include "support/far.h"
#include "support/losses.h"
#include "support/slides.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const coin_friction rough = {0.55, 0.5};

/* Thrown with a side slip: it slips, rolls, slips and rolls. */
static const coin_slide thrown = {
    {.theta = 0.3, .wY = 0.5, .wZ = -0.5}, 1, 0.4};

/* --------------------------------------------------------------- bad input */
static void refused(const coin_slide *d, const coin_params *p,
                    const coin_friction *f, const coin_losses *l, double t,
                    double tol, int32_t want)
{
    coin_slide moved = *d;
    double reached = 7;
    check_status(coin_slide_advance(&moved, p, f, l, t, tol, &reached), want);
    check(reached == 7);
    check_same(&moved, d, sizeof *d);
}

static void bad_arguments_are_refused_in_their_order(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses damped = {.damping = 1e-3}, negative = {.dry = -1};
    const coin_friction frictions[] = {{0.3, -0.1}, {0.3, 0.31},   {NAN, 0.1},
                                       {0.3, NAN},  {INFINITY, 2}, {-1, -1}};
    coin_slide bad = thrown;
    coin_force force;
    const double tols[] = {0, 1e-14, 0.011, NAN, -1};
    for (int i = 0; i < 5; ++i)
        refused(&thrown, &p, &rough, NULL, 1, tols[i], COIN_EARG);
    for (int i = 0; i < 6; ++i) {
        refused(&thrown, &p, &frictions[i], NULL, NAN, 1e-9, COIN_EPARAMS);
        check_status(
            coin_slide_reaction(&thrown, &p, &frictions[i], NULL, &force),
            COIN_EPARAMS);
    }
    refused(&thrown, &p, &rough, &damped, 1, 1e-9, COIN_EPARAMS);
    refused(&thrown, &p, &rough, &negative, 1, 1e-9, COIN_EPARAMS);
    const double velocities[] = {NAN, INFINITY, -INFINITY, 1.001e6};
    for (int i = 0; i < 8; ++i) {
        double u[2] = {7, 7};
        bad = thrown;
        *(i < 4 ? &bad.vx : &bad.vz) = velocities[i % 4];
        refused(&bad, &p, &rough, NULL, NAN, 1e-9, COIN_ESTATE);
        check_status(coin_slide_velocity(&bad, &p, u), COIN_ESTATE);
        check(u[0] == 7 && u[1] == 7);
        check(isnan(coin_slide_energy(&bad, &p)));
        check_status(coin_slide_reaction(&bad, &p, &rough, NULL, &force),
                     COIN_ESTATE);
    }
    const double times[] = {-1e-9, NAN, INFINITY, 1e16};
    for (int i = 0; i < 4; ++i)
        refused(&thrown, &p, &rough, NULL, times[i], 1e-9, COIN_ESTEP);
    check(isnan(coin_slide_energy(NULL, &p)));
    check(isnan(coin_slide_energy(&thrown, NULL)));
}

/* 2 sqrt(k (1 + k)): the disc's sqrt(5)/2, the hoop's sqrt(3). */
static void friction_beyond_the_bound_of_painleve_is_refused(void **unused)
{
    (void)unused;
    const double inner[] = {0, 0.5, 1};
    const double bound[] = {1.1180339887498949, 1.2808688457449498,
                            1.7320508075688772};
    for (int i = 0; i < 3; ++i) {
        const coin_params p = ring(inner[i]);
        const coin_friction below = {INFINITY, bound[i] * (1 - 1e-14)};
        const coin_friction above = {INFINITY, bound[i] * (1 + 1e-14)};
        coin_slide d = thrown;
        check(coin_slide_advance(&d, &p, &below, NULL, 0.1, 1e-9, NULL) !=
              COIN_EPARAMS);
        refused(&thrown, &p, &above, NULL, 1, 1e-9, COIN_EPARAMS);
    }
}

/* As of coin_advance(). */
static void a_place_out_of_range_is_not_reached(void **unused)
{
    (void)unused;
    const coin_friction endless = {INFINITY, 0.3};
    coin_params p;
    double dt, reached = 7;
    const coin_state edge = far_coin(&p, 0, &dt);
    coin_slide d;
    check_status(coin_slide_of(&d, &edge, &p), COIN_OK);
    check_status(
        coin_slide_advance(&d, &p, &endless, NULL, 100 * dt, 1e-6, &reached),
        COIN_ERANGE);
    check_within(reached, 6 * dt, 11.4 * dt);
    check_status(coin_state_check(&d.s, &p), COIN_OK);
}

/* Until phi leaves its range; how far it came is kept. */
static void ends_on_the_way(const coin_slide *from, const coin_friction *f,
                            const coin_losses *l, double t, double tol)
{
    const coin_params p = disc();
    coin_slide d = *from;
    double reached;
    check_status(coin_slide_advance(&d, &p, f, l, t, tol, &reached),
                 COIN_ERANGE);
    check(reached >= 0 && reached < t);
    check_status(coin_state_check(&d.s, &p), COIN_OK);
}

static void a_pose_that_leaves_its_range_ends_a_roll(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_friction endless = {INFINITY, 0.3};
    const coin_losses slow = {.viscous = 1e-3};
    coin_state s = {.theta = 0.3, .wY = 0.5, .wZ = 0.2};
    coin_slide d;
    s.phi = 0x1p31 - 0x1p-20;
    coin_slide_of(&d, &s, &p);
    ends_on_the_way(&d, &endless, NULL, 1e-3, 1e-9); /* one step */
    ends_on_the_way(&d, &endless, NULL, 5, 1e-9);
    ends_on_the_way(&d, &endless, &slow, 5, 1e-9);
}

/* The step in Sundman's time leads to just before the end, and psi leaves its
 * range in the last step. */
static void the_slide_is_that_of_the_time_that_was_reached(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_friction endless = {INFINITY, 0.3};
    const coin_state start = {
        .theta = 0.3, .psi = 2147483647.7356925, .wX = 0.5, .wZ = 1};
    coin_state s = start;
    coin_slide d;
    double reached;
    check_status(coin_slide_of(&d, &start, &p), COIN_OK);
    check_status(
        coin_slide_advance(&d, &p, &endless, NULL, 0.25, 1e-9, &reached),
        COIN_ERANGE);
    check_within(reached, 0.24, 0.25);
    check_status(coin_advance(&s, &p, reached, 1e-12, NULL), COIN_OK);
    check_near(d.s.theta, s.theta, 1e-9);
    check_near(d.s.psi, s.psi, 1e-6);
}

static void a_pose_that_leaves_its_range_ends_the_slide(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    coin_slide d = thrown;
    double reached;
    d.s.phi = 0x1p31 - 0.1;
    const coin_friction ice = {0, 0};
    check_status(coin_slide_advance(&d, &p, &ice, NULL, 5, 1e-9, &reached),
                 COIN_ERANGE);
    check(reached > 0 && reached < 5);
    check_status(coin_state_check(&d.s, &p), COIN_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(bad_arguments_are_refused_in_their_order),
        TEST(friction_beyond_the_bound_of_painleve_is_refused),
        TEST(a_place_out_of_range_is_not_reached),
        TEST(a_pose_that_leaves_its_range_ends_a_roll),
        TEST(the_slide_is_that_of_the_time_that_was_reached),
        TEST(a_pose_that_leaves_its_range_ends_the_slide),
    };
    return RUN_TESTS(tests);
}
