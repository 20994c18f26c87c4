/* SPDX-License-Identifier: MIT */
/* Where the methods fail, and how: never in silence. */
#include "support/check.h"
#include "support/coins.h"
#include "support/random.h"
#include "support/scene.h"

#include <math.h>
#include <string.h>

#define HALF_PI 1.5707963267948966

/* Without angular momentum nothing keeps the coin off the table, where
 * textbook Runge-Kutta goes on below it: it is there at t = 2.68953837543. */
static void a_coin_that_falls_flat_stops_above_the_table(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const double impact = 2.68953837543;
    for (int i = 0; i < 12; ++i) {
        const double dt = 0.1 / (1 << i);
        coin_state s = {0.3, 0, 0, 0, 0, 0, 0, 0};
        uint64_t done;
        check_note("dt = 0.1/2^%d", i);
        check_status(coin_run(&s, &p, COIN_RK4, dt, 1000000, &done),
                     COIN_ESTEP);
        check_status(coin_state_check(&s, &p), COIN_OK);
        check(s.theta < HALF_PI);
        /* A step needs |dt| W below its limit, W about 1/(time to impact):
         * the last steps are refused some steps before the end. */
        check_within((double)done * dt, impact - 6 * dt, impact);
    }
}

static void it_stops_likewise_on_the_other_face_and_backward(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    coin_state s = {-0.3, 0, 0, 0, 0, 0, 0, 0};
    check_status(coin_run(&s, &p, COIN_RK4, 0.01, 1000, NULL), COIN_ESTEP);
    check(s.theta > -HALF_PI && s.theta < -1.3);
    const coin_state start = {0.3, 0, 0, 0, 0, 0, 0, 0};
    s = start;
    check_status(coin_run(&s, &p, COIN_RK4, -0.01, 1000, NULL), COIN_ESTEP);
    check(s.theta < HALF_PI && s.theta > 1.3);
}

/* With a little momentum it passes the table and comes back up, if only the
 * steps resolve the pass; if not, a step is refused. */
static void a_pass_near_the_table_is_resolved_or_refused(void **unused)
{
    (void)unused;
    struct scene scene;
    scene_load(&scene, "nearflat");
    const size_t row = 7; /* t = 5, after the pass */
    check(scene_at(&scene, row, "t") == 5);
    int refused = 0, good = 0;
    for (int i = 0; i < 10; ++i) {
        const uint64_t n = (uint64_t)32 << i;
        coin_state s = scene_state(&scene, 0);
        const int32_t status =
            coin_run(&s, &scene.params, COIN_RK4, 5.0 / (double)n, n, NULL);
        check_note("%d steps", (int)n);
        if (status == COIN_ESTEP)
            ++refused;
        else if (status == COIN_OK)
            ++good;
        if (status == COIN_OK)
            check_within(scene_error(&scene, row, &s), 0, 1e-3);
    }
    check(refused >= 2 && good >= 2);
}

/* Every step that is not refused leaves a state that passes the check, and
 * one that is not coarse keeps the energy; for steps and states of all sizes,
 * far beyond what the method can do. */
static void no_step_leaves_the_range_of_states(void **unused)
{
    (void)unused;
    struct random r = random_begin(35);
    unsigned refused = 0, coarse = 0, fine = 0;
    for (int i = 0; i < 3000; ++i) {
        const coin_params p = random_coin(&r);
        coin_state s = random_state(&r, &p, 1.5707);
        const double T = natural_time(&p);
        const double E = coin_energy(&s, &p);
        const double dt = (i % 2 ? T : -T) * pow(10, random_between(&r, -3, 2));
        const int32_t status = coin_run(&s, &p, COIN_RK4, dt, 10, NULL);
        check_status(coin_state_check(&s, &p), COIN_OK);
        refused += status == COIN_ESTEP;
        coarse += status == COIN_COARSE;
        fine += status == COIN_OK;
        if (status == COIN_OK)
            check_near(coin_energy(&s, &p), E, 1e-2 * E);
    }
    check(refused > 300 && coarse > 100 && fine > 300);
}

/* In the range that is neither refused nor coarse the error is what the
 * method's limit promises; at the limit it is not yet wrong, just beyond what
 * is refused it would be. */
static void steps_too_large_are_refused_before_the_motion_is_nonsense(
    void **unused)
{
    (void)unused;
    struct scene scene;
    scene_load(&scene, "generic");
    for (int i = 1; i <= 40; ++i) {
        const double dt = 0.05 * i;
        coin_state s = scene_state(&scene, 0);
        const double E = coin_energy(&s, &scene.params);
        const int32_t status =
            coin_run(&s, &scene.params, COIN_RK4, dt, 4, NULL);
        check_note("dt = %g", dt);
        if (dt <= 0.1)
            check_status(status, COIN_OK);
        else if (dt >= 1)
            check_status(status, COIN_ESTEP);
        else
            check(status == COIN_OK || status == COIN_COARSE ||
                  status == COIN_ESTEP);
        if (status == COIN_OK)
            check_near(coin_energy(&s, &scene.params), E, 1e-3 * E);
        if (status == COIN_COARSE)
            check_near(coin_energy(&s, &scene.params), E, 0.2 * E);
    }
}

/* Ten steps of an eighth fit before phi, or psi, is out of range. */
static void a_run_counts_the_steps_that_stay_in_range(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    for (int i = 0; i < 2; ++i) {
        coin_state start, out[12];
        check_status(i ? coin_steady_roll(&start, &p, 1)
                       : coin_steady_upright_spin(&start, &p, 1),
                     COIN_OK);
        *(i ? &start.psi : &start.phi) = 2147483648.0 - 1.25;
        coin_state s = start;
        uint64_t done = 99;
        check_status(coin_run(&s, &p, COIN_RK4, 0.125, 40, &done), COIN_ESTEP);
        check(done == 10);
        size_t samples = 99;
        out[11].theta = 7;
        check_status(
            coin_sample(&start, &p, COIN_RK4, 0.125, 1, 12, out, &samples),
            COIN_ESTEP);
        check(samples == 11 && out[11].theta == 7);
        check(memcmp(&out[10], &s, sizeof s) == 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_coin_that_falls_flat_stops_above_the_table),
        TEST(it_stops_likewise_on_the_other_face_and_backward),
        TEST(a_pass_near_the_table_is_resolved_or_refused),
        TEST(no_step_leaves_the_range_of_states),
        TEST(steps_too_large_are_refused_before_the_motion_is_nonsense),
        TEST(a_run_counts_the_steps_that_stay_in_range),
    };
    return RUN_TESTS(tests);
}
