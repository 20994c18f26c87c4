/* SPDX-License-Identifier: MIT */
/* Arguments near the edges, where a product or a quotient on the way could
 * overflow or be invalid: no call that is done raises an exception. */
#include "support/check.h"
#include "support/coins.h"
#include "support/slides.h"

#include <coinf.h>

#include <fenv.h>
#include <float.h>
#include <math.h>

#define TRAPPED (FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW)

/* The call raises nothing and returns this status. */
#define QUIET(call, status)                                                    \
    do {                                                                       \
        feclearexcept(FE_ALL_EXCEPT);                                          \
        const int32_t is = (call);                                             \
        const int raised = fetestexcept(TRAPPED);                              \
        check_status(is, status);                                              \
        check(!raised);                                                        \
    } while (0)

static coin_state turning(double theta, double wX, double wY, double wZ)
{
    const coin_state s = {theta, 0, 0, 0, 0, wX, wY, wZ};
    return s;
}

TEST(a_check_takes_any_step_and_any_friction)
{
    const coin_params p = disc();
    coinf_params pf;
    const coin_state s = turning(0.3, 1, 8, 8);
    const coinf_state sf = {.theta = 0.3f, .wX = 1, .wY = 8, .wZ = 8};
    coin_force f;
    check_status(coinf_params_disc(&pf, 1, 1, 1), COIN_OK);
    check_status(coin_reaction(&s, &p, &f), COIN_OK);
    check(f.normal > 1);
    QUIET(coin_check(&s, &p, COIN_RK4, -1e15, INFINITY), COIN_COARSE);
    QUIET(coin_check(&s, &p, COIN_RK4, 0, DBL_MAX), COIN_OK);
    QUIET(coinf_check(&sf, &pf, COIN_RK4, -1e6f, INFINITY), COIN_COARSE);
    QUIET(coinf_check(&sf, &pf, COIN_RK4, 0, FLT_MAX), COIN_OK);
}

TEST(without_a_step_its_length_does_not_count)
{
    const coin_params p = disc();
    coinf_params pf;
    coin_state s = turning(0.3, 1, 8, 8), out;
    coinf_state sf = {.theta = 0.3f, .wX = 1, .wY = 8, .wZ = 8};
    check_status(coinf_params_disc(&pf, 1, 1, 1), COIN_OK);
    for (int32_t m = COIN_RK4; m <= COIN_SYMPLECTIC4; ++m) {
        QUIET(coin_run(&s, &p, m, 1e15, 0, NULL), COIN_OK);
        QUIET(coin_batch_run(&s, 1, &p, m, 1e15, 0, NULL), COIN_OK);
        QUIET(coin_batch_run(&s, 0, &p, m, (double)NAN, 1, NULL), COIN_OK);
        QUIET(coin_sample(&s, &p, m, 1e15, 0, 1, &out, NULL), COIN_OK);
        check_status(coin_run(&s, &p, m, 1.001e15, 0, NULL), COIN_ESTEP);
    }
    QUIET(coinf_run(&sf, &pf, COIN_RK4, 1e6f, 0, NULL), COIN_OK);
}

/* Near flat with losses that hold the roll, a slip that takes long to end. */
TEST(trials_of_slips_do_not_run_away)
{
    const coin_params p = disc();
    const coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.3};
    const coin_table none = {.mu_static = 0, .mu_kinetic = 0};
    const coin_losses l = {.viscous = 0.01};
    const double flat = 1.5707963267948966;
    coin_body d = {
        .s = turning(flat - 1e-4, 0, 0.004, -0.06), .vx = 0.08, .vz = -6.6};
    QUIET(slide(&d, &p, &f, &l, 1e-3, 1e-6, NULL), COIN_SLIPS);
    d.s = turning(flat - 1e-3, 0, 0.004, -0.06);
    QUIET(slide(&d, &p, &none, &l, 1e-3, 1e-6, NULL), COIN_SLIPS);
}

/* Nearly upright a fall on ice begins so slowly that its first trials are far
 * too long. */
TEST(a_slow_fall_on_ice_is_quiet)
{
    const coin_params p = disc();
    const coin_table ice = {.mu_static = 0, .mu_kinetic = 0};
    coin_body fast = {.s = turning(0, 0.1, 0, 0), .vz = 0.1};
    QUIET(slide(&fast, &p, &ice, NULL, 1, 1e-9, NULL), COIN_SLIPS);
    for (double lean = 1e-10; lean < 2e-6; lean *= 2)
        for (double tol = 1e-9; tol < 1e-3; tol *= 10) {
            const coin_state s = turning(lean, 0.5, 0, 0);
            coin_body d;
            check_status(coin_body_from_state(&d, &s, &p), COIN_OK);
            check_note("lean %g, tol %g", lean, tol);
            QUIET(slide(&d, &p, &ice, NULL, 0.5, tol, NULL), COIN_SLIPS);
        }
}

/* No loss acts there that would end the fall. */
TEST(next_to_flat_pivoting_alone_is_quiet)
{
    const coin_params p = disc();
    const coin_losses spin = {.spin = 1e-3};
    coin_state s = turning(1.5707963267851195, 0, 1.34375, 2.3e-5);
    QUIET(coin_settle(&s, &p, &spin, 1.75e-11, 0.0078125, NULL), COIN_RESTS);
}

/* A step that is far too long for the losses. */
TEST(a_loss_too_strong_for_a_step_is_quiet)
{
    const coin_params p = disc();
    const double sizes[] = {10, 300, 1e3};
    coin_state s;
    for (int i = 0; i < 3; ++i) {
        const coin_losses layer = {.layer = sizes[i]};
        const coin_losses damping = {.damping = sizes[i]};
        for (double tol = 1e-9; tol < 1e-2; tol *= 1e6) {
            check_note("%g, tol %g", sizes[i], tol);
            s = turning(0.3, 0, cos(0.3), -sin(0.3));
            QUIET(coin_settle(&s, &p, &layer, 0.1, tol, NULL), COIN_OK);
            s = turning(0.3, 0, cos(0.3), -sin(0.3));
            QUIET(coin_settle(&s, &p, &damping, 0.1, tol, NULL), COIN_OK);
        }
    }
}

/* On ice, dry friction slows the turn but not the slip, whose slope is the
 * rounding of its terms. */
TEST(a_slip_that_nothing_ends_is_quiet)
{
    const coin_params p = {1, 1,     1, 0.2558477508650519, 0.51169550173010381,
                           0, {0, 0}};
    const coin_table ice = {.losses = {.dry = 0.046878814697265625}};
    coin_body b = {.s = {.phi = 6.1875, .wZ = 0.017822265625},
                   .y = 1,
                   .vx = 0.77421568795820728,
                   .vz = 0.0044789317035110569};
    QUIET(coin_move(&b, &p, &ice, 20, 1e-9, 0, NULL), COIN_SLIPS);
}

/* The direction of a slip whose turn is the least number. */
TEST(a_slip_that_begins_next_to_upright_is_quiet)
{
    const coin_params p = {
        1, 1, 1, 0.25221453287197232, 0.50442906574394464, 0, {0, 0}};
    const coin_table f = {.mu_static = 0.95976562500000007,
                          .mu_kinetic = 0.9140625,
                          .restitution = 0.9140625};
    coin_body b = {.s = {.theta = -0x1p-1074,
                         .phi = 3.051513671875,
                         .wX = 0.7529296875,
                         .wY = 3.875},
                   .y = 1,
                   .vx = 0.067731454745744935,
                   .vz = -0.74987703282396423};
    QUIET(coin_move(&b, &p, &f, 3e-6, 1e-4, 0, NULL), COIN_SLIPS);
}

/* What slows the turn also stops it. */
TEST(a_turn_that_ends_upright_is_quiet)
{
    const coin_params p = disc();
    const coin_table f = {.mu_static = (double)INFINITY,
                          .mu_kinetic = 0.2,
                          .losses = {.spin = 1.7}};
    coin_body b = {.s = turning(0, 0, 1.5, 0), .y = 1};
    QUIET(coin_move(&b, &p, &f, (double)INFINITY, 3e-5, 0, NULL), COIN_RESTS);
}

TEST(the_largest_friction_is_quiet)
{
    const coin_params p = disc();
    const coin_table f = {
        .mu_static = DBL_MAX, .mu_kinetic = 0.3, .restitution = 0.5};
    coin_body b = {.s = turning(0.3, 0.5, 1, 2), .y = 1, .vx = 1, .vy = -4};
    QUIET(coin_move(&b, &p, &f, 0.2, 1e-6, 0, NULL), COIN_LIFTS);
}

TEST(a_radius_beyond_all_doubles_is_infinite)
{
    const coin_params p = disc();
    const coin_state s = turning(1e-300, 0, 5e-324, -5e5);
    double center, contact;
    QUIET(coin_steady_radii(&s, &p, &center, &contact), COIN_OK);
    check(isinf(center) && isinf(contact));
}

TEST(the_least_numbers_are_no_divisors)
{
    const coin_params fine = {0x1.9c64p-5,
                              0x1.e4ea666666666p-40,
                              0x1.7f33333333333p-1,
                              0x1.71ea1506cd3e1p-84,
                              0x1.71ea1506cd3e1p-83,
                              0,
                              {0, 0}};
    const coin_params p = disc();
    coin_state s = turning(-0x1p-1074, 0, 0, -0x1.41d60435cf24dp+18);
    coin_orbit o;
    QUIET(coin_orbit_init(&o, &s, &fine), COIN_EDOMAIN);
    s = turning(0, 0, 0, 0x1p-1074); /* rolls on in a straight line */
    QUIET(coin_orbit_init(&o, &s, &p), COIN_OK);
    check(isnan(o.center[0]) && isnan(o.radius_max));
}

TEST(a_ride_round_no_circle_is_quiet)
{
    const coin_params p = disc();
    coin_state s;
    QUIET(coin_steady_ride(&s, &p, 1, 1e-200), COIN_EDOMAIN);
    QUIET(coin_steady_ride(&s, &p, 1e-200, 1e-200), COIN_OK);
    QUIET(coin_steady_ride(&s, &p, 1, DBL_MAX), COIN_EDOMAIN);
    QUIET(coin_steady_turn(&s, &p, 0.3, DBL_MAX), COIN_EDOMAIN);
}
