/* SPDX-License-Identifier: MIT */
/* A batch against coin_run() for each of its coins, to the bit. */
#include "lanes.h"

#include "support/check.h"
#include "support/coins.h"
#include "support/far.h"
#include "support/methods.h"
#include "support/random.h"

#include <math.h>
#include <string.h>

/* The library may be built for wider vectors than this file. */
enum { WIDEST = 8, MOST = 2 * WIDEST + 1 };

/* A batch and what it has to become. */
struct trial {
    coin_params p;
    coin_state s[MOST], want[MOST];
    int32_t status[MOST], want_status[MOST], want_all;
    size_t count;
};

static void expect(struct trial *t, int32_t method, double dt, uint64_t steps)
{
    int32_t error = COIN_OK, warnings = COIN_OK;
    memcpy(t->want, t->s, sizeof t->s);
    for (size_t i = 0; i < t->count; ++i) {
        const int32_t status =
            coin_run(&t->want[i], &t->p, method, dt, steps, NULL);
        t->want_status[i] = status;
        if (status > 0)
            warnings |= status;
        if (status < 0 && error == COIN_OK)
            error = status;
    }
    t->want_all = error != COIN_OK ? error : warnings;
}

static void check_trial(struct trial *t, int32_t method, double dt,
                        uint64_t steps)
{
    expect(t, method, dt, steps);
    check_status(
        coin_batch_run(t->s, t->count, &t->p, method, dt, steps, t->status),
        t->want_all);
    check_same(t->s, t->want, t->count * sizeof *t->s);
    check_same(t->status, t->want_status, t->count * sizeof *t->status);
}

/* Fast and slow, high and near flat, some at the end of the range of angles,
 * some no state at all. */
static void fill(struct trial *t, struct random *r)
{
    t->p = random_coin(r);
    for (size_t i = 0; i < t->count; ++i) {
        t->s[i] = random_state(r, &t->p, 1.57);
        const double kind = random_between(r, 0, 1);
        if (kind < 0.05)
            t->s[i].wX = (double)NAN;
        else if (kind < 0.1)
            t->s[i].psi = 2147483648.0 - random_between(r, 0, 4);
        else if (kind < 0.15)
            t->s[i].phi = random_between(r, 0, 4) - 2147483648.0;
    }
}

TEST(each_coin_goes_as_it_would_alone)
{
    struct random r = random_begin(41);
    int failed = 0, warned = 0, well = 0;
    for (int32_t method = 0; method < METHODS; ++method) {
        for (int i = 0; i < 60; ++i) {
            struct trial t;
            t.count = (size_t)i % (MOST + 1);
            fill(&t, &r);
            const double longest = i % 3 == 0 ? 0.3 : 0.03;
            const double dt =
                random_between(&r, -longest, longest) * natural_time(&t.p);
            const uint64_t steps =
                i % 5 == 0 ? 1 : (uint64_t)random_between(&r, 0, 200);
            check_note("method %d, batch %d, dt %g, steps %u", (int)method, i,
                       dt, (unsigned)steps);
            check_trial(&t, method, dt, steps);
            for (size_t k = 0; k < t.count; ++k) {
                failed += t.want_status[k] < 0;
                warned += t.want_status[k] > 0;
                well += t.want_status[k] == COIN_OK;
            }
        }
    }
    check(failed > 50 && warned > 50 && well > 50);
}

TEST(the_runge_kutta_methods_have_lanes_where_vectors_are)
{
    const coin_params p = disc();
    coin_priv_constants b;
    b = coin_priv_constants_of(&p);
    for (int32_t method = 0; method < METHODS; ++method) {
        coin_priv_batch none = {NULL, 0, NULL, COIN_OK, COIN_OK};
        check(coin_priv_run_abreast(&none, &b, method, 0.1, 1) ==
              (COIN_PRIV_LANES > 1 && method <= COIN_RK8));
    }
}

/* The first error is that of the lowest index, though a coin that is no state
 * is found out before one that fails on its way. */
TEST(the_status_is_that_of_the_first_coin_that_failed)
{
    struct trial t = {.p = disc(), .count = MOST};
    for (size_t i = 0; i < MOST; ++i)
        t.s[i] = (coin_state){.theta = 0.3, .wY = 0.5, .wZ = 1.2};
    t.s[0].theta = 1.5;
    t.s[0].wX = 20;
    t.s[1].theta = 2;
    check_trial(&t, COIN_RK4, 0.1, 100);
    check_status(t.status[0], COIN_ESTEP);
    check_status(t.status[1], COIN_ESTATE);
    check_status(t.want_all, COIN_ESTEP);
    check_status(t.status[2], COIN_OK);
}

/* Each member in turn out of range, each coin in turn; the others go well.  The
 * step leads a heading or roll just beyond its range back into it. */
TEST(a_coin_that_is_no_state_leaves_the_others_alone)
{
    static const double wrong[][2] = {
        {5, -7},
        {-0x1.0000000000001p31, 0x1.0000000000001p31},
        {-0x1.0000000000001p31, 0x1.0000000000001p31},
        {INFINITY, -INFINITY},
        {INFINITY, -INFINITY},
        {1e200, NAN},
        {1e200, NAN},
        {1e200, NAN},
    };
    for (int i = 0; i < 8 * 2 * MOST * 2; ++i) {
        const int member = i % 8, side = i / 8 % 2, coin = i / 16 % MOST;
        const int32_t method = i / 16 / MOST % 2;
        const uint64_t steps = (member + coin) % 2 ? 70 : 1;
        struct trial t = {.p = disc(), .count = MOST};
        for (size_t k = 0; k < MOST; ++k)
            t.s[k] = (coin_state){.theta = 0.3, .wY = 0.5, .wZ = 1.2};
        ((double *)&t.s[coin])[member] = wrong[member][side];
        check_note("member %d is %g, method %d, %u steps", member,
                   wrong[member][side], (int)method, (unsigned)steps);
        check_trial(&t, method, side ? -0.001 : 0.001, steps);
        check_status(t.status[coin], COIN_ESTATE);
        check_status(t.status[(coin + 1) % MOST], COIN_OK);
    }
}

TEST(the_longest_and_the_shortest_steps_are_as_alone)
{
    for (int i = 0; i < 4; ++i) {
        struct trial t = {.p = disc(), .count = MOST};
        for (size_t k = 0; k < MOST; ++k)
            t.s[k] = (coin_state){.theta = 0.3, .wZ = 1};
        check_trial(&t, i % 2, i / 2 ? 1e200 : 1e-200, 1);
        check_status(t.want_all, i / 2 ? COIN_ESTEP : COIN_OK);
    }
}

/* A step so short that its products are 0, of either sign. */
TEST(a_zero_keeps_its_sign_as_alone)
{
    for (int i = 0; i < 16; ++i) {
        struct trial t = {.p = disc(), .count = MOST};
        const double dt = i & 1 ? -0x1p-1074 : 0x1p-1074;
        for (size_t k = 0; k < MOST; ++k)
            t.s[k] = (coin_state){.theta = 1.3,
                                  .wX = i & 2 ? -0.0 : 3,
                                  .wY = i & 4 ? -0.0 : 4e-3,
                                  .wZ = i & 8 ? -0.0 : 0.0};
        check_trial(&t, COIN_RK4, dt, 1);
        check_trial(&t, COIN_RK8, dt, 1);
    }
}

TEST(a_place_out_of_range_is_not_reached_in_a_lane)
{
    for (int i = 0; i < 4 * 50; ++i) {
        struct trial t = {.count = MOST};
        const uint64_t steps = (uint64_t)(i / 4 * 2);
        double dt;
        const coin_state edge = far_coin(&t.p, i % 2 ? acos(0) : 0, &dt);
        for (size_t k = 0; k < MOST; ++k)
            t.s[k] = edge;
        check_note("heading %g, %u steps", edge.phi, (unsigned)steps);
        check_trial(&t, i / 2 % 2, dt / 4, steps);
        if (steps <= 40 || steps > 50)
            check_status(t.want_all, steps > 50 ? COIN_ERANGE : COIN_OK);
    }
}

TEST(a_rate_out_of_range_is_not_reached_in_a_lane)
{
    static const double rates[][3] = {
        {1e6, 1e3, -1e3},
        {1e3, 1e6, 1e3},
        {1e3, 1e3, 1e6},
    };
    for (int i = 0; i < 2 * 3; ++i) {
        struct trial t = {.p = disc(), .count = MOST};
        const double *const w = rates[i / 2];
        for (size_t k = 0; k < MOST; ++k)
            t.s[k] = (coin_state){.wX = w[0], .wY = w[1], .wZ = w[2]};
        check_note("rate %d, method %d", i / 2, i % 2);
        check_trial(&t, i % 2, 1e-8, 1);
        check_status(t.want_all, COIN_ERANGE);
    }
}

/* Single steps as long as they may be of rings that roll fast, whose lean turns
 * by more than its first stages tell. */
TEST(a_lean_that_turns_late_in_a_step_goes_as_alone)
{
    struct trial t = {.p = disc(), .count = MOST};
    check_status(coin_params_ring(&t.p, 1, 1, 1, 1), COIN_OK);
    for (int i = 0; i < 32; ++i) {
        const double W = 1000, dt = (0.3 + 0.05 * i / 32) / W;
        for (size_t k = 0; k < MOST; ++k) {
            const double part = 0.4 + 0.02 * (double)k;
            t.s[k] =
                (coin_state){.wX = W * part, .wZ = W * sqrt(1 - part * part)};
        }
        check_note("step %g, method %d", dt, i % 2);
        check_trial(&t, i % 2, i & 2 ? -dt : dt, 1);
    }
}

/* A spin that nods rolls to and fro: it ends where its roll first leaves the
 * range, though it would be back in it later. */
TEST(a_roll_that_leaves_its_range_for_a_while_ends_the_run)
{
    int ended = 0;
    for (int i = 0; i < 80; ++i) {
        struct trial t = {.p = disc(), .count = MOST};
        for (size_t k = 0; k < MOST; ++k)
            t.s[k] = (coin_state){.theta = 0.1,
                                  .psi = (i & 1 ? -0x1p31 : 0x1p31),
                                  .wY = 3 + 0.01 * (double)k};
        check_note("%d steps", 5 * i);
        check_trial(&t, i / 2 % 2, 0.02, (uint64_t)(5 * i));
        ended += t.want_all == COIN_ERANGE;
    }
    check(ended > 30 && ended < 50);
}

TEST(a_time_of_0_and_0_steps_change_nothing)
{
    struct trial t = {.p = disc(), .count = MOST};
    for (size_t i = 0; i < MOST; ++i)
        t.s[i] =
            (coin_state){0.3, -0.0, -0.0, -0.0, -0.0, -0.0, 0.5, (double)i};
    const struct trial before = t;
    check_status(
        coin_batch_run(t.s, t.count, &t.p, COIN_RK4, 0, 1000, t.status),
        COIN_OK);
    check_status(coin_batch_run(t.s, t.count, &t.p, COIN_RK8, 0.1, 0, NULL),
                 COIN_OK);
    check_status(coin_batch_run(t.s, 0, &t.p, COIN_RK4, 0.1, 5, NULL), COIN_OK);
    check_status(coin_batch_run(NULL, 0, &t.p, COIN_RK4, 0.1, 5, NULL),
                 COIN_OK);
    check_same(t.s, before.s, sizeof t.s);
}

/* A batch ends with its last coin: 1e9 steps of coins that fall after 270, and
 * of one that is no state, would take minutes. */
TEST(a_batch_ends_where_its_last_coin_does)
{
    for (int32_t method = 0; method < METHODS; ++method)
        for (size_t count = 1; count <= MOST; ++count) {
            struct trial t = {.p = disc(), .count = count};
            for (size_t i = 0; i < count; ++i)
                t.s[i] = (coin_state){.theta = 0.3 + 0.01 * (double)i};
            t.s[count / 2].theta = 2;
            check_note("method %d, %zu coins", (int)method, count);
            check_trial(&t, method, 0.01, 1000000000);
            for (size_t i = 0; i < count; ++i)
                check_status(t.status[i],
                             i == count / 2 ? COIN_ESTATE : COIN_ESTEP);
        }
}

TEST(bad_arguments_touch_nothing)
{
    struct trial t = {.p = disc(), .count = 3};
    for (size_t i = 0; i < t.count; ++i)
        t.s[i] = (coin_state){.theta = 0.3, .wY = 0.5};
    const struct trial before = t;
    coin_params wrong = t.p;
    wrong.mass = -1;
    check_status(coin_batch_run(NULL, 3, &t.p, COIN_RK4, 0.1, 5, t.status),
                 COIN_EARG);
    check_status(coin_batch_run(NULL, 0, NULL, COIN_RK4, 0.1, 5, t.status),
                 COIN_EARG);
    check_status(coin_batch_run(t.s, 3, NULL, COIN_RK4, 0.1, 5, t.status),
                 COIN_EARG);
    check_status(coin_batch_run(t.s, 3, &wrong, METHODS, 0.1, 5, t.status),
                 COIN_EARG);
    check_status(coin_batch_run(t.s, 3, &wrong, COIN_RK4, 0.1, 5, t.status),
                 COIN_EPARAMS);
    check_same(&t, &before, sizeof t);
    check_status(
        coin_batch_run(t.s, 3, &t.p, COIN_RK4, (double)NAN, 5, t.status),
        COIN_ESTEP);
    check_same(t.s, before.s, sizeof t.s);
    check_status(t.status[2], COIN_ESTEP);
}
