/* SPDX-License-Identifier: MIT */
/* Slips of bodies whose inertia is far below M a^2, and slips that turn round
 * where they have almost no speed. */
#include "support/check.h"
#include "support/coins.h"
#include "support/slides.h"

#include <fenv.h>
#include <math.h>

/* Friction stops a slip along the path almost at once if I_Z is small, and
 * leaves the slip across it. */

static const double I_Z = 1e-8, mu = 0.1, along = 900, across = 0.8;

/* The integral of n ds from 0 to the slip speed s along the path, where n is
 * the slip over its part along the path; but for a constant. */
static double integral(double s)
{
    const double slip = hypot(s, across);
    return slip - across * log((across + slip) / s);
}

/* The time in which the slip along the path slows to `to`.  An upright coin has
 * N = M g until it leans, and friction along the path acts on 1/M + a^2/I_Z.
 * What is neglected is what friction does across the path, on 1/M + a^2/I_X, in
 * the same time, and the lean that follows. */
static double time_to(double to)
{
    return (integral(along) - integral(to)) / (mu * (1 + 1 / I_Z));
}

static void a_slip_that_turns_across_the_path_goes_on(void **unused)
{
    (void)unused;
    const double tols[] = {1e-2, 1e-3, 2e-4, 1e-4, 1e-6, 1e-9};
    const coin_friction f = {1.1 * mu, mu};
    coin_params p;
    coin_params_body(&p, 1, 1, 1, 0.8, I_Z);
    for (double to = 0.3; to < 5; to *= 2) {
        for (int i = 0; i < 6; ++i) {
            coin_slide d = {{.wZ = along}, 0, across};
            double u[2];
            check_status(coin_slide_advance(&d, &p, &f, NULL, time_to(to),
                                            tols[i], NULL),
                         COIN_SLIPS);
            check_status(coin_slide_velocity(&d, &p, u), COIN_OK);
            check_near(u[0], to, tols[i] + 1e-6);
            check_near(u[1], across, tols[i] + 2e-5);
        }
    }
}

/* Found by trials: without a rate of steps that knows of I_X, its error is 27
 * tol. */
static void a_body_of_small_I_X_keeps_the_tolerance(void **unused)
{
    (void)unused;
    const double friction = 0.0457899, t = 0.96667, tol = 1e-4;
    const coin_friction f = {1.1 * friction, friction};
    const coin_slide from = {{.theta = 0x1.48dab02f2fe25p-3,
                              .wX = -0x1.d1e54c69f283ap-1,
                              .wY = 0x1.d91a2732956ep-3,
                              .wZ = 0x1.473473897831cp+1},
                             0x1.6b7941278798p-5,
                             -0x1.3faa56452c386p+0};
    coin_slide coarse = from, fine = from;
    coin_params p;
    coin_params_body(&p, 1, 1, 1, 0x1.7e680a3b591d2p-9, 0x1.b0910173dc16p-9);
    check_status(coin_slide_advance(&coarse, &p, &f, NULL, t, tol, NULL),
                 COIN_SLIPS);
    check_status(coin_slide_advance(&fine, &p, &f, NULL, t, 1e-12, NULL),
                 COIN_SLIPS);
    check(slides_apart(&coarse, &fine, &p) < tol * (1 + t));
}

/* A body with almost no inertia falls freely on ice: its mass is at the centre,
 * and N turns it without effort.  It would take more than 2^20 steps of the
 * length that such a body needs next to upright. */
static void a_body_without_inertia_falls_freely(void **unused)
{
    (void)unused;
    const coin_friction ice = {0, 0};
    coin_params p;
    coin_params_body(&p, 1, 1, 1, 1e-13, 2e-13);
    for (double tol = 1e-3; tol > 1e-9; tol /= 10) {
        coin_slide d = {{.theta = 0.3}, 0, 0};
        check_status(coin_slide_advance(&d, &p, &ice, NULL, 1, tol, NULL),
                     COIN_SLIPS);
        check_near(cos(d.s.theta), cos(0.3) - 0.5, 2 * tol + 1e-10);
    }
}

/* Such a body slips under a force that is tiny beside the products of its
 * rates.  Without friction nothing changes wZ. */
static void check_slips_on_ice(double I_X, double t, double tol)
{
    const coin_friction ice = {0, 0};
    const coin_state s = {
        .theta = -5.45e-8, .wX = -4.84e-4, .wY = 3217, .wZ = 2.13e-4};
    coin_slide d;
    coin_params p;
    coin_params_body(&p, 1, 1, 1, I_X, I_X / 2);
    check_status(coin_slide_of(&d, &s, &p), COIN_OK);
    check_status(coin_slide_advance(&d, &p, &ice, NULL, t, tol, NULL),
                 COIN_SLIPS);
    check_near(d.s.wZ, s.wZ, tol + 4e-10);
}

static void a_light_body_on_ice_does_not_roll(void **unused)
{
    (void)unused;
    for (double tol = 1e-4; tol > 1e-12; tol /= 1e5)
        check_slips_on_ice(1e-7, 0.003, tol);
    check_slips_on_ice(4e-15, 1e-7, 1e-10);
}

/* Such a body passes upright, where its normal force has a narrow peak.  With
 * steps that may pass over the peak the error is 2 tol (1 + t). */
static void a_body_of_small_I_X_passes_upright(void **unused)
{
    (void)unused;
    const coin_friction ice = {0, 0};
    const double t = 1.91983;
    const coin_slide from = {
        {.theta = -0.115884, .wX = 0.116325, .wY = 0.0589787, .wZ = -0.0138819},
        1.47524,
        0.56048};
    coin_slide fine = from;
    coin_params p;
    coin_params_body(&p, 1, 1, 1, 2.09407e-7, 1.18408e-7);
    check_status(coin_slide_advance(&fine, &p, &ice, NULL, t, 1e-8, NULL),
                 COIN_SLIPS);
    for (double tol = 1e-4; tol > 1e-7; tol /= 100) {
        coin_slide d = from;
        check_status(coin_slide_advance(&d, &p, &ice, NULL, t, tol, NULL),
                     COIN_SLIPS);
        check_note("tol %g: %g", tol,
                   slides_apart(&d, &fine, &p) / tol / (1 + t));
        check(slides_apart(&d, &fine, &p) < tol * (1 + t));
    }
}

/* No first step is tried that is so long that it overflows. */
static void a_slip_that_turns_round_raises_no_overflow(void **unused)
{
    (void)unused;
    const coin_friction f = {1.1 * 0x1.c8b636bf8eaa3p-6, 0x1.c8b636bf8eaa3p-6};
    coin_slide d = {{.theta = 0x1.2838f1b2f616dp-1,
                     .wX = -0x1.adbd9b1338d6p-3,
                     .wY = 0x1.4280b0337b95cp-1,
                     .wZ = -0x1.864600eb4732cp-1},
                    0x1.8646012c9b969p-1,
                    -0x1.67cd06ef78dfap-3};
    coin_params p;
    coin_params_body(&p, 1, 1, 1, 0x1.856cd926214f6p-12, 0x1.413da23f60293p-11);
    feclearexcept(FE_ALL_EXCEPT);
    check_status(
        coin_slide_advance(&d, &p, &f, NULL, 0x1.679d291b0fd7bp-30, 1e-3, NULL),
        COIN_SLIPS);
    check(!fetestexcept(FE_OVERFLOW | FE_INVALID | FE_DIVBYZERO));
}

/* The centre of a coin on ice keeps its velocity while it slips again and
 * again. */
static void a_coin_on_ice_keeps_its_velocity(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_friction ice = {0, 0};
    const coin_state s = {.theta = -0.430837, .wY = 0.894005};
    for (double tol = 1e-4; tol > 1e-12; tol *= 0.7) {
        coin_slide d;
        check_status(coin_slide_of(&d, &s, &p), COIN_OK);
        const double vx = d.vx, vz = d.vz;
        check(coin_slide_advance(&d, &p, &ice, NULL, 7.29, tol, NULL) >= 0);
        check_near(d.vx, vx, 8 * tol + 4e-10);
        check_near(d.vz, vz, 8 * tol + 4e-10);
    }
}

/* The slip speed nearly comes to 0 while the slip turns round.  If that ended
 * the slip, wZ would be off by 3.6e-4 at one tolerance in ten. */
static void a_slip_that_nearly_stops_goes_on(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_friction f = {0x1.3ab774693a586p-2, 0x1.0ba4a6afcebbep-3};
    const double t = 0x1.c5b3e8d09800ap+1;
    const coin_slide from = {{.theta = -0x1.764c730c6c423p+0,
                              .wX = -0x1.cc6948813ec7cp-7,
                              .wY = 0x1.bedf943186019p-6,
                              .wZ = 0x1.275b5ad39982ep-9},
                             -0x1.275b5ad39982ep-9,
                             -0x1.8f8eb5d9e5db4p-10};
    coin_slide fine = from;
    check_status(coin_slide_advance(&fine, &p, &f, NULL, t, 1e-13, NULL),
                 COIN_SLIPS);
    for (double tol = 1e-6; tol > 1e-12; tol *= 0.7) {
        coin_slide d = from;
        check_status(coin_slide_advance(&d, &p, &f, NULL, t, tol, NULL),
                     COIN_SLIPS);
        check(slides_apart(&d, &fine, &p) < 10 * tol * (1 + t));
    }
}

/* With boundary-layer friction alone, which has no softening.  Steps that know
 * nothing of the turn would err by up to 66 tol in the first case, and steps
 * that know of it where they begin alone by 12 tol in the second. */
static void a_slip_does_not_pass_where_the_contact_turns_round(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_friction f = {0.4, 0.36};
    const coin_losses l = {.layer = 0.02};
    const coin_slide from[] = {
        {{.theta = -0.03, .wX = 0.83, .wY = -1.8, .wZ = 0.26}, 0.24, 0.75},
        {{.theta = -0.98, .wX = 0.34, .wY = -0.46, .wZ = -0.66}, 0.72, -0.52},
    };
    for (int i = 0; i < 2; ++i) {
        coin_slide fine = from[i];
        const int32_t want =
            coin_slide_advance(&fine, &p, &f, &l, 0.7, 1e-13, NULL);
        check(want >= COIN_OK);
        for (double tol = 1e-2; tol > 1e-11; tol *= 0.8) {
            coin_slide d = from[i];
            check_note("case %d, tol %g", i, tol);
            check_status(coin_slide_advance(&d, &p, &f, &l, 0.7, tol, NULL),
                         want);
            check_within(slides_apart(&d, &fine, &p), 0, tol);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_slip_that_turns_across_the_path_goes_on),
        TEST(a_body_of_small_I_X_keeps_the_tolerance),
        TEST(a_body_without_inertia_falls_freely),
        TEST(a_light_body_on_ice_does_not_roll),
        TEST(a_body_of_small_I_X_passes_upright),
        TEST(a_slip_that_turns_round_raises_no_overflow),
        TEST(a_coin_on_ice_keeps_its_velocity),
        TEST(a_slip_that_nearly_stops_goes_on),
        TEST(a_slip_does_not_pass_where_the_contact_turns_round),
    };
    return RUN_TESTS(tests);
}
