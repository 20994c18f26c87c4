/* SPDX-License-Identifier: MIT */
/* Motions whose rates are near the least doubles, or the largest in range. */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"
#include "support/random.h"

#include <float.h>
#include <math.h>

/* By n steps dt of one method, or of coin_advance() if it is METHODS. */
static int32_t move(coin_state *s, const coin_params *p, int32_t method,
                    double dt, uint64_t n)
{
    return method < METHODS ? coin_run(s, p, method, dt, n, NULL)
                            : coin_advance(s, p, (double)n * dt, 1e-12, NULL);
}

/* An upright coin that is pushed by less than a normal number: by the linear
 * theory, e^(t sqrt(4/5)) times as much by t, and by no cliff in between. */
TEST(pushes_below_the_normal_numbers_stay_small)
{
    const coin_params p = disc();
    const double tiny = DBL_MIN / 1024;
    const coin_state start = {tiny, tiny, tiny, 0, 0, tiny, -tiny, tiny};
    for (int32_t method = 0; method <= METHODS; ++method) {
        coin_state s = start;
        check_note("method %d", (int)method);
        check_status(move(&s, &p, method, 0.05, 200), COIN_OK);
        const double rate = sqrt(0.8), t = 10;
        const double theta =
            tiny * (cosh(rate * t) + sinh(rate * t) / rate); /* (42) */
        check_near(s.theta, theta, 0.01 * theta);
        check(s.wY == -tiny && s.wZ == tiny);
        check_near(s.phi, tiny * (1 - t), 1e-3 * tiny);
        check_within(fabs(s.x), 0.9 * tiny * t, 1.1 * tiny * t);
    }
}

/* A fast coin is one that hardly feels gravity: in a unit of time that is a
 * power of two the two are the same motion, to the last bit. */
TEST(a_fast_coin_moves_as_without_gravity)
{
    const coin_params p = disc();
    coin_params floating = p;
    floating.gravity = 0x1p-36;
    for (int32_t method = 0; method <= METHODS; ++method) {
        const coin_state slow = {0.5, 0, 0, 0, 0, 0.1, 0.8, 1.2};
        coin_state fast = slow, light = slow;
        fast.wX *= 0x1p18;
        fast.wY *= 0x1p18;
        fast.wZ *= 0x1p18;
        check_note("method %d", (int)method);
        check_status(move(&fast, &p, method, 0x1p-23, 800), COIN_OK);
        check_status(move(&light, &floating, method, 0x1p-5, 800), COIN_OK);
        fast.wX /= 0x1p18;
        fast.wY /= 0x1p18;
        fast.wZ /= 0x1p18;
        check_within(states_apart(&fast, &slow, &p), 1, 100);
        check_same(&fast, &light, sizeof fast);
    }
}

/* However fast it falls on its face: its velocity rounds by more than 1e-10. */
TEST(a_fast_fall_next_to_flat_is_over_in_few_calls)
{
    struct random r = random_begin(65);
    const coin_table f = {.mu_static = 0.6, .mu_kinetic = 0.6};
    for (int i = 0; i < 2000; ++i) {
        coin_params p;
        check_status(
            coin_params_disc(&p, 1, random_between(&r, 0.01, 0.02), 9.81),
            COIN_OK);
        const double flat = random_between(&r, 1e-6, 1e-3);
        const double w0 = sqrt(p.gravity / p.radius);
        const coin_state s = {.theta = asin(1) - flat,
                              .wX = random_between(&r, 5e5, 9e5) * w0,
                              .wY = random_between(&r, -1, 1) * w0,
                              .wZ = random_between(&r, -4, 4) * w0};
        const double end = 2 * flat / s.wX;
        coin_body b;
        double reached;
        int calls = 0;
        check_note("seed 65, coin %d", i);
        check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
        for (double t = 0; t < end; t += reached)
            check(coin_move(&b, &p, &f, end - t, 1e-6, COIN_NEARLY_FLAT,
                            &reached) >= 0 &&
                  ++calls < 10);
    }
}
