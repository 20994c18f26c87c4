/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/random.h"

#include <math.h>

#define UNTOUCHED 0x5555555555555555

static const int32_t methods[] = {COIN_RK4, COIN_RK8};

static coin_lean lean_of(const coin_state *s)
{
    const coin_lean l = {s->theta, s->wX, s->wY, s->wZ};
    return l;
}

/* What the two have in common, bit for bit, and all that they return. */
static int32_t check_alike(coin_state s, const coin_params *p, int32_t method,
                           double dt, uint64_t steps)
{
    coin_lean l = lean_of(&s);
    uint64_t done = UNTOUCHED, lean_done = UNTOUCHED;
    const int32_t status = coin_run(&s, p, method, dt, steps, &done);
    check_status(coin_lean_run(&l, p, method, dt, steps, &lean_done), status);
    check(lean_done == done);
    const coin_lean want = lean_of(&s);
    check_same(&l, &want, sizeof l);
    return status;
}

/* Motions and steps of all sizes: fine, coarse and refused on the way. */
static void lean_runs_have_the_bits_of_full_ones(void **unused)
{
    (void)unused;
    struct random r = random_begin(90);
    int fine = 0, coarse = 0, refused = 0;
    for (int i = 0; i < 1000; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.5);
        const double dt =
            natural_time(&p) * pow(10, random_between(&r, -4, 0.5));
        const int32_t status =
            check_alike(s, &p, methods[i % 2], i % 3 ? dt : -dt, 70);
        fine += status == COIN_OK;
        coarse += status == COIN_COARSE;
        refused += status == COIN_ESTEP;
    }
    check(fine > 100 && coarse > 50 && refused > 100);
}

/* The pose has limits of its own: heading and roll. */
static void a_lean_run_does_not_end_where_only_the_path_does(void **unused)
{
    (void)unused;
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    for (int i = 0; i < 2; ++i) {
        coin_state s = {.phi = 0x1p31, .wY = 1, .wZ = 1}, t = s;
        coin_lean l = lean_of(&s);
        uint64_t done = UNTOUCHED;
        check_status(coin_run(&s, &p, methods[i], 0.01, 10, &done), COIN_ESTEP);
        check(done == 0);
        check_status(coin_lean_run(&l, &p, methods[i], 0.01, 10, &done),
                     COIN_OK);
        check(done == 10);
        t.phi = 0;
        check_status(coin_run(&t, &p, methods[i], 0.01, 10, NULL), COIN_OK);
        const coin_lean want = lean_of(&t);
        check_same(&l, &want, sizeof l);
    }
}

static void no_step_and_no_time_change_nothing(void **unused)
{
    (void)unused;
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    const struct {
        double dt;
        uint64_t steps;
    } cases[] = {{0.1, 0}, {0, 10}, {-0.0, 10}, {1e300, 0}};
    const coin_lean before = {0.5, -0.0, 0.8, 1.2};
    for (int k = 0; k < 2; ++k)
        for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
            coin_lean l = before;
            uint64_t done = UNTOUCHED;
            check_status(coin_lean_run(&l, &p, methods[k], cases[i].dt,
                                       cases[i].steps, &done),
                         COIN_OK);
            check(done == cases[i].steps);
            check_same(&l, &before, sizeof l);
        }
}

static void bad_arguments_touch_nothing(void **unused)
{
    (void)unused;
    coin_params good, bad;
    check_status(coin_params_disc(&good, 1, 1, 1), COIN_OK);
    bad = good;
    bad.mass = 0;
    const coin_lean fine = {0.5, 1, 1, 1}, flat = {1.6, 1, 1, 1};
    const coin_lean endless = {0.5, INFINITY, 1, 1}, none = {NAN, 1, 1, 1};
    const struct {
        coin_lean l;
        const coin_params *p;
        int32_t method;
        double dt;
        int32_t want;
    } cases[] = {
        {flat, &bad, COIN_SYMPLECTIC2, NAN, COIN_EARG},
        {fine, &good, COIN_SYMPLECTIC2, 0.01, COIN_EARG},
        {fine, &good, COIN_SYMPLECTIC4, 0.01, COIN_EARG},
        {fine, &good, 4, 0.01, COIN_EARG},
        {fine, &good, -1, 0.01, COIN_EARG},
        {flat, NULL, COIN_RK8, NAN, COIN_EARG},
        {flat, &bad, COIN_RK8, NAN, COIN_EPARAMS},
        {flat, &good, COIN_RK4, NAN, COIN_ESTATE},
        {endless, &good, COIN_RK4, 0.01, COIN_ESTATE},
        {none, &good, COIN_RK8, 0.01, COIN_ESTATE},
        {fine, &good, COIN_RK8, NAN, COIN_ESTEP},
        {fine, &good, COIN_RK4, INFINITY, COIN_ESTEP},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coin_lean l = cases[i].l;
        uint64_t done = UNTOUCHED;
        check_note("case %zu", i);
        check_status(coin_lean_run(&l, cases[i].p, cases[i].method, cases[i].dt,
                                   1, &done),
                     cases[i].want);
        check_same(&l, &cases[i].l, sizeof l);
        check(done == UNTOUCHED);
    }
    check_status(coin_lean_run(NULL, &good, COIN_RK4, 0.01, 1, NULL),
                 COIN_EARG);
}

/* Without momentum it falls on the table: the steps before count. */
static void a_run_that_fails_keeps_the_steps_before(void **unused)
{
    (void)unused;
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    for (int i = 0; i < 2; ++i) {
        coin_lean l = {0.3, 0, 0, 0}, again = l;
        uint64_t done = UNTOUCHED;
        check_status(coin_lean_run(&l, &p, methods[i], 0.01, 1000, &done),
                     COIN_ESTEP);
        check_within((double)done, 250, 268);
        check_status(coin_lean_run(&again, &p, methods[i], 0.01, done, NULL),
                     COIN_COARSE);
        check_same(&l, &again, sizeof l);
        check_status(coin_lean_run(&l, &p, methods[i], 0.01, 5, &done),
                     COIN_ESTEP);
        check(done == 0);
        check_same(&l, &again, sizeof l);
    }
}

/* Found by fuzzing, when steps of RK8 up to |dt| W = 1.8 were done: two of them
 * left a pair of sine and cosine of norm 1e6, and theta = NaN. */
static void steps_that_would_leave_no_lean_are_refused(void **unused)
{
    (void)unused;
    const double IX = 0.29319876970396003, dt = 0.2414215162830497;
    const coin_lean before = {0.977508544921875, 3.325439453125,
                              -0.862060546875, 3.337646484375};
    coin_params p;
    coin_lean l = before;
    uint64_t done = 99;
    check_status(coin_params_body(&p, 1, 1, 1, IX, 2 * IX), COIN_OK);
    check_status(coin_lean_run(&l, &p, COIN_RK8, dt, 2, &done), COIN_ESTEP);
    check(done == 0);
    check_same(&l, &before, sizeof l);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(lean_runs_have_the_bits_of_full_ones),
        TEST(a_lean_run_does_not_end_where_only_the_path_does),
        TEST(no_step_and_no_time_change_nothing),
        TEST(bad_arguments_touch_nothing),
        TEST(a_run_that_fails_keeps_the_steps_before),
        TEST(steps_that_would_leave_no_lean_are_refused),
    };
    return RUN_TESTS(tests);
}
