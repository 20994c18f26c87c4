/* SPDX-License-Identifier: MIT */
/* A step by itself against a run of one step: the same bits. */
#include "support/check.h"
#include "support/coins.h"
#include "support/far.h"
#include "support/random.h"

#include <fenv.h>
#include <math.h>

/* Both from *s; what they say. */
static int32_t check_step(const coin_state *s, const coin_params *p, double dt)
{
    coin_state one = *s, other = *s;
    const int32_t said = coin_run(&other, p, COIN_RK4, dt, 1, NULL);
    check_status(coin_step(&one, p, dt), said);
    check_same(&one, &other, sizeof one);
    if (said < 0)
        check_same(&one, s, sizeof one);
    return said;
}

/* How many steps were done, were coarse and were refused. */
struct tally {
    int well, warned, failed;
};

static void count(struct tally *of, int32_t said)
{
    of->well += said == COIN_OK;
    of->warned += said > 0;
    of->failed += said < 0;
}

/* |dt| W evenly over the limits and beyond: 0.35 and 1.2. */
TEST(from_anywhere_it_is_a_run_of_one)
{
    struct random r = random_begin(51);
    struct tally of = {0, 0, 0};
    for (int i = 0; i < 20000; ++i) {
        const coin_params p = random_coin(&r);
        coin_state s = random_state(&r, &p, i % 2 ? 1.57 : 1.0);
        const double dtW = random_between(&r, -1.4, 1.4);
        count(&of, check_step(&s, &p, dtW / fastest_rate(&s, &p)));
    }
    check(of.well > 2000 && of.warned > 2000 && of.failed > 2000);
}

/* Toward the table, so fast that stages are below it. */
TEST(next_to_the_table_it_is_a_run_of_one)
{
    struct random r = random_begin(52);
    const coin_params p = disc();
    struct tally of = {0, 0, 0};
    for (int i = 0; i < 5000; ++i) {
        const double off = pow(10, random_between(&r, -9, -1));
        const coin_state s = {
            .theta = 1.5707963267948966 - off,
            .wX = random_between(&r, 0, 2),
            .wY = off * random_between(&r, -1, 1),
        };
        count(&of, check_step(&s, &p, random_between(&r, 0, 1.5) * off));
    }
    check(of.well > 500 && of.warned > 500 && of.failed > 500);
}

TEST(where_angles_end_it_is_a_run_of_one)
{
    struct random r = random_begin(53);
    const coin_params p = disc();
    struct tally of = {0, 0, 0};
    for (int i = 0; i < 1000; ++i) {
        coin_state s = {.theta = 0.5, .wY = 1.5, .wZ = 2};
        const double end = 2147483648.0 - random_between(&r, 0, 0.2);
        *(i % 2 ? &s.phi : &s.psi) = end;
        count(&of, check_step(&s, &p, random_between(&r, -0.1, 0.1)));
    }
    check(of.well > 100 && of.failed > 100);
}

/* One that no run accepts is COIN_ESTEP there too. */
TEST(where_ranges_end_a_step_of_any_length_is_a_run_of_one)
{
    struct random r = random_begin(56);
    const double never[] = {NAN, INFINITY, -INFINITY, 0x1p1023};
    int too_long = 0, at_edge = 0;
    for (int i = 0; i < 2000; ++i) {
        const coin_params p = random_coin(&r);
        coin_state s = random_state(&r, &p, 1.5);
        const double ends[] = {0x1p31, 0x1p31, 1e9 * p.radius, 1e9 * p.radius};
        double *const members[] = {&s.phi, &s.psi, &s.x, &s.z};
        const double inside = 1 - pow(10, random_between(&r, -12, -7));
        *members[i % 4] = (i % 8 < 4 ? -inside : inside) * ends[i % 4];
        const double dt = i % 5 ? pow(10, random_between(&r, -3, 30)) *
                                      (i % 3 ? 1 : -1) * natural_time(&p)
                                : never[i / 5 % 4];
        const int32_t said = check_step(&s, &p, dt);
        too_long += said == COIN_ESTEP;
        at_edge += said == COIN_ERANGE;
    }
    check(too_long > 500 && at_edge > 200);
}

/* A coarse step's sum of rates and the angle of its pair end apart: one may be
 * in range where the other is not. */
TEST(just_where_angles_end_it_is_a_run_of_one)
{
    struct random r = random_begin(54);
    struct tally of = {0, 0, 0};
    for (int i = 0; i < 3000; ++i) {
        const coin_params p = random_coin(&r);
        coin_state s = random_state(&r, &p, 1), there = s;
        const double dt = random_between(&r, 0.5, 1.1) / fastest_rate(&s, &p);
        if (coin_step(&there, &p, dt) < 0)
            continue;
        const double turned = there.phi - s.phi;
        const double end = 2147483648.0 + random_between(&r, -1e-4, 1e-4);
        s.phi = (turned < 0 ? -end : end) - turned;
        count(&of, check_step(&s, &p, dt));
    }
    check(of.warned > 500 && of.failed > 500);
}

/* The longest dt with which a run of one step has the same status as with
 * `low`. */
static double last_dt(const coin_state *s, const coin_params *p, double low,
                      double high)
{
    coin_state end = *s;
    const int32_t said = coin_run(&end, p, COIN_RK4, low, 1, NULL);
    for (;;) {
        const double dt = low + (high - low) / 2;
        if (dt == low || dt == high)
            return low;
        end = *s;
        if (coin_run(&end, p, COIN_RK4, dt, 1, NULL) == said)
            low = dt;
        else
            high = dt;
    }
}

/* When the last bit of W decides. */
TEST(at_the_limits_of_W_it_is_a_run_of_one)
{
    struct random r = random_begin(55);
    struct tally of = {0, 0, 0};
    for (int i = 0; i < 200; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.4);
        const double T = 1 / fastest_rate(&s, &p);
        const double coarse = last_dt(&s, &p, 0, 0.4 * T);
        const double far = last_dt(&s, &p, nextafter(coarse, T), 1.3 * T);
        for (int k = -10; k < 10; ++k) {
            count(&of, check_step(&s, &p, coarse * (1 + k * 0x1p-52)));
            count(&of, check_step(&s, &p, far * (1 + k * 0x1p-52)));
        }
    }
    check(of.well > 1000 && of.warned > 2000 && of.failed > 1000);
}

TEST(where_a_place_ends_its_range_it_is_a_run_of_one)
{
    const double headings[] = {0, 1.5707963267948966, 3.141592653589793, -1};
    for (size_t i = 0; i < sizeof headings / sizeof *headings; ++i) {
        coin_params p;
        double dt;
        coin_state s = far_coin(&p, headings[i], &dt);
        for (int k = 0; k < 14; ++k) {
            check_step(&s, &p, dt);
            coin_step(&s, &p, dt);
        }
    }
}

/* At rest, along an axis or mirrored, where terms are zeros of either sign. */
TEST(from_zeros_of_either_sign_it_is_a_run_of_one)
{
    const coin_params p = disc();
    for (unsigned i = 0; i < 1u << 8; ++i) {
        const double zero[] = {0, -0.0}, rate[] = {0.5, -0.5};
        const coin_state s = {
            .theta = zero[i & 1],
            .phi = zero[i >> 1 & 1],
            .psi = zero[i >> 2 & 1],
            .x = zero[i >> 3 & 1],
            .z = zero[i >> 3 & 1],
            .wX = zero[i >> 4 & 1],
            .wY = (i & 128 ? rate : zero)[i >> 5 & 1],
            .wZ = zero[i >> 6 & 1],
        };
        check_note("signs %x", i);
        check_status(check_step(&s, &p, 0.1), COIN_OK);
        check_status(check_step(&s, &p, -0.1), COIN_OK);
        check_status(check_step(&s, &p, 0), COIN_OK);
    }
}

TEST(a_step_of_no_time_keeps_the_signs_of_zeros)
{
    const coin_params p = disc();
    const coin_state zeros = {-0.0, -0.0, -0.0, -0.0, -0.0, -0.0, -0.0, -0.0};
    coin_state s = zeros;
    check_status(coin_step(&s, &p, 0), COIN_OK);
    check_same(&s, &zeros, sizeof s);
}

TEST(a_bad_argument_has_the_status_of_a_run_of_one)
{
    const coin_params p = disc(), massless = {0, 1, 1, 1, 1, 0, {0, 0}};
    const coin_state s = {.theta = 0.5, .wY = 1}, flat = {.theta = 1.6};
    check_status(check_step(&s, &massless, 0.1), COIN_EPARAMS);
    check_status(check_step(&flat, &p, 0.1), COIN_ESTATE);
}

TEST(a_step_too_long_is_refused)
{
    const coin_params p = disc();
    const coin_state s = {.theta = 0.5, .wY = 1};
    const double longest[] = {1e15, -1e16, 1e300, NAN, INFINITY};
    for (int i = 0; i < 5; ++i) {
        check_note("dt %g", longest[i]);
        check_status(check_step(&s, &p, longest[i]), COIN_ESTEP);
    }
}

/* A straight roll with a heading of -0 turns by -0: both forget the sign. */
TEST(a_negative_zero_is_the_same_in_both)
{
    const coin_params p = disc();
    const coin_state s = {0, -0.0, 0, 0, 0, 0, -0.0, -1};
    check_status(check_step(&s, &p, 1e-3), COIN_OK);
}

/* The sum of the lean may round beyond it. */
TEST(at_the_last_lean_it_is_a_run_of_one)
{
    const coin_params p = disc();
    const coin_state s = {.theta = 1.5707963267948963, .wX = 1};
    int32_t coarse = 0;
    for (double dt = 0x1p-54; dt < 0x1p-52; dt *= 1.05)
        coarse += check_step(&s, &p, dt) == COIN_COARSE;
    check(coarse > 10);
}
