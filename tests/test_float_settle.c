/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/floats.h"
#include "support/losses.h"
#include "support/random.h"

#include <math.h>

#define TURN 6.283185307179586

static coinf_params disc_f(void)
{
    coinf_params p;
    check_status(coinf_params_disc(&p, 1, 1, 1), COIN_OK);
    return p;
}

/* A US quarter that spins for 8 s from a lean of 60 degrees, with a nutation of
 * a hundredth. */
static coinf_state quarter(coinf_params *p, coinf_losses *l)
{
    const coinf_losses none = {0};
    check_status(coinf_params_disc(p, 0.00567f, 0.01213f, 9.80665f), COIN_OK);
    const coin_params exact = doubles_params(p);
    coin_state s;
    check_status(coin_steady_spin(&s, &exact, 1.0471975511965976), COIN_OK);
    s.wX = 0.005 * sqrt(exact.gravity / exact.radius);
    *l = none;
    l->dry = (float)(8.5e-4 * exact.mass * exact.gravity * exact.radius);
    return floats_state(&s);
}

/* The largest difference of the pose, in radians up to whole turns and in
 * radii. */
static double pose_apart(const coinf_state *s, const coin_state *want, double a)
{
    const coin_state got = doubles_state(s);
    const double off[] = {got.theta - want->theta,
                          remainder(got.phi - want->phi, TURN),
                          remainder(got.psi - want->psi, TURN),
                          (got.x - want->x) / a, (got.z - want->z) / a};
    double most = 0;
    for (int i = 0; i < 5; ++i)
        most = fmax(most, fabs(off[i]));
    return most;
}

/* ------------------------------------------------------------------ accuracy
 */
/* Calls of so many seconds until it rests; the time as their sum. */
static double life(float seconds, float tol, coinf_state *s, int *calls)
{
    coinf_params p;
    coinf_losses l;
    double when = 0;
    float reached;
    int32_t status = COIN_OK;
    *s = quarter(&p, &l);
    for (*calls = 0; status == COIN_OK && *calls < 10000; ++*calls) {
        status = coinf_settle(s, &p, &l, seconds, tol, &reached);
        check(status == COIN_RESTS || reached == seconds);
        when += (double)reached;
    }
    check_status(status, COIN_RESTS);
    return when;
}

/* At 1 kHz, at 60 Hz and in one call, whose time a float holds to 1e-6 s. */
static void a_quarter_rests_after_the_time_of_coin_settle(void **unused)
{
    (void)unused;
    coinf_params p;
    coinf_losses l;
    coinf_state start = quarter(&p, &l), s;
    const coin_params exact = doubles_params(&p);
    const coin_losses same = doubles_losses(&l);
    coin_state end = doubles_state(&start);
    double when;
    int calls;
    check_status(coin_settle(&end, &exact, &same, 100, 1e-12, &when),
                 COIN_RESTS);
    check_within(when, 7.9, 8.1);
    check_near(life(1e-3f, 1e-4f, &s, &calls), when, 1e-5);
    check(calls == (int)(when / 1e-3) + 1);
    check_near((double)s.wX / end.wX, 1, 1e-3);
    check_near((double)s.wZ / end.wZ, 1, 1e-5);
    check_near(life(1.0f / 60, 1e-3f, &s, &calls), when, 1e-5);
    check_near(life(100, 1e-3f, &s, &calls), when, 3e-5);
    check(calls == 1);
}

static void of_random_launches_98_of_100_err_by_less_than_tol(void **unused)
{
    (void)unused;
    const int count = tries_asked(100);
    struct random r = random_begin(181);
    const float tols[] = {1e-2f, 1e-3f, 1e-4f, 1e-5f};
    int within[4] = {0};
    for (int i = 0; i < count; ++i) {
        const coin_params any = random_coin(&r);
        const coin_losses some = random_losses(&r, &any, 0.03);
        const coin_state from = random_state(&r, &any, 1.5);
        const coinf_params p = floats_params(&any);
        const coinf_losses l = floats_losses(&some);
        const coinf_state start = floats_state(&from);
        const coin_params P = doubles_params(&p);
        const coin_losses L = doubles_losses(&l);
        coin_state want = doubles_state(&start);
        const double T = natural_time(&P);
        const float t = (float)(4 * T);
        double when;
        const int32_t right =
            coin_settle(&want, &P, &L, (double)t, 1e-12, &when);
        for (int k = 0; k < 4; ++k) {
            coinf_state s = start;
            float reached;
            const int32_t status =
                coinf_settle(&s, &p, &l, t, tols[k], &reached);
            check(status == COIN_OK || status == COIN_RESTS);
            const double error = status == COIN_RESTS
                                     ? fabs((double)reached - when) / T
                                     : pose_apart(&s, &want, P.radius);
            within[k] += status == right && error <= 4 * (double)tols[k];
        }
    }
    for (int k = 0; k < 4; ++k) {
        check_note("tol %g", (double)tols[k]);
        check_within(within[k], 0.98 * count, count);
    }
}

/* The order of the steps, on a launch whose contact does not turn round. */
static void the_error_is_proportional_to_tol(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coinf_losses l = {0.01f, 0.002f, 0.001f, 0.001f, 0.001f, 0, 0.01f, 0};
    const coinf_state start = {0.7f, 0, 0, 0, 0, 0.3f, 0.8f, 1.2f, {0}};
    const coin_params P = doubles_params(&p);
    const coin_losses L = doubles_losses(&l);
    coin_state want = doubles_state(&start);
    check_status(coin_settle(&want, &P, &L, 4, 1e-12, NULL), COIN_OK);
    double error[2];
    for (int i = 0; i < 2; ++i) {
        coinf_state s = start;
        check_status(coinf_settle(&s, &p, &l, 4, i ? 1e-4f : 1.6e-3f, NULL),
                     COIN_OK);
        error[i] = pose_apart(&s, &want, 1);
    }
    check_within(error[0] / error[1], 8, 32);
}

/* The closed laws of the end: dry contour friction and the rolling moment; the
 * losses that never stop the contact end by the law. */
static void the_times_to_rest_are_those_of_the_laws(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coin_params P = doubles_params(&p);
    const float e = 0.02f;
    const struct {
        coinf_losses l;
        double time;
    } laws[] = {
        {{.dry = 2e-5f}, 0.02 * sqrt(0.02) / (2 * 2e-5)},
        {{.viscous = 1e-6f}, 3 * 0.02 * 0.02 / (16 * 1e-6)},
        {{.damping = 1e-2f}, 1.5 * sqrt(0.02) / 1e-2},
        {{.rolling = 1e-3f}, 1.5 * sqrt(0.02) / 1e-3},
    };
    for (size_t i = 0; i < sizeof laws / sizeof *laws; ++i) {
        coin_state steady;
        check_status(
            coin_steady_spin(&steady, &P, 1.5707963267948966 - (double)e),
            COIN_OK);
        coinf_state s = floats_state(&steady);
        float when;
        check_note("law %zu", i);
        check_status(coinf_settle(&s, &p, &laws[i].l, 1e4f, 1e-2f, &when),
                     COIN_RESTS);
        check_near((double)when / laws[i].time, 1, 0.08);
    }
}

/* ---------------------------------------------------------------------- ends
 */
static void a_coin_at_rest_stays_there(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coinf_losses l = {.dry = 0.002f}, none = {0};
    for (int side = -1; side <= 1; side += 2) {
        coinf_state s = floats_state(&spun);
        float reached = 7;
        s.theta *= (float)side;
        s.wX *= (float)side;
        check_status(coinf_settle(&s, &p, &l, 1e4f, 1e-4f, NULL), COIN_RESTS);
        check_status(coinf_state_check(&s, &p), COIN_OK);
        check(s.theta == (float)side * 1.57079625f && s.wY == 0);
        check((float)side * s.wX > 0 && (float)side * s.wZ > 0);
        const coinf_state flat = s;
        check_status(coinf_settle(&s, &p, &l, 0, 1e-4f, &reached), COIN_RESTS);
        check(reached == 0);
        check_status(coinf_settle(&s, &p, &none, 5, 1e-4f, NULL), COIN_RESTS);
        check_same(&s, &flat, sizeof s);
        check_status(coinf_step(&s, &p, 1e-3f), COIN_ESTEP);
        s.wX = -s.wX; /* it rises */
        check_status(coinf_settle(&s, &p, &l, 1e-3f, 1e-4f, NULL), COIN_OK);
        check(fabsf(s.theta) < 1.5707f);
    }
}

static void a_symmetric_fall_is_an_ideal_one(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coin_params P = doubles_params(&p);
    const coinf_losses laws[] = {
        {0}, {.viscous = 0.1f}, {.damping = 0.1f, .dry = 0.1f, .spin = 0.1f}};
    for (int i = 0; i < 3; ++i) {
        coinf_state s = {.theta = 0.3f};
        coin_state ideal = doubles_state(&s);
        float when;
        double right;
        check_note("law %d", i);
        check_status(coinf_settle(&s, &p, &laws[i], 99, 1e-5f, &when),
                     COIN_RESTS);
        check_status(coin_advance(&ideal, &P, 99, 1e-12, &right), COIN_EFLAT);
        const int slowed = laws[i].damping > 0;
        check_near((double)when, right, slowed ? 1e-3 : 1e-5);
        check_near((double)s.wX, ideal.wX, slowed ? 0.1 : 1e-4);
    }
}

/* Turning about the vertical through the contact, or rising at first: in one
 * call as in ten, as doubles do. */
static void a_stopped_contact_near_flat_is_held(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coin_params P = doubles_params(&p);
    const coinf_losses l = {.dry = 0.1f, .spin = 0.2f};
    const coin_losses L = doubles_losses(&l);
    const float speeds[] = {0, 0.1f, -0.05f};
    for (int k = 0; k < 3; ++k) {
        const float e = 0.03f, sign = k % 2 ? 1 : -1;
        coinf_state s = {.theta = sign * (1.57079637f - e),
                         .phi = 3,
                         .wX = sign * speeds[k],
                         .wY = 0.6f * sinf(e),
                         .wZ = -sign * 0.6f * cosf(e)};
        coinf_state by = s;
        coin_state want = doubles_state(&s);
        float when, reached, sum = 0;
        double right;
        int32_t status;
        check_note("side %g, v %g", (double)sign, (double)speeds[k]);
        check_status(coinf_settle(&s, &p, &l, 9, 1e-4f, &when), COIN_RESTS);
        check_status(coin_settle(&want, &P, &L, 9, 1e-8, &right), COIN_RESTS);
        check_near((double)when, right, 1e-5);
        check_near((double)s.wX, want.wX, 1e-5);
        check_near((double)s.wZ, want.wZ, 1e-5);
        check_near((double)s.psi, 0, 1e-6);
        check_within(pose_apart(&s, &want, 1), 0, 2e-6);
        do {
            status = coinf_settle(&by, &p, &l, when / 7.5f, 1e-4f, &reached);
            sum += reached;
        } while (status == COIN_OK);
        check_status(status, COIN_RESTS);
        check_near((double)sum, (double)when, 2e-6);
        check_within(pose_apart(&by, &want, 1), 0, 4e-6);
    }
}

/* Held by too weak a friction a contact does not stay. */
static void a_contact_that_cannot_be_held_rolls_on(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coinf_losses weak = {.dry = 1e-9f}, fair = {.dry = 8e-4f};
    coinf_state s = {.theta = 1.57079637f - 0.03f,
                     .wX = -0.1f,
                     .wY = 2 * sinf(0.03f),
                     .wZ = -2 * cosf(0.03f)};
    coinf_state rises = {.theta = 1.57079637f - 0.05f,
                         .wX = -0.84f,
                         .wY = 2.8f * sinf(0.05f),
                         .wZ = -2.8f * cosf(0.05f)};
    check_status(coinf_settle(&s, &p, &weak, 1, 1e-4f, NULL), COIN_OK);
    check(fabsf(s.psi) > 1e-6f);
    /* Held where it is, but not where a part of its rise would lead. */
    const coin_params P = doubles_params(&p);
    const coin_losses L = doubles_losses(&fair);
    coin_state want = doubles_state(&rises);
    check_status(coinf_settle(&rises, &p, &fair, 0.5f, 1e-5f, NULL), COIN_OK);
    check_status(coin_settle(&want, &P, &L, 0.5, 1e-10, NULL), COIN_OK);
    check(fabsf(rises.psi) > 1e-6f);
    check_within(pose_apart(&rises, &want, 1), 0, 1e-5);
}

/* Closer than where the law of the end may begin, but much too fast for it. */
static void a_fast_pass_near_flat_does_not_end_the_motion(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coin_params P = doubles_params(&p);
    const coinf_losses l = {.damping = 1e-3f};
    const coin_losses L = doubles_losses(&l);
    coinf_state s = {.theta = 1.55f, .wX = 0.5f, .wY = 2.4e-4f};
    coin_state want = doubles_state(&s);
    check_status(coinf_settle(&s, &p, &l, 0.1f, 1e-5f, NULL), COIN_OK);
    check_status(coin_settle(&want, &P, &L, (double)0.1f, 1e-10, NULL),
                 COIN_OK);
    check(s.wX < -0.3f);
    check_near((double)s.theta, want.theta, 1e-3);
}

/* Steps alone would take many calls. */
static void a_contact_that_never_stops_ends_by_the_law_of_the_end(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coin_params P = doubles_params(&p);
    for (int i = 0; i < 2; ++i) {
        const double e = i ? 0.02 : 1.2e-5, alpha = i ? 1e-2 : 2e-4;
        const coinf_losses l = {.damping = (float)alpha};
        const coin_losses L = doubles_losses(&l);
        coin_state steady;
        check_status(coin_steady_spin(&steady, &P, 1.5707963267948966 - e),
                     COIN_OK);
        coinf_state s = floats_state(&steady);
        coin_state full = doubles_state(&s);
        float when;
        double right;
        check_status(coinf_settle(&s, &p, &l, 1e3f, i ? 1e-5f : 1e-2f, &when),
                     COIN_RESTS);
        check_status(coin_settle(&full, &P, &L, 1e3, 1e-6, &right), COIN_RESTS);
        check_near((double)when / right, 1, 1e-3);
    }
}

/* Where the time is over before, steps go on. */
static void the_law_of_the_end_does_not_shorten_the_call(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coin_params P = doubles_params(&p);
    const coinf_losses l = {.damping = 1e-3f};
    coin_state steady;
    check_status(coin_steady_spin(&steady, &P, 1.5707963267948966 - 9e-7),
                 COIN_OK);
    coinf_state s = floats_state(&steady), other = s;
    float when;
    check_status(coinf_settle(&s, &p, &l, 1, 1e-2f, NULL), COIN_OK);
    check_status(coinf_settle(&s, &p, &l, 100, 1e-2f, &when), COIN_RESTS);
    check_near((double)when, 1.5 * sqrt(9e-7) / 1e-3 - 1, 0.05);
    const coinf_losses with_another = {.damping = 1e-3f, .viscous = 1e-8f};
    check_status(coinf_settle(&other, &p, &with_another, 1e-5f, 1e-2f, NULL),
                 COIN_OK);
}

/* Without a stop, and too close for a pass to be told from a fall. */
static void a_pass_closer_than_a_float_can_tell_is_a_fall(void **unused)
{
    (void)unused;
    const coinf_params p = disc_f();
    const coinf_losses l = {.damping = 0.1f};
    coinf_state s = {.theta = 1.56f, .wX = 0.1f, .wZ = 1e-12f};
    float when;
    check_status(coinf_settle(&s, &p, &l, 5, 1e-4f, &when), COIN_RESTS);
    const double e = 1.5707963267948966 - 1.56, A = 0.8;
    check_near((double)when, (sqrt(0.01 + 2 * A * e) - 0.1) / A, 1e-3);
    check(s.wY == 0 && s.wX > 0.1f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_quarter_rests_after_the_time_of_coin_settle),
        TEST(of_random_launches_98_of_100_err_by_less_than_tol),
        TEST(the_error_is_proportional_to_tol),
        TEST(the_times_to_rest_are_those_of_the_laws),
        TEST(a_coin_at_rest_stays_there),
        TEST(a_symmetric_fall_is_an_ideal_one),
        TEST(a_stopped_contact_near_flat_is_held),
        TEST(a_contact_that_cannot_be_held_rolls_on),
        TEST(a_fast_pass_near_flat_does_not_end_the_motion),
        TEST(a_contact_that_never_stops_ends_by_the_law_of_the_end),
        TEST(the_law_of_the_end_does_not_shorten_the_call),
        TEST(a_pass_closer_than_a_float_can_tell_is_a_fall),
    };
    return RUN_TESTS(tests);
}
