/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/random.h"
#include "support/scene.h"
#include "support/spread.h"

#include <math.h>
#include <stdio.h>

/* Halving the step of an order 4 divides the error by 16; the next order
 * leaves that within an eighth at these steps. */
#define LEAST 14.0
#define MOST 18.0

static struct scene scene;

static double error_with(size_t row, uint64_t steps)
{
    const coin_state s = scene_run(&scene, row, steps);
    return scene_error(&scene, row, &s);
}

TEST(the_error_is_of_order_4_in_every_scene)
{
    const struct {
        const char *name;
        uint64_t steps; /* to row 4 */
    } cases[] = {
        {"wobble", 400},   {"generic", 400},   {"ring", 400},
        {"ring_b05", 800}, {"negative", 400},  {"quarter", 800},
        {"tumble", 200},   {"si_washer", 800},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        scene_load(&scene, cases[i].name);
        const double one = error_with(4, cases[i].steps);
        const double half = error_with(4, cases[i].steps * 2);
        check_note("scene %s: error %.3g, then %.3g", cases[i].name, one, half);
        check_within(one / half, LEAST, MOST);
    }
}

/* The path closes to rounding as the steps shrink: what is left is no other
 * motion. */
TEST(small_steps_reach_the_reference)
{
    const char *const names[] = {"wobble", "generic", "spin",     "circle",
                                 "ring",   "quarter", "ring_b05", "negative"};
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        scene_load(&scene, names[i]);
        const double error = error_with(4, 20000);
        check_note("scene %s", names[i]);
        check_within(error, 0, 1e-11);
    }
}

/* 120 frames per second, one step each. */
TEST(a_quarter_at_120_frames_a_second_stays_close_for_a_second)
{
    scene_load(&scene, "quarter");
    const size_t row = 6;
    check(scene_at(&scene, row, "t") == 1);
    const double error = error_with(row, 120);
    printf("    quarter, 120 steps in 1 s: off by %.3g rad or radii\n", error);
    check_within(error, 2e-4, 1e-3);
}

/* The error in a natural unit of time with dt W <= 0.1 all along. */
static double error_at_a_tenth(struct random *r)
{
    const coin_params p = random_coin(r);
    const coin_state s = random_motion(r, &p, 1.0 / 32, 32);
    const double dt = 0.1 / fastest_ahead(&s, &p, natural_time(&p));
    const uint64_t n = (uint64_t)ceil(natural_time(&p) / dt);
    coin_state coarse = s, fine = s;
    check(coin_run(&coarse, &p, COIN_RK4, dt, n, NULL) >= 0);
    check(coin_run(&fine, &p, COIN_RK4, dt / 16, 16 * n, NULL) >= 0);
    return fmax(fabs(coarse.theta - fine.theta), fabs(coarse.phi - fine.phi));
}

/* About what docs/choosing.md says of other random motions. */
TEST(the_error_per_unit_of_time_is_as_documented)
{
    enum { TRIED = 201 };
    struct random r = random_begin(32);
    double errors[TRIED];
    for (int i = 0; i < TRIED; ++i)
        errors[i] = error_at_a_tenth(&r);
    const struct spread off = spread_of(errors, TRIED);
    printf("    dt W = 0.1: off by %.2g, at worst %.2g, per natural unit\n",
           off.median, off.worst);
    check_note("%d random scenes", TRIED);
    check_within(off.median, 2e-7, 2e-6);
    check_within(off.worst, 1e-6, 1e-5);
}
