/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/far.h"
#include "support/scene.h"

#include <math.h>

enum { SAMPLES = 12 };

static const coin_state untouched = {-1, -2, -3, -4, -5, -6, -7, -8};

static struct scene scene;

FIRST(load)
{
    scene_load(&scene, "generic");
}

static int32_t run(coin_state *s, double dt, uint64_t steps, uint64_t *done)
{
    return coin_run(s, &scene.params, COIN_RK4, dt, steps, done);
}

TEST(samples_have_the_bits_of_a_run)
{
    const coin_state start = scene_state(&scene, 0);
    coin_state out[SAMPLES];
    size_t done = 0;
    check_status(coin_sample(&start, &scene.params, COIN_RK4, 0.05, 7, SAMPLES,
                             out, &done),
                 COIN_OK);
    check(done == SAMPLES);
    for (uint64_t k = 0; k < SAMPLES; ++k) {
        coin_state s = start;
        check_status(run(&s, 0.05, 7 * k, NULL), COIN_OK);
        check_note("sample %d", (int)k);
        check_same(&out[k], &s, sizeof s);
    }
}

TEST(samples_of_the_longest_and_the_shortest_steps)
{
    const coin_state start = scene_state(&scene, 0);
    coin_state out[2];
    check_status(
        coin_sample(&start, &scene.params, COIN_RK4, 1e-200, 7, 2, out, NULL),
        COIN_OK);
    check(out[1].theta == start.theta && out[1].wZ == start.wZ);
    check_status(
        coin_sample(&start, &scene.params, COIN_RK4, 1e200, 7, 2, out, NULL),
        COIN_ESTEP);
}

TEST(samples_may_start_in_their_own_array)
{
    const coin_state start = scene_state(&scene, 0);
    coin_state want[SAMPLES], out[SAMPLES];
    check_status(coin_sample(&start, &scene.params, COIN_RK4, 0.05, 3, SAMPLES,
                             want, NULL),
                 COIN_OK);
    for (int k = 0; k < SAMPLES; ++k) {
        out[k] = start;
        check_status(coin_sample(&out[k], &scene.params, COIN_RK4, 0.05, 3,
                                 SAMPLES, out, NULL),
                     COIN_OK);
        check_note("start in out[%d]", k);
        check_same(out, want, sizeof out);
    }
}

TEST(there_may_be_no_samples_or_samples_at_one_time)
{
    const coin_state start = scene_state(&scene, 0);
    coin_state out[3] = {untouched, untouched, untouched};
    size_t done = 77;
    check_status(
        coin_sample(&start, &scene.params, COIN_RK4, 0.05, 9, 0, out, &done),
        COIN_OK);
    check(done == 0);
    check_same(&out[0], &untouched, sizeof untouched);
    done = 77;
    check_status(
        coin_sample(&start, &scene.params, COIN_RK4, 0.05, 9, 0, NULL, &done),
        COIN_OK);
    check(done == 0);
    check_status(
        coin_sample(&start, &scene.params, COIN_RK4, 0.05, 0, 2, out, &done),
        COIN_OK);
    check(done == 2);
    check_same(&out[0], &start, sizeof start);
    check_same(&out[1], &start, sizeof start);
    check_same(&out[2], &untouched, sizeof untouched);
}

/* Without momentum to turn it, a leaning coin meets the table. */
static const coin_state falling = {0.3, 1, 2, 3, 4, 0, 0, 0};

TEST(samples_that_fail_keep_those_before)
{
    coin_state out[SAMPLES];
    size_t done = 77;
    for (int k = 0; k < SAMPLES; ++k)
        out[k] = untouched;
    check_status(coin_sample(&falling, &scene.params, COIN_RK4, 0.01, 50,
                             SAMPLES, out, &done),
                 COIN_ESTEP);
    check_within((double)done, 5, 7);
    for (uint64_t k = 0; k < SAMPLES; ++k) {
        coin_state s = falling;
        check_note("sample %d", (int)k);
        if (k < done)
            check_status(run(&s, 0.01, 50 * k, NULL), COIN_OK);
        check_same(&out[k], k < done ? &s : &untouched, sizeof s);
    }
}

/* A steady spin at the limit of dt: rounding leads over it after 67 steps. */
TEST(samples_end_where_a_run_is_refused)
{
    const coin_state start = {.theta = 0x1.cb3e675948dc6p-1,
                              .wY = 0x1.94719754babe7p+0};
    const double dt = 0x1.b218344415537p-2;
    coin_params p;
    coin_state s = start, out[200];
    uint64_t steps;
    size_t samples;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    check_status(coin_run(&s, &p, COIN_RK4, dt, 200, &steps), COIN_ESTEP);
    check_status(coin_sample(&start, &p, COIN_RK4, dt, 1, 200, out, &samples),
                 COIN_ESTEP);
    check(steps == 67 && samples == 68);
    check_same(&out[67], &s, sizeof s);
}

TEST(samples_stop_before_a_place_out_of_range)
{
    coin_params p;
    double dt;
    const coin_state edge = far_coin(&p, 0, &dt);
    coin_state out[20];
    size_t done = 77;
    for (int k = 0; k < 20; ++k)
        out[k] = untouched;
    check_status(coin_sample(&edge, &p, COIN_RK4, dt, 1, 20, out, &done),
                 COIN_ERANGE);
    check(done == 12);
    for (size_t k = 0; k < 20; ++k) {
        check_note("sample %zu", k);
        if (k < done)
            check_status(coin_state_check(&out[k], &p), COIN_OK);
        else
            check_same(&out[k], &untouched, sizeof untouched);
    }
}

/* In a run of one step that ends at the table but for less than a rounding. */
TEST(a_sample_at_the_table_is_the_last_lean_above_it)
{
    const double last = nextafter(acos(0), 0);
    for (int side = -1; side <= 1; side += 2) {
        const coin_state edge = {.theta = side * last, .wX = side * 1.5e-4};
        coin_state s = edge, out[2];
        check_status(run(&s, 1e-12, 1, NULL), COIN_COARSE);
        check_status(
            coin_sample(&edge, &scene.params, COIN_RK4, 1e-12, 1, 2, out, NULL),
            COIN_COARSE);
        check(s.theta == side * last && out[1].theta == side * last);
    }
}

TEST(bad_arguments_touch_no_sample)
{
    const coin_params good = scene.params;
    coin_params bad = good;
    bad.gravity = -1;
    const coin_state fine = {0.5, 0, 0, 0, 0, 1, 1, 1};
    const coin_state flat = {2, 0, 0, 0, 0, 1, 1, 1};
    const struct {
        const coin_state *s;
        const coin_params *p;
        int32_t method;
        double dt;
        int32_t want;
    } cases[] = {
        {&flat, &bad, -1, NAN, COIN_EARG},
        {&flat, &bad, COIN_RK4, NAN, COIN_EPARAMS},
        {&flat, &good, COIN_RK4, NAN, COIN_ESTATE},
        {&fine, &good, COIN_RK4, NAN, COIN_ESTEP},
        {&fine, &good, COIN_RK4, -INFINITY, COIN_ESTEP},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i)
        for (size_t count = 0; count < 2; ++count) {
            coin_state out = untouched;
            size_t done = 77;
            check_note("case %zu, %zu samples", i, count);
            check_status(coin_sample(cases[i].s, cases[i].p, cases[i].method,
                                     cases[i].dt, 1, count, &out, &done),
                         cases[i].want);
            check_same(&out, &untouched, sizeof out);
            check(done == 77);
        }
}

#undef TEST
