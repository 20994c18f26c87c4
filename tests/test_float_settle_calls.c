/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/floats.h"
#include "support/random.h"

#include <coinf.h>

#include <float.h>
#include <math.h>
#include <string.h>

static coinf_params disc_f(void)
{
    coinf_params p;
    check_status(coinf_params_disc(&p, 1, 1, 1), COIN_OK);
    return p;
}

static void a_time_of_0_changes_nothing(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coinf_losses l = {.dry = 0.1f};
    const coinf_state before = {0.5f, -0.0f, 9,    1e6f,   -0.0f,
                                0.1f, -0.0f, 1.2f, {1e-8f}};
    coinf_state s = before;
    float reached = 7;
    check_status(coinf_settle(&s, &p, &l, 0, 1e-4f, &reached), COIN_OK);
    check_same(&s, &before, sizeof s);
    check(reached == 0);
}

static void a_call_takes_2_16_steps_and_the_next_goes_on(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coinf_losses l = {.spin = 1e-9f};
    coinf_state s = {.wY = 1e3f};
    float reached;
    check_status(coinf_settle(&s, &p, &l, 1e3f, 1e-2f, &reached), COIN_ESTEP);
    check_within((double)reached, 20, 30); /* 65,536 steps of 0.35 rad */
    check_status(coinf_settle(&s, &p, &l, 1, 1e-2f, &reached), COIN_OK);
    check(reached == 1);
    check_near((double)s.wY, 1e3, 1e-2);
}

static void a_place_out_of_range_is_not_reached(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coinf_losses l = {.damping = 1e-6f};
    coinf_state s = {.x = -999999, .wZ = 1};
    float reached = 7;
    check_status(coinf_settle(&s, &p, &l, 3, 1e-4f, &reached), COIN_ERANGE);
    check_within(reached, 0.5, 1.1); /* x is a multiple of 1/16 */
    check_status(coinf_state_check(&s, &p), COIN_OK);
}

static void the_usual_errors_touch_nothing(void **unused)
{
    (void)unused;
    const coinf_params good = disc_f();
    coinf_params bad = good;
    bad.radius = -1;
    const coinf_losses fine = {.dry = 0.1f}, wrong = {.dry = -1};
    const coinf_state sound = {.theta = 0.3f, .wY = 1}, lost = {.theta = 2};
    const struct {
        const coinf_state *s;
        const coinf_params *p;
        const coinf_losses *l;
        float t, tol;
        int32_t status;
    } cases[] = {
        {NULL, &good, &fine, 1, 1e-4f, COIN_EARG},
        {&sound, NULL, &fine, 1, 1e-4f, COIN_EARG},
        {&sound, &good, NULL, 1, 1e-4f, COIN_EARG},
        {&lost, &bad, &wrong, -1, 0.9e-6f, COIN_EARG},
        {&sound, &good, &fine, 1, 0.011f, COIN_EARG},
        {&sound, &good, &fine, 1, NAN, COIN_EARG},
        {&lost, &bad, &fine, -1, 1e-4f, COIN_EPARAMS},
        {&lost, &good, &wrong, -1, 1e-4f, COIN_EPARAMS},
        {&lost, &good, &fine, -1, 1e-4f, COIN_ESTATE},
        {&sound, &good, &fine, -1, 1e-4f, COIN_ESTEP},
        {&sound, &good, &fine, 1.1e6f, 1e-4f, COIN_ESTEP},
        {&sound, &good, &fine, INFINITY, 1e-4f, COIN_ESTEP},
        {&sound, &good, &fine, NAN, 1e-4f, COIN_ESTEP},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coinf_state s = cases[i].s ? *cases[i].s : sound;
        const coinf_state before = s;
        float reached = 7;
        check_note("case %zu", i);
        check_status(coinf_settle(cases[i].s ? &s : NULL, cases[i].p,
                                  cases[i].l, cases[i].t, cases[i].tol,
                                  &reached),
                     cases[i].status);
        check_same(&s, &before, sizeof s);
        check(reached == 7);
    }
}

/* Damping never stops the contact: the law of (75) gives the last of the time.
 */
static void the_end_goes_by_the_law_of_the_loss_that_acts(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coinf_losses l = {.damping = 1e-3f, .spin = 1e-3f};
    const float e = 1e-4f;
    coinf_state s = {.theta = 1.5706963f, .wY = 0.01991f, .wZ = 0.3f};
    s.low[0] = (float)(1.5707963267948966 - (double)e - (double)s.theta);
    float T;
    check_status(coinf_settle(&s, &p, &l, 99, 1e-4f, &T), COIN_RESTS);
    check_near(T, 15, 0.02);
}

static void every_member_of_the_losses_is_checked(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coinf_params bad = {.mass = -1};
    const coinf_losses none = {0};
    const float wrong[] = {-1e-30f, -1, NAN, INFINITY, 1.01e9f};
    for (size_t i = 0; i < sizeof none / sizeof(float); ++i)
        for (size_t k = 0; k < sizeof wrong / sizeof *wrong; ++k) {
            coinf_losses l = none;
            memcpy((char *)&l + i * sizeof(float), &wrong[k], sizeof(float));
            check_note("member %zu is %g", i, (double)wrong[k]);
            check_status(coinf_losses_check(&l, &p), COIN_EPARAMS);
        }
    check_status(coinf_losses_check(&none, &p), COIN_OK);
    check_status(coinf_losses_check(&none, &bad), COIN_EPARAMS);
    check_status(coinf_losses_check(NULL, &p), COIN_EARG);
    check_status(coinf_losses_check(&none, NULL), COIN_EARG);
}

/* Pivoting friction, or a fall that begins, carries the roll of the contact
 * through 0 where friction changes its sign. */
static void where_the_contact_turns_round_the_error_is_below_tol(void **unused)
{
    (void)unused;
    const float t = 0.25f, tols[] = {1e-2f, 1e-3f, 1e-4f, 1e-5f};
    const int count = tries_asked(200);
    struct random r = random_begin(213);
    int turned = 0;
    for (int i = 0; i < count; ++i) {
        const double small = pow(10, random_between(&r, -2, -1));
        const coin_params disc = {1,           1,        1, 0.25 * small,
                                  0.5 * small, {0, 0, 0}};
        const coinf_params p = floats_params(&disc);
        const coin_losses some = {
            .dry = pow(10, random_between(&r, -4, -1.5)),
            .spin = i % 2 ? pow(10, random_between(&r, -2, -1)) : 0,
        };
        const coinf_losses l = floats_losses(&some);
        const double theta = random_between(&r, -0.9, 0.9);
        const double wY = random_between(&r, -0.5, 0.5);
        const double roll =
            (i & 2 ? 1 : -1) * pow(10, random_between(&r, -4, -1));
        const coin_state from = {
            .theta = theta,
            .wX = pow(10, random_between(&r, -6, -1)),
            .wY = wY,
            .wZ = roll - wY * tan(theta),
        };
        const coinf_state start = floats_state(&from);
        const coin_params P = doubles_params(&p);
        const coin_losses L = doubles_losses(&l);
        coin_state want = doubles_state(&start);
        check_status(coin_settle(&want, &P, &L, (double)t, 1e-12, NULL),
                     COIN_OK);
        turned += (want.wZ + want.wY * tan(want.theta)) * roll < 0;
        for (int k = 0; k < 4; ++k) {
            coinf_state s = start;
            check_note("launch %d, tol %g", i, (double)tols[k]);
            check_status(coinf_settle(&s, &p, &l, t, tols[k], NULL), COIN_OK);
            const coin_state is = doubles_state(&s);
            check_near(is.phi, want.phi, (double)(t * tols[k]) + 90 * UF);
            check_near(is.psi, want.psi, (double)(t * tols[k]) + 90 * UF);
        }
    }
    check(turned > count / 4);
}

/* A call that ends where the coin is flat to a float's rounding lays it flat.
 */
static void a_call_that_ends_next_to_the_table_goes_on(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coinf_losses l = {.dry = 10};
    const coinf_state start = {.theta = 1.5257963f};
    coinf_state s = start;
    float rests, reached;
    check_status(coinf_settle(&s, &p, &l, 1, 1e-4f, &rests), COIN_RESTS);
    float t = rests;
    for (int i = 0; i < 40; ++i, t = nextafterf(t, 0)) {
        s = start;
        const int32_t status = coinf_settle(&s, &p, &l, t, 1e-4f, &reached);
        check_note("%d steps of a float before", i);
        check(status == COIN_OK || status == COIN_RESTS);
        check(reached == t);
        check_status(coinf_settle(&s, &p, &l, 1, 1e-4f, &reached), COIN_RESTS);
        check_near((double)(t + reached), (double)rests, 2e-6);
    }
}

/* In 33,600 calls. */
static void a_held_fall_errs_by_6e_4_in_calls_of_1e_5(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coinf_losses l = {.dry = 10};
    coinf_state s = {.theta = 1.5257963f}, once = s;
    float rests, reached;
    double t = 0;
    check_status(coinf_settle(&once, &p, &l, 1, 1e-4f, &rests), COIN_RESTS);
    while (coinf_settle(&s, &p, &l, 1e-5f, 1e-4f, &reached) == COIN_OK)
        t += (double)reached;
    check_near(t + (double)reached, (double)rests, 6e-4);
}

/* The time left is held by two floats. */
static void how_long_the_call_is_does_not_change_when_it_ends(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coinf_losses l = {.dry = 0.1f};
    const coinf_state start = {.theta = 1.2f, .wY = 1.2f};
    float first = 0;
    for (float t = 3; t < 2e6f; t = t < 10 ? 1e4f : t * 10) {
        coinf_state s = start;
        float when;
        check_status(coinf_settle(&s, &p, &l, t, 1e-4f, &when), COIN_RESTS);
        first = t < 10 ? when : first;
        check_note("t %g", (double)t);
        check_near((double)when, (double)first, 2e-6);
    }
}

static void strong_pivoting_friction_ends_the_turn_of_a_fall(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const double c = 0.045, turn = 0.1;
    for (double b = 30; b < 300; b *= 2) {
        const coinf_losses l = {.dry = 10, .spin = (float)b};
        coinf_state s = {
            .theta = (float)acos(c),
            .psi = 100,
            .wY = (float)(c * turn),
            .wZ = (float)(-sqrt(1 - c * c) * turn),
        };
        float when;
        check_status(coinf_settle(&s, &p, &l, 10, 1e-4f, &when), COIN_RESTS);
        check_note("b = %g", b);
        check_near((double)s.phi, turn * 1.5 / b, 4e-3 * turn * 1.5 / b);
        check_near((double)when, 0.3355, 1e-4);
        check_near((double)s.psi, 100 - 32 * acos(-1), 1e-5);
    }
}

/* The body turns about the vertical alone, so that neither its lean nor its
 * contact moves at first: the rate of friction begins at 0.  The pose is
 * compared with that of coin_settle(). */
static void a_contact_that_begins_to_roll_is_slowed(void **unused)
{
    (void)unused;
    static const struct {
        float IX, IZ, theta, wY, wZ, layer, t, tol;
    } cases[] = {
        {0x1.62e59cp-2f, 0x1.b7cef4p-3f, 0x1.921a7cp+0f, 0x1.ec0816p-12f,
         -0x1.78c4dp+2f, 0.0231826f, 0x1.9f26b4p-7f, 0x1.af370cp-11f},
        {0x1.c062eap-7f, 0x1.47ae14p-7f, 0x1.91ea38p+0f, 0x1.d3de6cp-8f,
         -0x1.17e71p+3f, 0.674704f, 0x1.2cb0b4p-5f, 0x1.0c6f7ap-20f},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coinf_params p;
        const coinf_losses l = {.layer = cases[i].layer};
        const coin_losses exact = doubles_losses(&l);
        coinf_state s = {
            .theta = cases[i].theta, .wY = cases[i].wY, .wZ = cases[i].wZ};
        coin_state want = doubles_state(&s);
        const double t = (double)cases[i].t, tol = (double)cases[i].tol;
        check_status(coinf_params_body(&p, 1, 1, 1, cases[i].IX, cases[i].IZ),
                     COIN_OK);
        const coin_params p_exact = doubles_params(&p);
        check_status(coinf_settle(&s, &p, &l, cases[i].t, cases[i].tol, NULL),
                     COIN_OK);
        check_status(coin_settle(&want, &p_exact, &exact, t, 1e-9, NULL),
                     COIN_OK);
        const double most =
            2 * tol * (1 + t * fabs(want.wZ)) + 90 * UF * (1 + t);
        check_note("case %zu", i);
        check_near((double)s.theta + (double)s.low[0], want.theta, most);
        check_near((double)s.phi, want.phi, most);
        check_near((double)s.psi, want.psi, most);
    }
}

/* By the rolling moment alone the swing grows until the coin lies flat.  The
 * lean at the start, off by 1e-7, changes the time of rest by 2 ms. */
static void a_coin_that_swings_more_and_more_rests_in_time(void **unused)
{
    (void)unused;
    coinf_params p;
    const coinf_losses l = {.rolling = 0x1.9eba7ap-20f};
    const coin_losses exact = doubles_losses(&l);
    check_status(coinf_params_disc(&p, 0.00567f, 0.01213f, 9.80665f), COIN_OK);
    const coin_params p_exact = doubles_params(&p);
    const coinf_state start = {
        .theta = 0x1.733334p+0f, .wX = 0x1.e7f5ecp-6f, .wY = 0x1.3bd924p+4f};
    coin_state want = doubles_state(&start);
    double after;
    check_status(coin_settle(&want, &p_exact, &exact, 20, 1e-4, &after),
                 COIN_RESTS);
    for (float tol = 1e-4f; tol < 2e-2f; tol *= 10) {
        coinf_state s = start;
        float when;
        check_status(coinf_settle(&s, &p, &l, 20, tol, &when), COIN_RESTS);
        check_note("tol %g", (double)tol);
        check_near((double)when, after, 8e-3);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_time_of_0_changes_nothing),
        TEST(a_call_takes_2_16_steps_and_the_next_goes_on),
        TEST(a_place_out_of_range_is_not_reached),
        TEST(the_usual_errors_touch_nothing),
        TEST(every_member_of_the_losses_is_checked),
        TEST(the_end_goes_by_the_law_of_the_loss_that_acts),
        TEST(where_the_contact_turns_round_the_error_is_below_tol),
        TEST(a_call_that_ends_next_to_the_table_goes_on),
        TEST(how_long_the_call_is_does_not_change_when_it_ends),
        TEST(strong_pivoting_friction_ends_the_turn_of_a_fall),
        TEST(a_held_fall_errs_by_6e_4_in_calls_of_1e_5),
        TEST(a_contact_that_begins_to_roll_is_slowed),
        TEST(a_coin_that_swings_more_and_more_rests_in_time),
    };
    return RUN_TESTS(tests);
}
