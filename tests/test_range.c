/* SPDX-License-Identifier: MIT */
/* The ranges that coin.h and coinf.h state, at their edges: a little within is
 * accepted, a little beyond refused. */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"

#include <coinf.h>

#include <math.h>

/* --------------------------------------------------------- heading and roll */
enum { BLOCKS = 3, STEPS = 64 * BLOCKS, COINS = 16 };

/* Upright at 1000 rad per unit of time, 0.9 rad a step, gap below 2^31: in
 * heading, or in roll. */
static coin_state near_the_edge(int rolls, double gap)
{
    coin_state s = {0, 0, 0, 0, 0, 0, 0, 0};
    *(rolls ? &s.psi : &s.phi) = 0x1p31 - gap;
    *(rolls ? &s.wZ : &s.wY) = 1000;
    return s;
}

static const double turn = 0.9; /* of a step [rad] */

/* Each turn is exact to the angle's last place, 2^-22; gaps keep a tenth of a
 * radian away from whole steps. */
static double gap_of(int steps)
{
    return turn * steps + 0.1;
}

static void a_run_stops_where_an_angle_leaves_its_range(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    for (int32_t method = 0; method < METHODS; ++method)
        for (int fit = 0; fit < STEPS; fit += 5)
            for (int rolls = 0; rolls < 2; ++rolls) {
                coin_state s = near_the_edge(rolls, gap_of(fit));
                uint64_t done = 0;
                check_note("method %d, %d steps fit", (int)method, fit);
                check_status(
                    coin_run(&s, &p, method, turn / 1000, STEPS, &done),
                    COIN_ERANGE);
                check(done == (uint64_t)fit);
                check_status(coin_state_check(&s, &p), COIN_OK);
            }
}

/* A body of small I_Z rolls far in a step. */
static void a_body_of_any_I_Z_is_told_that_its_roll_ends(void **unused)
{
    (void)unused;
    for (double I_Z = 1e-2; I_Z > 1e-9; I_Z /= 100) {
        coin_params p;
        check_status(coin_params_body(&p, 1, 1, 1, 1, I_Z), COIN_OK);
        const coin_friction rough = {0.5, 0.5};
        coin_state s = {.psi = 0x1p31 - 1000, .wZ = 100}, until = s;
        coin_slide d;
        double at;
        check_note("I_Z = %g", I_Z);
        check_status(coin_slide_of(&d, &s, &p), COIN_OK);
        check_status(coin_advance(&s, &p, 20, 1e-9, &at), COIN_ERANGE);
        check_within(at, 9.8, 10);
        check_status(
            coin_advance_until(&until, &p, 20, 1e-9, 1, COIN_SLIPS, &at),
            COIN_ERANGE);
        check_status(coin_slide_advance(&d, &p, &rough, NULL, 20, 1e-9, &at),
                     COIN_ERANGE);
    }
}

static void a_batch_stops_each_coin_there(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const int32_t methods[] = {COIN_RK4, COIN_RK8};
    for (int m = 0; m < 2; ++m)
        for (int rolls = 0; rolls < 2; ++rolls) {
            coin_state s[COINS], alone[COINS];
            for (int i = 0; i < COINS; ++i) {
                alone[i] = s[i] = near_the_edge(rolls, gap_of(11 * i + 1));
                coin_run(&alone[i], &p, methods[m], turn / 1000, STEPS, NULL);
            }
            check_status(coin_batch_run(s, COINS, &p, methods[m], turn / 1000,
                                        STEPS, NULL),
                         COIN_ERANGE);
            check_same(s, alone, sizeof s);
            for (int i = 0; i < COINS; ++i)
                check_status(coin_state_check(&s[i], &p), COIN_OK);
        }
}

/* The roll grows by 1.154, and by 1.059 until the end: it leaves its range and
 * would be back. */
static void a_batch_sees_a_roll_that_leaves_and_comes_back(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    coin_state s[COINS], alone[COINS];
    for (int i = 0; i < COINS; ++i) {
        const coin_state from = {.theta = 0.1, .wX = 0.3, .wY = 3};
        alone[i] = s[i] = from;
        alone[i].psi = s[i].psi = 0x1p31 - 1.11;
        check_status(coin_run(&alone[i], &p, COIN_RK4, 0.02, STEPS, NULL),
                     COIN_ERANGE);
    }
    check_status(coin_batch_run(s, COINS, &p, COIN_RK4, 0.02, STEPS, NULL),
                 COIN_ERANGE);
    check_same(s, alone, sizeof s);
}

/* --------------------------------------------------------------- parameters */
/* With I_X = I_Z = M = a = 1 no number is larger than g, and their sum is
 * below 6 g: refused from 1e300 on, accepted up to a sixth of that. */
static void what_is_made_of_parameters_is_at_most_1e300(void **unused)
{
    (void)unused;
    coin_params p;
    check_status(coin_params_body(&p, 1, 1, 1.6e299, 1, 1), COIN_OK);
    check_status(coin_params_body(&p, 1, 1, 1.01e300, 1, 1), COIN_EPARAMS);
}

/* I_X and I_X/J are the least numbers of these bodies. */
static void what_is_made_of_parameters_is_at_least_1e_minus_300(void **unused)
{
    (void)unused;
    coin_params p;
    check_status(coin_params_body(&p, 1, 1, 1, 1.01e-300, 1.01e-300), COIN_OK);
    check_status(coin_params_body(&p, 1, 1, 1, 0.99e-300, 0.99e-300),
                 COIN_EPARAMS);
}

static void what_is_made_of_floats_is_1e_minus_30_to_1e30(void **unused)
{
    (void)unused;
    coinf_params p;
    const float least = 1.01e-30f, less = 0.99e-30f;
    check_status(coinf_params_body(&p, 1, 1, 1.6e29f, 1, 1), COIN_OK);
    check_status(coinf_params_body(&p, 1, 1, 1.01e30f, 1, 1), COIN_EPARAMS);
    check_status(coinf_params_body(&p, 1, 1, 1, least, least), COIN_OK);
    check_status(coinf_params_body(&p, 1, 1, 1, less, less), COIN_EPARAMS);
}

/* -------------------------------------------------------------------- rates */
/* omega^2 may be 1e268, of floats 1e14, over 1 + a + M a + J + K, which is
 * 5.75 for the disc of ones. */
static void the_square_of_the_rates_has_a_limit(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coinf_params f = {1, 1, 1, 0.25f, 0.5f, {0, 0, 0}};
    for (int member = 0; member < 3; ++member)
        for (int beyond = 0; beyond < 2; ++beyond) {
            const double part = beyond ? 1.001 : 0.999;
            const double rate = sqrt(part * 1e268 / 5.75);
            const float ratef = (float)sqrt(part * 1e14 / 5.75);
            coin_state s = {0, 0, 0, 0, 0, 0, 0, 0};
            coinf_state t = {0, 0, 0, 0, 0, 0, 0, 0, {0}};
            *(member == 0 ? &s.wX : member == 1 ? &s.wY : &s.wZ) = -rate;
            *(member == 0 ? &t.wX : member == 1 ? &t.wY : &t.wZ) = -ratef;
            const int32_t want = beyond ? COIN_ESTATE : COIN_OK;
            check_note("member %d, %g of the limit", member, part);
            check_status(coin_state_check(&s, &p), want);
            check_status(coinf_state_check(&t, &f), want);
        }
}

/* A step that is too long by far: what is said of it depends on the place. */
static void within_16_rad_of_the_end_turns_are_to_be_subtracted(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    for (int i = 0; i < 8; ++i) {
        const int inside = i / 4;
        const double end = 0x1p31 - (inside ? 15.9 : 16.1);
        coin_state s = {.theta = 0.3, .wX = 1, .wY = 1, .wZ = 1}, out[2];
        *(i & 1 ? &s.phi : &s.psi) = i & 2 ? end : -end;
        const int32_t want = inside ? COIN_ERANGE : COIN_ESTEP;
        check_note("case %d", i);
        check_status(coin_step(&s, &p, 100), want);
        check_status(coin_run(&s, &p, COIN_RK8, 100, 9, NULL), want);
        check_status(coin_sample(&s, &p, COIN_RK4, 100, 1, 2, out, NULL), want);
    }
}

/* Within the limits on W where it begins and ends, it would turn the heading by
 * 3.6 rad on its way past the table. */
static void a_step_that_turns_too_far_is_refused(void **unused)
{
    (void)unused;
    coin_params p;
    const coin_state start = {-1.485, 0, 0, 0, 0, -21.77, -6.788, 21.26};
    coin_state s = start;
    check_status(coin_params_body(&p, 1, 1, 1, 1.51994, 0.118894), COIN_OK);
    check_status(coin_run(&s, &p, COIN_RK8, 0.0044432, 1, NULL), COIN_ESTEP);
    check_same(&s, &start, sizeof s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_run_stops_where_an_angle_leaves_its_range),
        TEST(a_batch_stops_each_coin_there),
        TEST(a_batch_sees_a_roll_that_leaves_and_comes_back),
        TEST(what_is_made_of_parameters_is_at_most_1e300),
        TEST(what_is_made_of_parameters_is_at_least_1e_minus_300),
        TEST(what_is_made_of_floats_is_1e_minus_30_to_1e30),
        TEST(the_square_of_the_rates_has_a_limit),
        TEST(within_16_rad_of_the_end_turns_are_to_be_subtracted),
        TEST(a_step_that_turns_too_far_is_refused),
        TEST(a_body_of_any_I_Z_is_told_that_its_roll_ends),
    };
    return RUN_TESTS(tests);
}
