/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/far.h"
#include "support/random.h"
#include "support/scene.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* What *done holds where a call must leave it alone. */
#define UNTOUCHED 0x5555555555555555

static struct scene scene;

FIRST(load)
{
    scene_load(&scene, "generic");
}

static int32_t run(coin_state *s, double dt, uint64_t steps, uint64_t *done)
{
    return coin_run(s, &scene.params, COIN_RK4, dt, steps, done);
}

/* ------------------------------------------------------ what does not move */
TEST(a_time_of_0_and_0_steps_change_nothing)
{
    const struct {
        double dt;
        uint64_t steps;
    } cases[] = {{0.1, 0}, {0, 10}, {-0.0, 10}, {0, 0}, {1e15, 0}};
    const coin_state before = {0.5, -0.0, 2e9, 1e9, -0.0, 0.1, -0.0, 1.2};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coin_state s = before;
        uint64_t done = UNTOUCHED;
        check_note("dt = %g, steps = %d", cases[i].dt, (int)cases[i].steps);
        check_status(run(&s, cases[i].dt, cases[i].steps, &done), COIN_OK);
        check_same(&s, &before, sizeof s);
        check(done == cases[i].steps);
    }
}

TEST(the_smallest_of_times_moves_by_nothing)
{
    const coin_state before = {0.5, 1, 2, 3, 4, 0.1, 0.8, 1.2};
    coin_state s = before;
    check_status(run(&s, 1e-320, 3, NULL), COIN_OK);
    check_same(&s, &before, sizeof s);
}

/* -------------------------------------------------------------- one and many
 */
TEST(a_step_is_a_run_of_one)
{
    coin_state a = scene_state(&scene, 0), b = a;
    uint64_t done;
    check_status(coin_step(&a, &scene.params, 0.05), COIN_OK);
    check_status(run(&b, 0.05, 1, &done), COIN_OK);
    check_same(&a, &b, sizeof a);
    check(done == 1);
}

/* Entering a run anew costs a few ulp: 8 u per step, which the motion then
 * amplifies as the reference says. */
TEST(n_steps_in_one_run_are_n_runs_of_one_step)
{
    const char *const names[] = {"wobble", "generic", "spin",     "circle",
                                 "ring",   "quarter", "ring_b05", "negative"};
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        const size_t row = 5;
        scene_load(&scene, names[i]);
        const double amp = fmax(1, scene_at(&scene, row, "amp"));
        const double T = natural_time(&scene.params);
        const double t = scene_at(&scene, row, "t");
        const int n = (int)ceil(t / (0.1 * T));
        coin_state one = scene_state(&scene, 0), many = one;
        check(coin_run(&one, &scene.params, COIN_RK4, t / n, (uint64_t)n,
                       NULL) >= 0);
        for (int k = 0; k < n; ++k)
            check(coin_step(&many, &scene.params, t / n) >= 0);
        const double bound = 8 * U * n * amp;
        const double path = bound * scene.params.radius;
        check_note("scene %s, %d steps", names[i], n);
        check_near(many.theta, one.theta, bound);
        check_near(many.phi, one.phi, bound);
        check_near(many.psi, one.psi, bound);
        check_near(many.x, one.x, path);
        check_near(many.z, one.z, path);
        check_near(many.wX, one.wX, bound / T);
        check_near(many.wY, one.wY, bound / T);
        check_near(many.wZ, one.wZ, bound / T);
    }
    scene_load(&scene, "generic");
}

/* ---------------------------------------------------------- failing midway */
/* Without momentum to turn it, a leaning coin meets the table. */
static const coin_state falling = {0.3, 1, 2, 3, 4, 0, 0, 0};

TEST(a_run_that_fails_keeps_the_steps_before)
{
    coin_state s = falling, again = falling;
    uint64_t done = UNTOUCHED;
    check_status(run(&s, 0.01, 1000, &done), COIN_ESTEP);
    check_within((double)done, 200, 270);
    check_status(run(&again, 0.01, done, NULL), COIN_COARSE);
    check_same(&s, &again, sizeof s);
    check_status(coin_state_check(&s, &scene.params), COIN_OK);
    done = UNTOUCHED;
    check_status(run(&s, 0.01, 1, &done), COIN_ESTEP);
    check(done == 0);
    check_same(&s, &again, sizeof s);
    check_status(run(&s, 0.01, 5, NULL), COIN_ESTEP);
}

/* ----------------------------------------------------------------- warnings */
/* ------------------------------------------------------------ bad arguments */
TEST(bad_runs_touch_nothing)
{
    const coin_params good = scene.params;
    coin_params bad = good;
    bad.gravity = -1;
    const coin_state fine = {0.5, 0, 0, 0, 0, 1, 1, 1};
    const coin_state flat = {2, 0, 0, 0, 0, 1, 1, 1};
    const struct {
        coin_state s;
        const coin_params *p;
        int32_t method;
        double dt;
        int32_t want;
    } cases[] = {
        {flat, &bad, -1, NAN, COIN_EARG},
        {flat, &bad, 4, NAN, COIN_EARG},
        {flat, &bad, INT32_MAX, NAN, COIN_EARG},
        {flat, &bad, INT32_MIN, NAN, COIN_EARG},
        {flat, &bad, COIN_RK4, NAN, COIN_EPARAMS},
        {flat, &good, COIN_RK4, NAN, COIN_ESTATE},
        {fine, &good, COIN_RK4, NAN, COIN_ESTEP},
        {fine, &good, COIN_RK4, INFINITY, COIN_ESTEP},
        {fine, &good, COIN_RK4, -INFINITY, COIN_ESTEP},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i)
        for (uint64_t n = 0; n < 2; ++n) {
            coin_state s = cases[i].s;
            uint64_t done = UNTOUCHED;
            check_note("case %zu, %d steps", i, (int)n);
            check_status(coin_run(&s, cases[i].p, cases[i].method, cases[i].dt,
                                  n, &done),
                         cases[i].want);
            check_same(&s, &cases[i].s, sizeof s);
            check(done == UNTOUCHED);
        }
}

#undef TEST
