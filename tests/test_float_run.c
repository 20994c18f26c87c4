/* SPDX-License-Identifier: MIT */
/* What coinf.h refuses, and that it then changes nothing. */
#include "support/check.h"
#include "support/coins.h"
#include "support/floats.h"
#include "support/random.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* What *done holds where a call must leave it alone. */
#define UNTOUCHED 0x5555555555555555

static const coinf_params body = {1, 1, 1, 0.25f, 0.5f, 0, {0, 0}};
static const coinf_state good = {0.5f, 1, 2, 3, 4, 0.1f, 0.8f, 1.2f, {0}};

/* --------------------------------------------------------------- bad input */
/* Every way to move a state; each must refuse in the same way. */
static int32_t move(int how, coinf_state *s, float dt, uint64_t *done)
{
    if (how == 0)
        return coinf_step(s, &body, dt);
    return coinf_run(s, &body, COIN_RK4, dt, 3, done);
}

static void refused(const coinf_state *s, float dt, int32_t want)
{
    for (int how = 0; how < 2; ++how) {
        coinf_state moved = *s;
        uint64_t done = UNTOUCHED;
        check_status(move(how, &moved, dt, &done), want);
        check_same(&moved, s, sizeof moved);
        check(done == UNTOUCHED);
    }
}

TEST(unknown_methods_are_refused)
{
    const int32_t unknown[] = {-1, COIN_RK8, COIN_SYMPLECTIC2, COIN_SYMPLECTIC4,
                               4,  1000};
    coinf_state s = good;
    for (size_t i = 0; i < sizeof unknown / sizeof *unknown; ++i) {
        check_note("method %d", (int)unknown[i]);
        check_status(coinf_run(&s, &body, unknown[i], 0.01f, 1, NULL),
                     COIN_EARG);
        check_status(coinf_check(&s, &body, unknown[i], 0.01f, 1), COIN_EARG);
    }
    check_same(&s, &good, sizeof s);
}

/* Without a step, which would be refused as too long. */
TEST(a_step_is_at_most_1e6_natural_units)
{
    coinf_params p;
    check_status(coinf_params_disc(&p, 1, 1, 1), COIN_OK);
    for (int sign = -1; sign <= 1; sign += 2) {
        coinf_state s = good;
        check_status(
            coinf_run(&s, &p, COIN_RK4, (float)sign * 0.9995e6f, 0, NULL),
            COIN_OK);
        check_status(
            coinf_run(&s, &p, COIN_RK4, (float)sign * 1.0005e6f, 0, NULL),
            COIN_ESTEP);
    }
}

TEST(bad_states_are_refused)
{
    const struct {
        size_t member; /* low follows the members */
        float value;
    } bad[] = {
        {0, 1.57079637f}, {0, -1.57079637f}, {0, NAN},       {1, 4097},
        {1, NAN},         {2, -4097},        {2, INFINITY},  {3, NAN},
        {4, -INFINITY},   {5, NAN},          {5, 1e10f},     {6, INFINITY},
        {6, -1e10f},      {7, NAN},          {7, 1e20f},     {8, 1e-6f},
        {9, -1e-6f},      {10, 2e-6f},       {8, NAN},       {11, NAN},
        {12, INFINITY},   {13, -INFINITY},   {15, INFINITY},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        coinf_state s = good;
        memcpy((char *)&s + 4 * bad[i].member, &bad[i].value, 4);
        check_note("member %zu: %g", bad[i].member, bad[i].value);
        check_status(coinf_state_check(&s, &body), COIN_ESTATE);
        refused(&s, 0.01f, COIN_ESTATE);
        /* Without parameters a rate up to 1e11 is that of some coin. */
        float R[9];
        check_status(coinf_axes(&s, R),
                     fabsf(bad[i].value) == 1e10f ? COIN_OK : COIN_ESTATE);
    }
}

TEST(a_state_at_the_edge_of_the_range_is_accepted)
{
    const coinf_state edge = {1.57079625f, 4096, -4096, 1e6f,   -1e6f,
                              0,           0,    0,     {9e-7f}};
    coinf_state s = edge;
    check_status(coinf_state_check(&edge, &body), COIN_OK);
    check_status(coinf_step(&s, &body, 0), COIN_OK);
    check_same(&s, &edge, sizeof s);
}

TEST(times_that_are_not_finite_are_refused)
{
    const float bad[] = {NAN, INFINITY, -INFINITY};
    for (int i = 0; i < 3; ++i) {
        refused(&good, bad[i], COIN_ESTEP);
        check_status(coinf_check(&good, &body, COIN_RK4, bad[i], 1),
                     COIN_ESTEP);
    }
}

/* ------------------------------------------------------------------- limits */
TEST(a_time_of_0_and_0_steps_change_nothing)
{
    const coinf_state before = {0.5f, 4000, -0.0f, 3, 4, 1, 1, 1, {1e-9f}};
    coinf_state s = before;
    uint64_t done = 0;
    check_status(coinf_run(&s, &body, COIN_RK4, 0.1f, 0, NULL), COIN_OK);
    check_status(coinf_run(&s, &body, COIN_RK4, 0, 7, &done), COIN_OK);
    check(done == 7);
    check_status(coinf_step(&s, &body, -0.0f), COIN_OK);
    check_same(&s, &before, sizeof s);
}

/* |dt| W at the start is units. */
static int32_t step_of(float units)
{
    const coinf_state upright = {0, 0, 0, 0, 0, 0, 0, sqrtf(3), {0}};
    coinf_state s = upright;
    return coinf_step(&s, &body, units / 2);
}

TEST(coarse_steps_are_reported_and_coarser_ones_refused)
{
    check_status(step_of(0.349f), COIN_OK);
    check_status(step_of(0.351f), COIN_COARSE);
    check_status(step_of(-1.19f), COIN_COARSE);
    check_status(step_of(1.21f), COIN_ESTEP);
    check_status(step_of(1e30f), COIN_ESTEP);
}

/* Steps near the limit: where one ends, W may not be beyond it either, but for
 * the error of the last stage, which stands for the end. */
TEST(a_step_does_not_end_far_beyond_the_limit)
{
    struct random r = random_begin(65);
    int refused = 0;
    for (int i = 0; i < 4000; ++i) {
        const coinf_params p = {1, 1, 0.01f, 0.25f, 0.5f, 0, {0, 0}};
        const coin_params d = doubles_params(&p);
        const coin_state from = random_state(&r, &d, 0.5);
        const double most = 1.2;
        const float dt = (float)(0.99 * most / fastest_rate(&from, &d));
        coinf_state s = floats_state(&from);
        if (coinf_step(&s, &p, dt) < 0) {
            ++refused;
            continue;
        }
        const double w2 =
            (double)s.wX * s.wX + (double)s.wY * s.wY + (double)s.wZ * s.wZ;
        check_within(dt * sqrt(w2), 0, most * 1.000001);
        check_status(coinf_state_check(&s, &p), COIN_OK);
    }
    check_within(refused, 400, 3990);
}

/* Rates at the edge of what a state may have stay within. */
TEST(rates_at_the_edge_of_their_range_stay_within_it)
{
    struct random r = random_begin(66);
    int moved = 0;
    for (int i = 0; i < 500; ++i) {
        const double angle = random_between(&r, 0, 6.28);
        const double edge = random_between(&r, 0.95, 1) * 1e3;
        coinf_state s = {0, 0, 0, 0, 0, 0, 0, 0, {0}};
        s.theta = (float)random_between(&r, -1, 1);
        s.wX = (float)(edge * sin(angle));
        s.wY = (float)(edge * cos(angle));
        s.wZ = (float)(edge * cos(angle));
        if (i % 2) { /* wZ grows by up to 1.3 */
            s.wX = s.wY = 100;
            s.wZ = (float)random_between(&r, 999, 1000);
        }
        if (coinf_state_check(&s, &body) != COIN_OK)
            continue;
        moved += coinf_step(&s, &body, 2e-4f) >= 0;
        check_status(coinf_state_check(&s, &body), COIN_OK);
    }
    check_within(moved, 20, 480);
}

/* Through a pass near flat and up again: a step is coarse if it begins or ends
 * beyond the limit.  The last stage stands for the end, to a part in 20. */
TEST(a_step_is_coarse_if_it_begins_or_ends_above_the_limit)
{
    const coin_params d = doubles_params(&body);
    const double limit = 0.35;
    int down = 0, up = 0, fine = 0;
    for (float dt = 0.004f; dt < 0.1f; dt *= 1.07f) {
        coinf_state s = {0.3f, 0, 0, 0, 0, 0, 0.1f, 0.1f, {0}};
        for (float t = 0; t < 5; t += dt) {
            const coin_state from = doubles_state(&s);
            const int32_t status = coinf_step(&s, &body, dt);
            const coin_state to = doubles_state(&s);
            const double begin = dt * fastest_rate(&from, &d) / limit;
            const double end = dt * fastest_rate(&to, &d) / limit;
            check_note("dt = %g, %g to %g", dt, begin, end);
            if (status < 0)
                break;
            if (begin > 1.0001 || end > 1.05)
                check_status(status, COIN_COARSE);
            if (begin < 0.9999 && end < 0.95)
                check_status(status, COIN_OK);
            down += begin < 0.9999 && end > 1.05;
            up += begin > 1.0001 && end < 0.95;
            fine += begin < 0.9999 && end < 0.95;
        }
    }
    check(down > 0 && up > 0 && fine > 0);
}

/* From rest at 1.5 rad a step of 0.9 leads through the table; and a step that
 * ends nearer to pi/2 than half the last digit is refused by the digit. */
TEST(a_step_through_the_table_is_refused)
{
    const coinf_state low = {1.5f, 0, 0, 0, 0, 0, 0, 0, {0}};
    const coinf_state edge = {1.57079625f, 0, 0, 0, 0, 0.012f, 0, 0, {5e-8f}};
    coinf_state s = low;
    check_status(coinf_step(&s, &body, 0.9f), COIN_ESTEP);
    check_same(&s, &low, sizeof s);
    s = edge;
    check_status(coinf_step(&s, &body, 1e-6f), COIN_ESTEP);
    check_same(&s, &edge, sizeof s);
    check(coinf_step(&s, &body, 1e-7f) >= 0);
}

/* A coin that falls flat, at t = 2.6895: test_limits. */
TEST(a_fall_ends_above_the_table_with_its_progress)
{
    for (int side = -1; side <= 1; side += 2)
        for (float dt = 0.1f; dt > 1e-4f; dt /= 4) {
            const coinf_state start = {
                (float)side * 0.3f, 0, 0, 0, 0, 0, 0, 0, {0}};
            coinf_state s = start, again = start;
            uint64_t done = UNTOUCHED;
            check_note("dt = %g", dt);
            check_status(coinf_run(&s, &body, COIN_RK4, dt, 1000000, &done),
                         COIN_ESTEP);
            check_within((double)done * dt, 2.6895 - 40 * dt, 2.6895);
            check_status(coinf_state_check(&s, &body), COIN_OK);
            /* The state is that of so many good steps. */
            check(coinf_run(&again, &body, COIN_RK4, dt, done, NULL) >= 0);
            check_same(&again, &s, sizeof s);
            check_status(coinf_run(&s, &body, COIN_RK4, 1e3f, 2, &done),
                         COIN_ESTEP);
            check(done == 0);
            check_same(&again, &s, sizeof s);
        }
}

TEST(a_place_out_of_range_is_not_reached)
{
    const coinf_state start = {0, 0, 0, -1e6f, 1e6f, 0, 0, 1, {0}};
    const coinf_state near[] = {
        {0, 0, 0, -999990, 0, 0, 0, 1, {0}},
        {0, 1.5707964f, 0, 0, 999990, 0, 0, 1, {0}},
    };
    coinf_state s = start;
    uint64_t done = UNTOUCHED;
    check_status(coinf_state_check(&s, &body), COIN_OK);
    check_status(coinf_run(&s, &body, COIN_RK4, 0.1f, 3, &done), COIN_ERANGE);
    check(done == 0);
    check_same(&s, &start, sizeof s);
    for (int along_z = 0; along_z < 2; ++along_z) {
        s = near[along_z];
        check_status(coinf_run(&s, &body, COIN_RK4, 0.125f, 100, &done),
                     COIN_ERANGE);
        check(done == 80);
        check_status(coinf_state_check(&s, &body), COIN_OK);
        check_status(coinf_step(&s, &body, 0.125f), COIN_ERANGE);
    }
    coinf_params large = body;
    large.radius = 2;
    s = start;
    check_status(coinf_step(&s, &large, 0.1f), COIN_OK);
}
