/* SPDX-License-Identifier: MIT */
/* How exact single precision is, and what it keeps to the bit. */
#include "support/check.h"
#include "support/floats.h"
#include "support/random.h"
#include "support/scene.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* What coinf.h promises over UNITS natural units of time, and on scenes that
 * amplify an error how little. */
#define PROMISED 4e-6
#define UNITS 20
#define CALM 100

static struct scene scene;

/* A named scene in floats. */
struct start {
    coinf_params p;
    coinf_state s;
    double unit; /* of time */
};

static struct start start_of(const char *name)
{
    scene_load(&scene, name);
    const coin_state s = scene_state(&scene, 0);
    const struct start b = {
        floats_params(&scene.params),
        floats_state(&s),
        natural_time(&scene.params),
    };
    return b;
}

/* How much the loaded scene amplifies errors within so many units. */
static double amplification(double units)
{
    double amp = 0;
    for (size_t row = 0; row < scene.rows.rows; ++row) {
        amp = fmax(amp, scene_at(&scene, row, "amp"));
        if (scene_at(&scene, row, "t") >= units * natural_time(&scene.params))
            break;
    }
    return amp;
}

/* The largest error of a loop of single steps over so many units, seen at 8
 * times.  Whoever sets keep to 0 throws away what rounding leaves out. */
static double loop_error(const struct start *b, double dt_units, double units,
                         int keep)
{
    const float dt = (float)(dt_units * b->unit);
    const int per_look = (int)(units / 8 / dt_units);
    coinf_state s = b->s;
    double worst = 0;
    for (int i = 1; i <= 8 * per_look; ++i) {
        check_status(coinf_step(&s, &b->p, dt), COIN_OK);
        if (!keep)
            memset(s.low, 0, sizeof s.low);
        if (i % per_look == 0)
            worst = fmax(worst, floats_error(&s, &b->s, &b->p, i * (double)dt));
    }
    return worst;
}

static const double steps[] = {1e-3, 2.3e-3, 4.1e-3, 7.3e-3, 1.13e-2, 2e-2};
enum { TRIED = sizeof steps / sizeof *steps };

TEST(a_loop_of_steps_is_as_exact_as_promised)
{
    int calm = 0;
    double worst = 0;
    for (int i = 0; i < SCENES; ++i) {
        const struct start b = start_of(scene_names[i]);
        if (amplification(UNITS) > CALM)
            continue;
        for (int k = 0; k < TRIED; ++k) {
            const double error = loop_error(&b, steps[k], UNITS, 1);
            check_note("scene %s, dt = %g units", scene_names[i], steps[k]);
            check_within(error, 0, PROMISED);
            worst = fmax(worst, error);
        }
        ++calm;
    }
    printf("    %d scenes: off by %.2g rad or radii at worst\n", calm, worst);
    check(calm == 9);
}

/* An unstable roll: what it does to an error of a float, it does to ours. */
TEST(an_unstable_roll_amplifies_the_error)
{
    const struct start b = start_of("tumble");
    for (int k = 0; k < TRIED; ++k) {
        check_note("dt = %g units", steps[k]);
        check_within(loop_error(&b, steps[k], 10, 1), 0, PROMISED);
        check_within(loop_error(&b, steps[k], UNITS, 1), PROMISED / 100,
                     amplification(UNITS) * UF);
    }
}

/* The remainders are what makes it so. */
TEST(without_remainders_fine_steps_lose_digits)
{
    const char *const names[] = {"generic", "circle", "quarter"};
    for (int i = 0; i < 3; ++i) {
        const struct start b = start_of(names[i]);
        check_note("scene %s", names[i]);
        check_within(loop_error(&b, 1e-3, UNITS, 0), 3e-5, 1e-2);
    }
}

/* Random coins, over 4 units so that few amplify: what is left of the promise
 * then, a tenth per unit, for nine of ten. */
TEST(nine_of_ten_random_coins_are_followed_as_exactly)
{
    enum { COINS = 60 };
    struct random r = random_begin(61);
    int good = 0;
    for (int i = 0; i < COINS; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_motion(&r, &p, 1.0 / 32, 128);
        const struct start b = {floats_params(&p), floats_state(&s),
                                natural_time(&p)};
        good += loop_error(&b, 1.0 / 256, 4, 1) <= 0.4 * PROMISED;
    }
    check_note("%d of %d", good, (int)COINS);
    check(good >= COINS * 9 / 10);
}

/* ------------------------------------------------------------------- order */
static double run_error(const struct start *b, double dt_units)
{
    const float dt = (float)(dt_units * b->unit);
    const int n = (int)(4 / dt_units + 0.5);
    coinf_state s = b->s;
    check(coinf_run(&s, &b->p, COIN_RK4, dt, (uint64_t)n, NULL) >= 0);
    return floats_error(&s, &b->s, &b->p, n * (double)dt);
}

TEST(a_run_is_of_order_4)
{
    const char *const names[] = {"generic", "ring", "negative"};
    for (int i = 0; i < 3; ++i) {
        const struct start b = start_of(names[i]);
        check_note("scene %s", names[i]);
        check_within(run_error(&b, 1.0 / 8) / run_error(&b, 1.0 / 16), 13, 20);
    }
}

/* --------------------------------------------------------------- to the bit */
TEST(a_run_is_so_many_steps_to_the_bit)
{
    const struct start b = start_of("quarter");
    const float dt = (float)(0.02 * b.unit);
    coinf_state run = b.s, loop = b.s;
    check_status(coinf_run(&run, &b.p, COIN_RK4, dt, 500, NULL), COIN_OK);
    for (int i = 0; i < 500; ++i)
        check_status(coinf_step(&loop, &b.p, dt), COIN_OK);
    check_same(&run, &loop, sizeof run);
    check(memcmp(&run, &b.s, sizeof run) != 0);
}

TEST(heading_and_roll_stay_within_half_a_turn)
{
    struct start b = start_of("quarter");
    b.s.phi = -4000;
    b.s.psi = 4096;
    coinf_state s = b.s;
    const float dt = (float)(0.01 * b.unit);
    for (int i = 1; i <= 1000; ++i) {
        check_status(coinf_step(&s, &b.p, dt), COIN_OK);
        check(fabsf(s.phi) <= 3.1415928f && fabsf(s.psi) <= 3.1415928f);
    }
    check_within(floats_error(&s, &b.s, &b.p, 1000 * (double)dt), 0, PROMISED);
}

/* As in test_symmetry. */
TEST(mirrored_and_reversed_motions_have_the_same_bits)
{
    const struct start b = start_of("generic");
    coinf_state s = b.s, mirrored = b.s, back = b.s;
    mirrored.theta = -s.theta;
    mirrored.wX = -s.wX;
    mirrored.wZ = -s.wZ;
    back.wX = -s.wX;
    back.wY = -s.wY;
    back.wZ = -s.wZ;
    coinf_run(&s, &b.p, COIN_RK4, 0.01f, 400, NULL);
    coinf_run(&mirrored, &b.p, COIN_RK4, 0.01f, 400, NULL);
    coinf_run(&back, &b.p, COIN_RK4, -0.01f, 400, NULL);
    check(mirrored.theta == -s.theta && mirrored.phi == s.phi &&
          mirrored.psi == -s.psi && mirrored.x == -s.x && mirrored.z == -s.z &&
          mirrored.wZ == -s.wZ);
    check(mirrored.low[0] == -s.low[0] && mirrored.low[4] == -s.low[4]);
    check(back.theta == s.theta && back.phi == s.phi && back.psi == s.psi &&
          back.x == s.x && back.z == s.z && back.wZ == -s.wZ);
}

/* Upright, nothing but the heading changes.  Each sum rounds its remainder,
 * which is below 2^-22 then, by 2^-47, and each whole turn leaves out four
 * times the last part of pi/2, 2.6e-12.  The float of wY dt alone would be off
 * by 1e-5. */
TEST(a_spin_upright_keeps_its_rate_to_twice_the_digits)
{
    enum { STEPS = 10000 };
    struct random r = random_begin(67);
    for (int i = 0; i < 20; ++i) {
        const coinf_params p = {1, 1, 1, 0.25f, 0.5f, 0, {0, 0}};
        const float wY = (float)random_between(&r, 1, 3);
        const float dt = (float)random_between(&r, 0.01, 0.1);
        const double turn = 6.283185307179586, way = (double)wY * dt * STEPS;
        coinf_state s = {.wY = wY};
        check_note("seed 67, spin %d", i);
        check_status(coinf_run(&s, &p, COIN_RK4, dt, STEPS, NULL), COIN_OK);
        check_near(remainder(s.phi + (double)s.low[1] - way, turn), 0,
                   STEPS * 0x1p-47 + 1.1e-11 * way / turn);
    }
}
