/* SPDX-License-Identifier: MIT */
/* Arguments near the edges, where a product or a quotient on the way could
 * overflow or be invalid: no call that is done raises an exception. */
#include "support/check.h"

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

static coin_params disc(void)
{
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    return p;
}

static coin_state turning(double theta, double wX, double wY, double wZ)
{
    const coin_state s = {theta, 0, 0, 0, 0, wX, wY, wZ};
    return s;
}

static void a_check_takes_any_step_and_any_friction(void **unused)
{
    const coin_params p = disc();
    coinf_params pf;
    const coin_state s = turning(0.3, 1, 8, 8);
    const coinf_state sf = {.theta = 0.3f, .wX = 1, .wY = 8, .wZ = 8};
    coin_force f;
    (void)unused;
    check_status(coinf_params_disc(&pf, 1, 1, 1), COIN_OK);
    check_status(coin_reaction(&s, &p, &f), COIN_OK);
    check(f.normal > 1);
    QUIET(coin_check(&s, &p, COIN_RK4, -1e15, INFINITY), COIN_COARSE);
    QUIET(coin_check(&s, &p, COIN_RK4, 0, DBL_MAX), COIN_OK);
    QUIET(coinf_check(&sf, &pf, COIN_RK4, -1e6f, INFINITY), COIN_COARSE);
    QUIET(coinf_check(&sf, &pf, COIN_RK4, 0, FLT_MAX), COIN_OK);
}

static void without_a_step_its_length_does_not_count(void **unused)
{
    const coin_params p = disc();
    coinf_params pf;
    coin_state s = turning(0.3, 1, 8, 8), out;
    coinf_state sf = {.theta = 0.3f, .wX = 1, .wY = 8, .wZ = 8};
    (void)unused;
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

/* Near flat with losses that hold the roll, a slip that takes long to end; and
 * a slip as slow as rounding of a coin that rolls fast. */
static void trials_of_slips_do_not_run_away(void **unused)
{
    const coin_params p = disc();
    const coin_friction f = {0.3, 0.3}, none = {0, 0};
    const coin_losses l = {0, 0, 0.01, 0, 0, 0, 0, 0};
    const double flat = 1.5707963267948966;
    coin_slide d = {turning(flat - 1e-4, 0, 0.004, -0.06), 0.08, -6.6};
    (void)unused;
    QUIET(coin_slide_advance(&d, &p, &f, &l, 1e-3, 1e-6, NULL), COIN_SLIPS);
    d.s = turning(flat - 1e-3, 0, 0.004, -0.06);
    QUIET(coin_slide_advance(&d, &p, &none, &l, 1e-3, 1e-6, NULL), COIN_SLIPS);
    const coin_params coin = {0.00567,  0.01213,  9.80665,
                              3.68e-07, 7.36e-07, {0, 0, 0}};
    const coin_friction rough = {INFINITY, 0.2010498046875};
    coin_slide fast;
    const coin_state s = turning(0.173858642578125, -6.9, 0, 27418841.4297);
    check_status(coin_slide_of(&fast, &s, &coin), COIN_OK);
    fast.vz += 1e-3;
    feclearexcept(FE_ALL_EXCEPT);
    const int32_t is =
        coin_slide_advance(&fast, &coin, &rough, NULL, 2.7e-16, 6e-8, NULL);
    check(is != COIN_ESTATE && !fetestexcept(TRAPPED));
}

/* Nearly upright a fall on ice begins so slowly that its first trials are far
 * too long. */
static void a_slow_fall_on_ice_is_quiet(void **unused)
{
    const coin_params p = disc();
    const coin_friction ice = {0, 0};
    coin_slide fast = {turning(0, 0.1, 0, 0), 0, 0.1};
    (void)unused;
    QUIET(coin_slide_advance(&fast, &p, &ice, NULL, 1, 1e-9, NULL), COIN_SLIPS);
    for (double lean = 1e-10; lean < 2e-6; lean *= 2)
        for (double tol = 1e-9; tol < 1e-3; tol *= 10) {
            const coin_state s = turning(lean, 0.5, 0, 0);
            coin_slide d;
            check_status(coin_slide_of(&d, &s, &p), COIN_OK);
            check_note("lean %g, tol %g", lean, tol);
            QUIET(coin_slide_advance(&d, &p, &ice, NULL, 0.5, tol, NULL),
                  COIN_SLIPS);
        }
}

/* No loss acts there that would end the fall. */
static void next_to_flat_pivoting_alone_is_quiet(void **unused)
{
    const coin_params p = disc();
    const coin_losses spin = {.spin = 1e-3};
    coin_state s = turning(1.5707963267851195, 0, 1.34375, 2.3e-5);
    (void)unused;
    QUIET(coin_settle(&s, &p, &spin, 1.75e-11, 0.0078125, NULL), COIN_OK);
}

static void a_slow_path_through_steady_motions_is_quiet(void **unused)
{
    const coin_params p = disc();
    coin_losses spin = {0, 0, 0, 0, 0, 0, 0.03, 0};
    coin_losses dry = {0, 1e-35, 0, 0, 0, 0, 0, 0};
    coin_losses least = {0, 1e-170, 0, 0, 0, 0, 0, 0};
    coin_state s, out;
    (void)unused;
    check_status(coin_steady_upright_spin(&s, &p, 0x1.ba08bd40fde08p+0),
                 COIN_OK);
    QUIET(coin_quasisteady_at(&s, &p, &spin, 5.01187, &out), COIN_OK);
    check_status(coin_steady_spin(&s, &p, 0.4), COIN_OK);
    feclearexcept(FE_ALL_EXCEPT);
    check(coin_time_to_rest(&s, &p, &dry) > 1e30);
    check(!fetestexcept(TRAPPED));
    QUIET(coin_losses_fit(&least, &s, &p, 100), COIN_EDOMAIN);
    check_status(coin_quasisteady_at(&s, &p, &dry, DBL_MAX, &out), COIN_ESTEP);
    /* So nearly upright that the lean grows by 80 powers of ten. */
    coin_params ring;
    coin_losses rough = {0,
                         0.3371429443359375,
                         0,
                         1.4808847481617704e-09,
                         3.0820501706330106e-10,
                         1.5103723853826523e-06,
                         0,
                         2.9013458302529216e-12};
    check_status(coin_params_body(&ring, 1, 1, 1, 0.45693579392541328,
                                  0.91387158785082656),
                 COIN_OK);
    s = turning(-1.1018990464954999e-84, 0, 1.4793550212337918, 0);
    QUIET(coin_losses_fit(&rough, &s, &ring, 2.4), COIN_EDOMAIN);
}

/* A step that is far too long for the losses; a circle that is neither stable
 * nor unstable. */
static void a_loss_too_strong_for_a_step_is_quiet(void **unused)
{
    const coin_params p = disc();
    const double sizes[] = {1e3, 3e3, 1e8};
    coin_params hoop;
    coin_state s, out;
    (void)unused;
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
    check_status(coin_params_ring(&hoop, 1, 1, 1, 1), COIN_OK);
    const coin_losses dry = {.dry = 1e-3};
    for (double wX = 0; wX < 1; wX += 0.1) {
        coin_losses fitted = dry;
        s = turning(0, wX, 0, 0.5);
        QUIET(coin_quasisteady_at(&s, &hoop, &dry, 1, &out), COIN_EDOMAIN);
        QUIET(coin_losses_fit(&fitted, &s, &hoop, 10), COIN_EDOMAIN);
    }
}

static void a_time_of_no_length_is_looked_at(void **unused)
{
    coin_params p;
    coin_state s = turning(0x1.595c5f495e3d7p+0, 0x1.e376acfd625ccp+0, 0, 0);
    (void)unused;
    check_status(coin_params_ring(&p, 1, 1, 1, 1), COIN_OK);
    for (double t = 1e-300; t > 0; t /= 10) {
        coin_state r = s;
        feclearexcept(FE_ALL_EXCEPT);
        check(coin_advance_until(&r, &p, t, 1e-6, 0, COIN_SLIPS, NULL) >= 0);
        check(!fetestexcept(TRAPPED));
        r = turning(-0.758, -3.06, 0.03, 884924.3242496);
        check(coin_advance_until(&r, &p, -t, 1e-6, 0, COIN_SLIPS, NULL) >= 0);
        check(!fetestexcept(TRAPPED));
    }
    /* In so large a unit of time the part of a step underflows. */
    const double a = 0x1.54d30dff96fap+39;
    check_status(coin_params_ring(&p, 1, a, a, 1), COIN_OK);
    s = turning(-0x1.76fac7dap+0, 0x1.6cecae32584b9p-33, 0,
                0x1.6a33d9344d10cp-22);
    QUIET(coin_advance_until(&s, &p, -0x1.5274p-1060, 3.3e-13, 0.4, COIN_LIFTS,
                             NULL),
          COIN_OK);
}

static void a_radius_beyond_all_doubles_is_infinite(void **unused)
{
    const coin_params p = disc();
    const coin_state s = turning(1e-300, 0, 5e-324, -5e5);
    double center, contact;
    (void)unused;
    QUIET(coin_steady_radii(&s, &p, &center, &contact), COIN_OK);
    check(isinf(center) && isinf(contact));
}

static void the_least_numbers_are_no_divisors(void **unused)
{
    const coin_params fine = {0x1.9c64p-5,           0x1.e4ea666666666p-40,
                              0x1.7f33333333333p-1,  0x1.71ea1506cd3e1p-84,
                              0x1.71ea1506cd3e1p-83, {0, 0, 0}};
    const coin_params p = disc();
    coin_state s = turning(-0x1p-1074, 0, 0, -0x1.41d60435cf24dp+18);
    coin_orbit o;
    (void)unused;
    QUIET(coin_orbit_init(&o, &s, &fine), COIN_EDOMAIN);
    s = turning(0, 0, 0, 0x1p-1074); /* rolls on in a straight line */
    QUIET(coin_orbit_init(&o, &s, &p), COIN_OK);
    check(isnan(o.center[0]) && isnan(o.radius_max));
}

static void a_ride_round_no_circle_is_quiet(void **unused)
{
    const coin_params p = disc();
    coin_state s;
    (void)unused;
    QUIET(coin_steady_ride(&s, &p, 1, 1e-200), COIN_EDOMAIN);
    QUIET(coin_steady_ride(&s, &p, 1e-200, 1e-200), COIN_OK);
    QUIET(coin_steady_ride(&s, &p, 1, DBL_MAX), COIN_EDOMAIN);
    QUIET(coin_steady_turn(&s, &p, 0.3, DBL_MAX), COIN_EDOMAIN);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_check_takes_any_step_and_any_friction),
        TEST(without_a_step_its_length_does_not_count),
        TEST(trials_of_slips_do_not_run_away),
        TEST(a_slow_fall_on_ice_is_quiet),
        TEST(next_to_flat_pivoting_alone_is_quiet),
        TEST(a_slow_path_through_steady_motions_is_quiet),
        TEST(a_loss_too_strong_for_a_step_is_quiet),
        TEST(a_time_of_no_length_is_looked_at),
        TEST(a_radius_beyond_all_doubles_is_infinite),
        TEST(the_least_numbers_are_no_divisors),
        TEST(a_ride_round_no_circle_is_quiet),
    };
    return RUN_TESTS(tests);
}
