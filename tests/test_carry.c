/* SPDX-License-Identifier: MIT */
/* What a run carries from step to step: angles as pairs, whole turns, sums. */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"
#include "support/random.h"

#include "methods.h"
#include "run.h"

#include <math.h>

#define HALF_PI 1.5707963267948966

enum { SAMPLES = 200 };

static coin_priv_body body_of(const coin_params *p)
{
    coin_priv_body b;
    check_status(coin_priv_body_of(&b, p), COIN_OK);
    return b;
}

/* ---------------------------------------------------------- into and out */
static void a_run_of_no_steps_is_where_it_began(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_priv_body b = body_of(&p);
    const coin_state s = {0.5, -0.0, 2e9, 1e300, -0.0, 0.1, -0.0, 1.2};
    coin_priv_carry c;
    coin_priv_carry_begin(&c, &s);
    const coin_state same = coin_priv_state_of(&c, &b, &s);
    check_same(&same, &s, sizeof s);
}

/* Angles through sines and cosines, the centre through the contact: 2 u of an
 * angle, 8 u of a path. */
static void the_state_carried_is_the_state(void **unused)
{
    (void)unused;
    struct random r = random_begin(91);
    for (int i = 0; i < 1000; ++i) {
        const coin_params p = random_coin(&r);
        const coin_priv_body b = body_of(&p);
        coin_state s = random_state(&r, &p, HALF_PI);
        s.phi *= pow(10, random_between(&r, 0, 5));
        coin_priv_carry c;
        coin_priv_carry_begin(&c, &s);
        c.steps = 1;
        for (int settled = 0; settled < 2; ++settled) {
            const coin_state t = coin_priv_state_of(&c, &b, &s);
            check_near(t.theta, s.theta, 2 * U);
            check_near(t.phi, s.phi, 2 * U * (1 + fabs(s.phi)));
            check(t.psi == s.psi && t.wX == s.wX);
            check(t.wY == s.wY && t.wZ == s.wZ);
            check_near(t.x, s.x, 8 * U * p.radius);
            check_near(t.z, s.z, 8 * U * p.radius);
            coin_priv_settle(&c, &c.at);
        }
    }
}

/* However small the cosine that is carried, the state's lean is that of a
 * coin above the table. */
static void a_lean_at_the_table_is_the_last_before_it(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_priv_body b = body_of(&p);
    const double last = HALF_PI - 0x1p-52;
    const coin_state start = {.theta = 0.3};
    for (int side = -1; side <= 1; side += 2)
        for (double cth = 1e-3; cth > 1e-300; cth /= 10) {
            coin_priv_carry c;
            coin_priv_carry_begin(&c, &start);
            c.steps = 1;
            c.at.y.sth = side * sqrt(1 - cth * cth);
            c.at.y.cth = cth;
            const coin_state s = coin_priv_state_of(&c, &b, &start);
            check_note("cos theta = %g", cth);
            check_status(coin_state_check(&s, &p), COIN_OK);
            if (cth < 1e-16)
                check(s.theta == side * last);
            else
                check_near(s.theta, side * acos(cth), 4 * U);
        }
}

/* -------------------------------------------------------------- the sums */
static void sums_lose_nothing(void **unused)
{
    (void)unused;
    coin_priv_sum a = {1e16, 0};
    for (int i = 0; i < 1001; ++i)
        coin_priv_add(&a, 1);
    check(a.sum == 1e16 + 1000 && a.low == 1);
    for (int i = 0; i < 1001; ++i)
        coin_priv_add(&a, -1);
    check(a.sum == 1e16 && a.low == 0);
}

/* The same addend again and again, which a plain sum would always round alike
 * and be off by 1e-9: a straight roll, whose path and angle are one product.
 * The addend itself has some roundings. */
static void a_straight_roll_is_as_long_as_its_product(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const uint64_t n = 20000;
    const double dt = 0.0123, wZ = 1.234567;
    for (int32_t method = 0; method < METHODS; ++method) {
        coin_state s;
        check_status(coin_steady_roll(&s, &p, wZ), COIN_OK);
        check_status(coin_run(&s, &p, method, dt, n, NULL), COIN_OK);
        const double way = wZ * dt * (double)n;
        check_note("method %d", (int)method);
        check_near(s.psi, way, 16 * U * way);
        check_near(s.x, -way, 16 * U * way);
        check(s.z == 0 && s.theta == 0 && s.wZ == wZ);
    }
}

/* Steps that move psi by less than half its last place, which is 1.2e-7. */
static void small_steps_of_a_large_roll_are_not_lost(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    for (int32_t method = 0; method < METHODS; ++method) {
        coin_state s;
        check_status(coin_steady_roll(&s, &p, 1), COIN_OK);
        s.psi = 1e9;
        check_status(coin_run(&s, &p, method, 5e-8, 20000, NULL), COIN_OK);
        check_note("method %d", (int)method);
        check_near(s.psi, 1e9 + 1e-3, 1.2e-7);
    }
}

/* ----------------------------------------------------------- whole turns */
/* 1e5 rad of heading, z = 0.4 in a step: order 8 turns it by less than z^9/9!
 * too little; the drift turns it truly, and only the end is rounded. */
static void a_fast_spin_counts_its_turns(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const double wY = 1000, dt = 0.4 / wY;
    const uint64_t n = 250000;
    const struct {
        int32_t method;
        double each;
    } cases[] = {{COIN_RK8, pow(0.4, 9) / 362880}, {COIN_SYMPLECTIC2, 1e-16}};
    for (int i = 0; i < 2; ++i) {
        coin_state s;
        check_status(coin_steady_upright_spin(&s, &p, wY), COIN_OK);
        check(coin_run(&s, &p, cases[i].method, dt, n, NULL) >= 0);
        check_note("method %d", (int)cases[i].method);
        check_near(s.phi, 1e5, cases[i].each * (double)n);
    }
}

/* At the largest step that a method takes: the heading that the pair has come
 * to, and the sum of the rates that tells the turns, stay less than half a turn
 * apart from one settling to the next. */
static void the_sum_tells_the_turn_at_the_largest_step(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_priv_body b = body_of(&p);
    for (int32_t method = 0; method < METHODS; ++method) {
        coin_state s;
        check_status(coin_steady_upright_spin(&s, &p, 1000), COIN_OK);
        coin_priv_carry c;
        coin_priv_carry_begin(&c, &s);
        coin_priv_limits any = {(double)INFINITY, b.w2_max, COIN_OK};
        const double dt = coin_priv_refusal_limit(method) / 1000;
        coin_priv_method_stepper(method)(&c, &b, &any, dt, 1);
        check(c.steps == 1);
        const double pair = atan2(c.at.y.sph, c.at.y.cph);
        check_note("method %d", (int)method);
        check_within(COIN_PRIV_SETTLE * fabs(pair - c.at.pose.phi), 0, 1.57);
    }
}

/* So that how a run is cut does not matter even then. */
static void coarse_turns_are_counted_alike_in_one_run_and_in_many(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    for (int32_t method = 0; method < METHODS; ++method) {
        coin_state one, many;
        check_status(coin_steady_upright_spin(&one, &p, 1000), COIN_OK);
        many = one;
        const double dt = 0.999 * coin_priv_refusal_limit(method) / 1000;
        check_status(coin_run(&one, &p, method, dt, 1000, NULL), COIN_COARSE);
        for (int i = 0; i < 1000; ++i)
            check_status(coin_run(&many, &p, method, dt, 1, NULL), COIN_COARSE);
        check_note("method %d", (int)method);
        check_near(many.phi, one.phi, 8 * U * 1000 * one.phi);
    }
}

/* Spinning or rolling on at the end of the range of phi or psi, or back. */
static void angles_out_of_range_end_a_run(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const double most = 0x1p31;
    const coin_state edges[] = {
        {.phi = most, .wY = 1},
        {.phi = -most, .wY = -1},
        {.psi = most, .wZ = 1},
        {.psi = -most, .wZ = -1},
    };
    for (int32_t method = 0; method < METHODS; ++method)
        for (size_t i = 0; i < sizeof edges / sizeof *edges; ++i) {
            coin_state s = edges[i];
            uint64_t done = 7;
            check_note("method %d, edge %zu", (int)method, i);
            check_status(coin_run(&s, &p, method, 0.05, 100, &done),
                         COIN_ESTEP);
            check(done == 0);
            check_same(&s, &edges[i], sizeof s);
            check_status(coin_run(&s, &p, method, -0.05, 100, &done), COIN_OK);
            check(done == 100);
        }
}

static void no_method_moves_by_no_steps_or_begins_beyond_its_limit(
    void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_state start = {.theta = 0.5, .wY = 2, .wZ = 1};
    for (int32_t method = 0; method < METHODS; ++method) {
        coin_state s = start;
        check_note("method %d", (int)method);
        check_status(coin_run(&s, &p, method, 0.01, 0, NULL), COIN_OK);
        check_same(&s, &start, sizeof s);
        check_status(coin_run(&s, &p, method, 10, 1, NULL), COIN_ESTEP);
        check_same(&s, &start, sizeof s);
    }
}

/* ------------------------------------------------------------ the limits */
/* COIN_COARSE comes exactly if W, where some step of the run begins or ends,
 * is beyond the method's limit: the march looks at W only where the energy
 * allows it to be. */
static void the_warning_is_that_of_the_largest_rate(void **unused)
{
    (void)unused;
    struct random r = random_begin(92);
    coin_state path[SAMPLES];
    int coarse = 0, fine = 0;
    for (int i = 0; i < 1000; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.5);
        const int32_t method = i % METHODS;
        const double limit = coin_priv_coarse_limit(method);
        const double dt = limit / fastest_rate(&s, &p) *
                          pow(10, random_between(&r, -0.7, 0.01));
        const int32_t status =
            coin_sample(&s, &p, method, dt, 1, SAMPLES, path, NULL);
        if (status < 0)
            continue;
        double W = 0;
        for (int k = 0; k < SAMPLES; ++k)
            W = fmax(W, fastest_rate(&path[k], &p));
        check_status(status, dt * W > limit ? COIN_COARSE : COIN_OK);
        coarse += status == COIN_COARSE;
        fine += status == COIN_OK;
    }
    check(coarse > 200 && fine > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_run_of_no_steps_is_where_it_began),
        TEST(the_state_carried_is_the_state),
        TEST(a_lean_at_the_table_is_the_last_before_it),
        TEST(sums_lose_nothing),
        TEST(a_straight_roll_is_as_long_as_its_product),
        TEST(small_steps_of_a_large_roll_are_not_lost),
        TEST(a_fast_spin_counts_its_turns),
        TEST(the_sum_tells_the_turn_at_the_largest_step),
        TEST(coarse_turns_are_counted_alike_in_one_run_and_in_many),
        TEST(angles_out_of_range_end_a_run),
        TEST(no_method_moves_by_no_steps_or_begins_beyond_its_limit),
        TEST(the_warning_is_that_of_the_largest_rate),
    };
    return RUN_TESTS(tests);
}
