/* SPDX-License-Identifier: MIT */
/* Which motions have an orbit: near the table, near a separatrix, nearly
 * critical. */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"
#include "support/orbits.h"
#include "support/random.h"

#include <float.h>
#include <math.h>

#define HALF_PI 1.5707963267948966

static double sign_of(struct random *r)
{
    return random_between(r, -1, 1) < 0 ? -1 : 1;
}

static double of_decades(struct random *r, double low, double high)
{
    return pow(10, random_between(r, low, high));
}

/* ------------------------------------------------------- near the table -- */
/* Within and after passes from 6e-3 to 5e-7 rad off the table; rates change by
 * W where angles change by 1. */
TEST(passes_are_where_the_reference_is)
{
    struct table t;
    table_load(&t, "flats.csv");
    check(t.rows == 24 * 6);
    for (size_t row = 0; row < t.rows; ++row) {
        const coin_params p = ring(table_at(&t, row, "b"));
        const coin_state s = start_in_row(&t, row);
        const coin_state want = state_in_row(&t, row);
        const double W = table_at(&t, row, "W"), at = table_at(&t, row, "t");
        const coin_orbit o = orbit_of(&s, &p);
        coin_state now;
        check_status(coin_orbit_at(&o, at, &now), COIN_OK);
        const double bound = orbit_error(&o, at, W);
        check_note("flats.csv, row %zu, %g rad off the table", row,
                   table_at(&t, row, "d"));
        check_pose(&o, at, W, &want, &p);
        check_near(states_apart(&now, &want, &p), 0, 2 * W * bound);
    }
}

/* LEAN_MAX of orbit.c is 1e-9 rad from flat. */
TEST(an_orbit_that_turns_within_1e_9_of_flat_is_refused)
{
    const coin_params p = ring(0);
    coin_orbit o;
    for (int sign = -1; sign <= 1; sign += 2) {
        coin_state s = {sign * (HALF_PI - 1.1e-9), 0, 0, 0, 0, 0, 1e-3, 0};
        check_status(coin_orbit_init(&o, &s, &p), COIN_OK);
        s.theta = sign * (HALF_PI - 0.9e-9);
        check_status(coin_orbit_init(&o, &s, &p), COIN_EDOMAIN);
    }
}

/* It turns at a distance d from flat, and is asked for there or elsewhere. */
static coin_state pass_of(struct random *r, const coin_params *p, double d)
{
    const double fast = sqrt((1 + p->inertia_X) / p->inertia_X);
    const coin_state s = {
        sign_of(r) * (HALF_PI - d),
        0,
        0,
        0,
        0,
        0,
        sign_of(r) * fast * random_between(r, 0.2, 1.5),
        random_between(r, -1, 1),
    };
    return s;
}

/* At most 1 in 100 is refused down to 1e-6; found: none. */
TEST(passes_down_to_a_millionth_have_orbits)
{
    const int count = tries_asked(300);
    struct random r = random_begin(101);
    int refused = 0, drops = 0;
    for (int i = 0; i < count; ++i) {
        const coin_params p = ring(random_between(&r, 0, 1));
        const double d = of_decades(&r, -6, -2);
        coin_state s = pass_of(&r, &p, d);
        const double t = random_between(&r, 0.1, 1);
        coin_orbit o;
        check_status(coin_advance(&s, &p, t, 1e-12, NULL), COIN_OK);
        check_note("%g rad off the table", d);
        if (coin_orbit_init(&o, &s, &p) != COIN_OK) {
            ++refused;
            continue;
        }
        ++drops;
        const double low = HALF_PI - o.theta_max, up = HALF_PI + o.theta_min;
        check(fmin(low, up) < 1.001 * d + 1e-11);
    }
    check(refused <= 0.01 * count && drops >= 0.99 * count);
}

/* One piece more than an orbit has. */
TEST(a_motion_of_43_pieces_is_refused)
{
    const coin_params p = {1, 1, 1, 1e-3, 2e-3, 0, {0, 0}};
    const coin_state s = {
        .theta = 0x1.49f6622f314c7p-6,
        .wX = 0x1.1770b331e285dp+0,
        .wY = 0x1.a4121b8bbdc9bp-5,
        .wZ = -0x1.51a766fd80bfap-4,
    };
    coin_orbit o;
    check_status(coin_orbit_init(&o, &s, &p), COIN_EDOMAIN);
}

/* As many as it has, all of them before the start. */
TEST(a_motion_of_42_pieces_has_an_orbit)
{
    const coin_params p = {1, 1, 1, 1e-3, 2e-3, 0, {0, 0}};
    const coin_state start = {
        .theta = -0x1.87856c77c48d1p+0,
        .wX = -0x1.6c04126da345p-5,
        .wY = 0x1.d08aa4891d563p+3,
        .wZ = -0x1.d9373bce8a5p+0,
    };
    coin_orbit o;
    check_status(coin_orbit_init(&o, &start, &p), COIN_OK);
    for (int i = -3; i <= 3; ++i) {
        coin_state s = start, at;
        const double t = i * o.period / 8;
        check_status(coin_advance(&s, &p, t, 1e-12, NULL), COIN_OK);
        check_status(coin_orbit_at(&o, t, &at), COIN_OK);
        check_note("at %d eighths of the period", i);
        check_within(path_apart(&at, &s, &p), 0, 1e-12); /* tol */
    }
}

/* ----------------------------------------------------- near separatrices -- */
/* A steady motion that is unstable has none, however it is rounded. */
TEST(no_unstable_circle_has_an_orbit)
{
    const coin_params p0 = disc();
    const coin_state found = {
        .theta = 0x1.2b2b35156f79p-4,
        .wY = 0x1.46e8ae0f04f6cp-2,
        .wZ = 0x1.301e493b7c7d3p-3,
    };
    struct random r = random_begin(102);
    coin_orbit o;
    check_status(coin_orbit_init(&o, &found, &p0), COIN_EDOMAIN);
    for (int seen = 0; seen < 10000;) {
        const coin_params p = ring(random_between(&r, 0, 1));
        const double theta = sign_of(&r) * of_decades(&r, -5, -0.45);
        const double wZ = sign_of(&r) * of_decades(&r, -2, -0.15);
        const int branch = (int)sign_of(&r), ulps = seen % 3 - 1;
        coin_state s;
        double lambda2;
        check_status(coin_steady_circle(&s, &p, theta, wZ, branch), COIN_OK);
        check_status(coin_stability(&s, &p, &lambda2), COIN_OK);
        if (!(lambda2 > 0))
            continue;
        s.wY += ulps * DBL_EPSILON * s.wY;
        check_note("theta = %a, wY = %a, wZ = %a", s.theta, s.wY, s.wZ);
        check_status(coin_orbit_init(&o, &s, &p), COIN_EDOMAIN);
        ++seen;
    }
}

/* Upright and slow it stands on the top of a hill: for a lean ten times less,
 * a period that rounds a hundred times worse, up to the documented limit. */
TEST(conditioning_is_refused_from_1e12_on)
{
    const coin_params p = disc();
    int refused = 0;
    double last = 0;
    for (double lean = 1e-5; lean > 1e-7; lean *= 0.99) {
        const coin_state s = {.theta = lean, .wZ = 0.3};
        coin_orbit o;
        const int32_t status = coin_orbit_init(&o, &s, &p);
        check(status == (refused ? COIN_EDOMAIN : status));
        refused = status != COIN_OK;
        last = refused ? last : o.conditioning;
        if (!refused)
            check_near(o.conditioning * lean * lean, 1.75, 0.02);
    }
    check(refused);
    check_within(last, 0.97e12, 1e12);
}

/* 1 + J/2 |dT/dE| s^2/w: the period is asked for with a little more and less of
 * wX; here s is the acceleration at the upper turning point. */
TEST(conditioning_is_what_the_period_owes_to_energy)
{
    const coin_params p = disc();
    const double J = 1.25;
    const struct {
        coin_state s;
        int is_flat;
    } from[] = {
        {{.theta = 0.5, .wX = 0.1, .wY = 0.8, .wZ = 1.2}, 0},
        {{.theta = -0.4, .wX = 0.2, .wY = 0.6, .wZ = -1.5}, 0},
        {{.theta = 0.4, .wX = 0.5, .wY = 0.02, .wZ = 0.02}, 1},
        {{.theta = 1e-2, .wX = 0.02, .wZ = 0.3}, 0},
    };
    for (size_t i = 0; i < sizeof from / sizeof *from; ++i) {
        const coin_state s = from[i].s;
        const coin_orbit o = orbit_of(&s, &p);
        const double step = 1e-4 * s.wX, w2 = 2 * coin_energy(&s, &p) / J;
        coin_state more = s, less = s, at, rates;
        more.wX += step;
        less.wX -= step;
        const double dT =
            orbit_of(&more, &p).period - orbit_of(&less, &p).period;
        double greatest = 0;
        for (int k = 0; k < 20000; ++k) {
            check_status(coin_orbit_at(&o, k * o.period / 20000, &at), COIN_OK);
            check_status(coin_rates(&at, &p, &rates), COIN_OK);
            if (fabs(at.wX) < 1e-3)
                greatest = fmax(greatest, fabs(rates.wX));
        }
        const double a = from[i].is_flat ? w2 : greatest;
        const double want = fabs(dT) / (4 * s.wX * step) * a * a / sqrt(w2);
        check_note("start %zu", i);
        check_near(o.conditioning - 1, want, 0.1 * want);
    }
}

/* There the rounding of the terms of (14) is more than lambda^2 times the
 * rounding of the lean. */
TEST(a_nearly_critical_circle_has_no_period)
{
    const coin_state circles[] = {
        {.theta = 0x1.12f1fa4752f24p-2,
         .wY = 0x1.6f7f1715de113p-2,
         .wZ = 0x1.e7c66527cf8c8p-2},
        {.theta = 0x1.4d21c0fbc751dp-2,
         .wY = 0x1.044ea862b99b1p-1,
         .wZ = 0x1.8fe4bd0f1fc98p-2},
        {.theta = 0x1.84581e2c7122fp-5,
         .wY = 0x1.c00045a1733acp-5,
         .wZ = 0x1.278c641c4f18cp-1},
    };
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    for (int i = 0; i < 3; ++i) {
        double lambda2;
        check_status(coin_stability(&circles[i], &p, &lambda2), COIN_OK);
        check_within(lambda2, -0.02, -1e-3);
        check(orbit_of(&circles[i], &p).period == 0);
    }
}

/* However fast the lean of a critical roll or spin changes, the acceleration
 * and its slope are 0: it is no steady motion. */
TEST(a_critical_motion_with_a_swing_has_its_orbit)
{
    coin_params hoop;
    check_status(coin_params_ring(&hoop, 1, 1, 1, 1), COIN_OK);
    const coin_state starts[] = {{.wX = 0.5, .wZ = 0.5},
                                 {.wX = 0.5, .wY = 0x1.a20bd700c2c3ep-1}};
    for (int i = 0; i < 2; ++i) {
        coin_orbit o;
        coin_state at, want = starts[i];
        check_status(coin_orbit_init(&o, &starts[i], &hoop), COIN_OK);
        check_status(coin_orbit_at(&o, 20, &at), COIN_OK);
        check_status(coin_advance(&want, &hoop, 20, 1e-13, NULL), COIN_OK);
        check(o.period > 0);
        check_near(at.theta, want.theta, 1e-10);
        check_near(at.phi, want.phi, 1e-10);
    }
    const coin_state still = {.wZ = 0.5};
    coin_orbit o;
    check_status(coin_orbit_init(&o, &still, &hoop), COIN_OK);
    check(o.period == 0);
}

/* Next to a critical circle the well is narrower than the swing. */
TEST(a_motion_that_leaves_its_well_is_no_steady_one)
{
    const coin_params p = disc();
    const coin_state s = {.theta = 0.2,
                          .wX = -7.1538958204644815e-12,
                          .wY = 0.24701661032105193,
                          .wZ = 0.52783800126792757};
    coin_orbit o;
    const int32_t status = coin_orbit_init(&o, &s, &p);
    check(status == COIN_EDOMAIN || o.period > 0);
}

/* The sign of wX says towards which turning point the lean goes. */
TEST(the_least_wX_has_the_period_of_0)
{
    const coin_params p = disc();
    coin_state s = {.theta = 0.5, .wY = 0.8, .wZ = 1.2};
    coin_orbit still, slow;
    check_status(coin_orbit_init(&still, &s, &p), COIN_OK);
    for (s.wX = 1e-300; s.wX > 0; s.wX *= 1e-4) {
        check_note("wX %g", s.wX);
        check_status(coin_orbit_init(&slow, &s, &p), COIN_OK);
        check_near(slow.period, still.period, 1e-13);
    }
}
