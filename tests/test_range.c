/* SPDX-License-Identifier: MIT */
/* The ranges that coin.h and coinf.h state, at their edges: a little within is
 * accepted, a little beyond refused. */
#include "support/check.h"
#include "support/coins.h"
#include "support/floats.h"
#include "support/methods.h"
#include "support/random.h"
#include "support/slides.h"

#include <coinf.h>

#include <math.h>

/* --------------------------------------------------------- heading and roll */
/* So many blocks that a run is far from the edge at first, where no step is
 * looked at alone. */
enum { BLOCKS = 6, STEPS = 64 * BLOCKS };

/* Upright at 1000 rad per unit of time, 0.9 rad a step, gap before 2^31, or
 * before -2^31 if side is -1: in heading, or in roll. */
static coin_state near_the_edge(int rolls, double gap, int side)
{
    coin_state s = {0, 0, 0, 0, 0, 0, 0, 0};
    *(rolls ? &s.psi : &s.phi) = side * (0x1p31 - gap);
    *(rolls ? &s.wZ : &s.wY) = side * 1000;
    return s;
}

static const double turn = 0.9; /* of a step [rad] */

/* Each turn is exact to the angle's last place, 2^-22; gaps keep a tenth of a
 * radian away from whole steps. */
static double gap_of(int steps)
{
    return turn * steps + 0.1;
}

/* Just so many steps are done, and the state is where they lead. */
static void check_end(const coin_state *from, const coin_params *p,
                      int32_t method, double dt, uint64_t fit)
{
    coin_state s = *from, again = *from;
    uint64_t done = 0;
    check_status(coin_run(&s, p, method, dt, STEPS, &done), COIN_ERANGE);
    check(done == fit);
    check_status(coin_state_check(&s, p), COIN_OK);
    check(coin_run(&again, p, method, dt, fit, NULL) >= 0);
    check_same(&s, &again, sizeof s);
}

TEST(a_run_stops_where_an_angle_leaves_its_range)
{
    const coin_params p = disc();
    for (int32_t method = 0; method < METHODS; ++method)
        for (int fit = 0; fit < STEPS; fit += 5)
            for (int rolls = 0; rolls < 2; ++rolls) {
                const int side = fit % 2 ? -1 : 1;
                const coin_state s = near_the_edge(rolls, gap_of(fit), side);
                check_note("method %d, %d steps fit", (int)method, fit);
                check_end(&s, &p, method, turn / 1000, (uint64_t)fit);
            }
}

/* A body of small I_Z rolls far in a step. */
TEST(a_body_of_any_I_Z_is_told_that_its_roll_ends)
{
    for (double I_Z = 1; I_Z > 0.9e-3; I_Z /= 10) {
        coin_params p;
        check_status(coin_params_body(&p, 1, 1, 1, 0.99, I_Z), COIN_OK);
        const coin_table rough = {.mu_static = 0.5, .mu_kinetic = 0.5};
        coin_state s = {.psi = 0x1p31 - 1000, .wZ = 100};
        coin_body d;
        double at;
        check_note("I_Z = %g", I_Z);
        check_status(coin_body_from_state(&d, &s, &p), COIN_OK);
        check_status(coin_advance(&s, &p, 20, 1e-9, &at), COIN_ERANGE);
        check_within(at, 9.8, 10);
        check_status(slide(&d, &p, &rough, NULL, 20, 1e-9, &at), COIN_ERANGE);
    }
}

/* ------------------------------------------------------------------- places */
/* Upright at 1000 sqrt(g/a), 0.9 radii a step, gap radii before x or z ends. */
static coin_state near_the_end(const coin_params *p, int along_z, double gap)
{
    const double far = (1e9 - gap) * p->radius;
    const coin_state s = {
        .phi = along_z ? 1.5707963267948966 : 0,
        .x = along_z ? 0 : -far,
        .z = along_z ? far : 0,
        .wZ = 1000 / natural_time(p),
    };
    return s;
}

TEST(a_run_stops_where_a_place_leaves_its_range)
{
    coin_params p;
    check_status(coin_params_disc(&p, 0.00567, 0.01213, 9.80665), COIN_OK);
    const double dt = turn / 1000 * natural_time(&p);
    for (int32_t method = 0; method < METHODS; ++method)
        for (int fit = 0; fit < STEPS; fit += 5)
            for (int along_z = 0; along_z < 2; ++along_z) {
                const coin_state s = near_the_end(&p, along_z, gap_of(fit));
                check_note("method %d, %d steps fit", (int)method, fit);
                check_end(&s, &p, method, dt, (uint64_t)fit);
            }
}

/* ------------------------------------------------- the table of the ranges */
/* M, a, g. */
static const double units[][3] = {
    {1, 1, 1},
    {0.00567, 0.01213, 9.80665},
    {5670, 12130, 9.80665e6},
    {1e-7, 1e-3, 1e-6},
    {1e7, 1e7, 1e-7},
};
enum { UNITS = sizeof units / sizeof *units };

/* A number at a limit, by this part within it and beyond it: more than the
 * rounding of a comparison. */
#define PART (8 * U)
#define PARTF ((float)(8 * UF))

static int32_t body(const double of[3], double IX, double IZ)
{
    coin_params p;
    coinf_params f;
    const int32_t status = coin_params_body(&p, of[0], of[1], of[2], IX, IZ);
    const int32_t in_floats = coinf_params_body(
        &f, (float)of[0], (float)of[1], (float)of[2], (float)IX, (float)IZ);
    check_status(in_floats, status);
    return status;
}

TEST(mass_radius_and_gravity_have_15_decades_each_way)
{
    coin_params p;
    coinf_params f;
    for (int i = 0; i < 3; ++i)
        for (int high = 0; high < 2; ++high) {
            const double edge = high ? 1e15 : 1e-15;
            const float edgef = high ? 1e8f : 1e-8f;
            double in[3] = {1, 1, 1}, out[3] = {1, 1, 1};
            float inf[3] = {1, 1, 1}, outf[3] = {1, 1, 1};
            in[i] = edge;
            out[i] = nextafter(edge, high ? (double)INFINITY : 0);
            inf[i] = edgef;
            outf[i] = nextafterf(edgef, high ? (float)INFINITY : 0);
            check_note("number %d, %g", i, edge);
            check_status(coin_params_disc(&p, in[0], in[1], in[2]), COIN_OK);
            check_status(coin_params_disc(&p, out[0], out[1], out[2]),
                         COIN_EPARAMS);
            check_status(coinf_params_disc(&f, inf[0], inf[1], inf[2]),
                         COIN_OK);
            check_status(coinf_params_disc(&f, outf[0], outf[1], outf[2]),
                         COIN_EPARAMS);
        }
}

/* In floats the same, which their rounding decides: 1e-6 on either side. */
TEST(inertias_have_3_decades_each_way)
{
    for (int i = 0; i < UNITS; ++i) {
        const double m = units[i][0] * units[i][1] * units[i][1], d = 2e-6;
        check_note("units %d", i);
        check_status(body(units[i], 1e-3 * m * (1 + d), 1e-3 * m), COIN_OK);
        check_status(body(units[i], 1e-3 * m * (1 - d), 1e-3 * m),
                     COIN_EPARAMS);
        check_status(body(units[i], 1e3 * m * (1 - d), 1e3 * m), COIN_OK);
        check_status(body(units[i], 1e3 * m * (1 + d), 1e3 * m), COIN_EPARAMS);
        check_status(body(units[i], m, 1e-3 * m * (1 + d)), COIN_OK);
        check_status(body(units[i], m, 1e-3 * m * (1 - d)), COIN_EPARAMS);
        check_status(body(units[i], m, 2 * m * (1 + 3 * d)), COIN_EPARAMS);
    }
}

TEST(inertias_end_where_the_rounding_of_a_double_does)
{
    coin_params p;
    for (int i = 0; i < UNITS; ++i) {
        const double *of = units[i], m = of[0] * of[1] * of[1];
        const double cases[][3] = {
            /* I_X, I_Z, and which of them is at its limit */
            {1e-3 * m, 1e-3 * m, 0},
            {1e3 * m, 1e3 * m, 0},
            {m, 1e-3 * m, 1},
            {m, 2 * (1 + 1e-12) * m, 1},
        };
        for (int k = 0; k < 4; ++k)
            for (int side = -1; side <= 1; side += 2) {
                const double part = 1 + side * PART, *c = cases[k];
                const int inside = (k % 2 == 0) == (side > 0);
                check_note("units %d, case %d, side %d", i, k, side);
                check_status(coin_params_body(&p, of[0], of[1], of[2],
                                              c[0] * (c[2] > 0 ? 1 : part),
                                              c[1] * (c[2] > 0 ? part : 1)),
                             inside ? COIN_OK : COIN_EPARAMS);
            }
    }
}

TEST(members_of_a_state_have_limits_in_natural_units)
{
    for (int i = 0; i < UNITS; ++i) {
        coin_params p;
        coinf_params f;
        const double *of = units[i];
        check_status(coin_params_disc(&p, of[0], of[1], of[2]), COIN_OK);
        check_status(
            coinf_params_disc(&f, (float)of[0], (float)of[1], (float)of[2]),
            COIN_OK);
        const double w0 = sqrt(p.gravity / p.radius);
        const float w0f = sqrtf(f.gravity / f.radius);
        const double most[] = {0x1p31,         0x1p31,   1e9 * p.radius,
                               1e9 * p.radius, 1e6 * w0, 1e6 * w0,
                               1e6 * w0};
        const float mostf[] = {
            4096,       4096,       1e6f * f.radius, 1e6f * f.radius,
            1e3f * w0f, 1e3f * w0f, 1e3f * w0f};
        for (int k = 0; k < 7; ++k)
            for (int side = -1; side <= 1; side += 2) {
                coin_state s = {0, 0, 0, 0, 0, 0, 0, 0};
                coinf_state t = {0, 0, 0, 0, 0, 0, 0, 0, {0}};
                double *const member = &s.theta + 1 + k;
                float *const memberf = &t.theta + 1 + k;
                check_note("units %d, member %d, side %d", i, k + 1, side);
                *member = side * most[k] * (1 - PART);
                *memberf = (float)side * mostf[k] * (1 - PARTF);
                check_status(coin_state_check(&s, &p), COIN_OK);
                check_status(coinf_state_check(&t, &f), COIN_OK);
                *member = side * most[k] * (1 + PART);
                *memberf = (float)side * mostf[k] * (1 + PARTF);
                check_status(coin_state_check(&s, &p), COIN_ESTATE);
                check_status(coinf_state_check(&t, &f), COIN_ESTATE);
            }
    }
}

/* vx, vy, vz of a body, and y, in the air. */
TEST(motions_of_a_body_have_limits)
{
    for (int i = 0; i < UNITS; ++i) {
        coin_params p;
        check_status(
            coin_params_disc(&p, units[i][0], units[i][1], units[i][2]),
            COIN_OK);
        const double most = 1e6 * sqrt(p.gravity * p.radius);
        for (int k = 0; k < 7; ++k) {
            const double size = k == 6 ? 1e9 * p.radius : most;
            const double side = k % 2 ? -1 : 1;
            double u[3];
            coin_body in = {.y = 2 * p.radius}, out = in;
            const int member = k == 6 ? 0 : 1 + k / 2;
            (&in.y)[member] = side * size * (1 - PART);
            (&out.y)[member] = side * size * (1 + PART);
            check_note("units %d, case %d", i, k);
            check_status(coin_body_contact(&in, &p, u), COIN_OK);
            check_status(coin_body_contact(&out, &p, u), COIN_ESTATE);
        }
    }
}

/* The calls that take a step or a time, of a coin that rolls upright so slowly
 * that it stays where it is. */
static int32_t with_time(int call, const coin_params *p, double t)
{
    coin_state s = {0, 0, 0, 0, 0, 0, 0, 0}, out[2];
    const coin_losses l = {.spin = p->inertia_X * 1e-9 / natural_time(p)};
    const coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.3};
    coin_body d = {.y = p->radius};
    coin_orbit o;
    switch (call) {
    case 0:
        return coin_run(&s, p, COIN_RK8, t, 0, NULL);
    case 1:
        return coin_sample(&s, p, COIN_RK8, t, 0, 2, out, NULL);
    case 2:
        return coin_batch_run(&s, 1, p, COIN_RK8, t, 0, NULL);
    case 3:
        return coin_check(&s, p, COIN_RK8, t, 1) == COIN_COARSE ? COIN_OK
                                                                : COIN_ESTEP;
    case 4:
        return coin_steady_at(&s, p, t, out);
    case 5:
        check_status(coin_orbit_init(&o, &s, p), COIN_OK);
        return coin_orbit_at(&o, t, out);
    case 6:
        return coin_advance(&s, p, t, 1e-2, NULL);
    case 7:
        return coin_settle(&s, p, &l, fabs(t), 1e-2, NULL);
    default:
        return coin_move(&d, p, &f, fabs(t), 1e-2, 0, NULL);
    }
}

/* The movers do not come to the end of so long a time: they are tried beyond it
 * alone, and find 2^20 steps too few within it elsewhere. */
TEST(times_go_to_1e15_natural_units)
{
    for (int i = 0; i < UNITS; ++i) {
        coin_params p;
        check_status(
            coin_params_disc(&p, units[i][0], units[i][1], units[i][2]),
            COIN_OK);
        const double most = 1e15 * natural_time(&p);
        for (int call = 0; call < 9; ++call)
            for (int side = -1; side <= 1; side += 2) {
                check_note("units %d, call %d, side %d", i, call, side);
                if (call < 6)
                    check_status(with_time(call, &p, side * most * (1 - PART)),
                                 COIN_OK);
                check_status(with_time(call, &p, side * most * (1 + PART)),
                             COIN_ESTEP);
            }
    }
}

TEST(tolerances_go_from_1e_minus_13_to_1e_minus_2)
{
    const coin_params p = disc();
    const double in[] = {1e-13, 1e-2};
    const double out[] = {nextafter(1e-13, 0), nextafter(1e-2, 1), NAN};
    coin_state s = {.theta = 0.3, .wZ = 2};
    for (int i = 0; i < 2; ++i)
        check_status(coin_advance(&s, &p, 0.1, in[i], NULL), COIN_OK);
    for (int i = 0; i < 3; ++i)
        check_status(coin_advance(&s, &p, 0.1, out[i], NULL), COIN_EARG);
}

/* Of a disc with these rates wX grows to 1.1e6. */
TEST(a_rate_does_not_leave_its_range)
{
    const coin_params p = disc();
    const double dt = 1e-7;
    for (int32_t method = 0; method < METHODS; ++method) {
        coin_state s = {.theta = 0.3, .wY = 9.5e5, .wZ = 9.5e5}, before, out[2];
        int32_t status;
        uint64_t done = 7;
        size_t samples;
        double reached = 7;
        int steps = 0;
        check_note("method %d", (int)method);
        do {
            before = s;
            status = coin_run(&s, &p, method, dt, 1, &done);
            ++steps;
        } while (status >= 0 && steps < 100);
        check_status(status, COIN_ERANGE);
        check(steps > 1 && done == 0);
        check_same(&s, &before, sizeof s);
        check_status(coin_sample(&s, &p, method, dt, 1, 2, out, &samples),
                     COIN_ERANGE);
        check(samples == 1);
        check_status(coin_batch_run(&s, 1, &p, method, dt, 1, NULL),
                     COIN_ERANGE);
        check_status(coin_step(&s, &p, dt), COIN_ERANGE);
        check_status(coin_advance(&s, &p, dt, 1e-9, &reached), COIN_ERANGE);
        check(reached == 0);
        check_same(&s, &before, sizeof s);
    }
    const coin_losses l = {.spin = 1e-9};
    coin_state s = {.theta = 0.3, .wY = 9.5e5, .wZ = 9.5e5};
    double reached;
    check_status(coin_settle(&s, &p, &l, 1, 1e-9, &reached), COIN_ERANGE);
    check_within(reached, 1e-7, 1e-5);
    check_status(coin_state_check(&s, &p), COIN_OK);
}

/* ------------------------------------------------------------------ statuses
 */
/* A step that is too long by far: what is said of it depends on the place. */
TEST(within_16_rad_or_radii_of_the_end_that_is_said)
{
    const coin_params p = disc();
    for (int i = 0; i < 16; ++i) {
        const int inside = i / 8;
        coin_state s = {.theta = 0.3, .wX = 1, .wY = 1, .wZ = 1}, out[2];
        double *const members[] = {&s.phi, &s.psi, &s.x, &s.z};
        const double end = (i % 4 < 2 ? 0x1p31 : 1e9) - (inside ? 15.9 : 16.1);
        *members[i % 4] = i & 4 ? end : -end;
        const int32_t want = inside ? COIN_ERANGE : COIN_ESTEP;
        check_note("case %d", i);
        check_status(coin_step(&s, &p, 100), want);
        check_status(coin_run(&s, &p, COIN_RK8, 100, 9, NULL), want);
        check_status(coin_sample(&s, &p, COIN_RK4, 100, 1, 2, out, NULL), want);
    }
}

/* Within the limits on W where it begins and ends, it would turn the heading by
 * 3.6 rad on its way past the table. */
TEST(a_step_that_turns_too_far_is_refused)
{
    coin_params p;
    const coin_state start = {-1.485, 0, 0, 0, 0, -21.77, -6.788, 21.26};
    coin_state s = start;
    check_status(coin_params_body(&p, 1, 1, 1, 1.51994, 0.118894), COIN_OK);
    check_status(coin_run(&s, &p, COIN_RK8, 0.0044432, 1, NULL), COIN_ESTEP);
    check_same(&s, &start, sizeof s);
}
