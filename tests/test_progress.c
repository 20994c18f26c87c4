/* SPDX-License-Identifier: MIT */
/* What a run keeps from step to step: pairs, compensated sums, blocks. */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"
#include "support/random.h"

#include "coin_run.h"
#include "sundman.h"

#include <math.h>

#define HALF_PI 1.5707963267948966

enum { SAMPLES = 200 };

static coin_priv_constants body_of(const coin_params *p)
{
    coin_priv_constants b;
    b = coin_priv_constants_of(p);
    return b;
}

/* ---------------------------------------------------------- into and out */
TEST(a_run_of_no_steps_is_where_it_began)
{
    const coin_params p = disc();
    const coin_state s = {0.5, -0.0, 2e9, 1e300, -0.0, 0.1, -0.0, 1.2};
    coin_priv_run r = {.b = body_of(&p)};
    coin_priv_run_from(&r, &s, COIN_RK4, 0.01);
    const coin_state same = coin_priv_run_state(&r);
    check_same(&same, &s, sizeof s);
}

/* Angles to the bit, the centre through the contact by 8 u of a radius, in the
 * middle of a block and at its end. */
TEST(the_progress_of_no_steps_is_the_state)
{
    struct random r = random_begin(91);
    for (int i = 0; i < 1000; ++i) {
        const coin_params p = random_coin(&r);
        coin_state s = random_state(&r, &p, HALF_PI);
        s.phi *= pow(10, random_between(&r, 0, 5));
        coin_priv_run run = {.b = body_of(&p)};
        coin_priv_run_from(&run, &s, COIN_RK4, 0.01);
        run.steps = 1; /* of length 0: its state is not its start */
        for (int ended = 0; ended < 2; ++ended) {
            const coin_state t = coin_priv_run_state(&run);
            check(t.theta == s.theta && t.phi == s.phi && t.psi == s.psi);
            check(t.wX == s.wX && t.wY == s.wY && t.wZ == s.wZ);
            check_near(t.x, s.x, 8 * U * p.radius);
            check_near(t.z, s.z, 8 * U * p.radius);
            coin_priv_end_block(&run.g);
        }
    }
}

/* However small the cosine that steps in tau come to, and whatever the angle
 * that is summed, the state's lean is that of a coin above the table. */
TEST(a_lean_at_the_table_is_the_last_before_it)
{
    const coin_params p = disc();
    const double last = HALF_PI - 0x1p-52;
    const coin_state start = {.theta = 0.3};
    for (int side = -1; side <= 1; side += 2)
        for (double cth = 1e-3; cth > 1e-300; cth /= 10) {
            coin_priv_run r = {.b = body_of(&p)};
            coin_priv_run_from(&r, &start, COIN_RK4, 0.01);
            r.g.y.sth = side * sqrt(1 - cth * cth);
            r.g.y.cth = cth;
            coin_priv_read_lean(&r.g);
            r.steps = 1;
            const coin_state s = coin_priv_run_state(&r);
            check_note("cos theta = %g", cth);
            check_status(coin_state_check(&s, &p), COIN_OK);
            if (cth < 1e-16)
                check(s.theta == side * last);
            else
                check_near(s.theta, side * acos(cth), 4 * U);
        }
}

/* -------------------------------------------------------------- the sums */
TEST(compensated_sums_keep_what_rounding_leaves_out)
{
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
TEST(a_straight_roll_is_as_long_as_its_product)
{
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
TEST(small_steps_of_a_large_roll_are_not_lost)
{
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

/* --------------------------------------------------------- angles and pairs */
/* 1e4 rad of heading, 0.4 in a step: the rate is constant, and the angle is its
 * product with the time for every method.  The addend has some roundings. */
TEST(a_fast_spin_counts_its_turns)
{
    const coin_params p = disc();
    const double wY = 1000, dt = 0.4 / wY;
    const uint64_t n = 25000;
    for (int32_t method = 0; method < METHODS; ++method) {
        coin_state s;
        check_status(coin_steady_upright_spin(&s, &p, wY), COIN_OK);
        check(coin_run(&s, &p, method, dt, n, NULL) >= 0);
        check_note("method %d", (int)method);
        check_near(s.phi, wY * dt * (double)n, 16 * U * 1e4);
    }
}

/* Of steps of all sizes, up to the largest that a method takes: after each, the
 * pairs of lean and heading are those of the angles.  A step turns a pair to
 * 2 u, and its angle is off by u of itself. */
TEST(pairs_and_angles_are_one_after_every_step)
{
    check_long_double();
    const int count = tries_asked(600);
    struct random r = random_begin(93);
    int done = 0;
    for (int i = 0; i < count; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.4);
        const int32_t method = i % METHODS;
        const double dt = coin_priv_reaches[method].refusal *
                          pow(10, random_between(&r, -2, 0)) /
                          fastest_rate(&s, &p);
        coin_priv_run run = {.b = body_of(&p)};
        coin_priv_run_from(&run, &s, method, dt);
        for (int k = 1; k < 2 * COIN_PRIV_BLOCK; ++k) {
            if (coin_priv_run_on(&run, method, 1) == 0)
                break;
            const coin_priv_progress *g = &run.g;
            const double theta = g->added.theta;
            const long double phi =
                (long double)g->phi.sum + g->phi.low + g->added.phi;
            const int since = k % COIN_PRIV_BLOCK;
            const double bound = 2 * U * (1 + since) * (1 + fabs(g->added.phi));
            check_note("method %d, step %d", (int)method, k);
            check_near(g->y.sth, sin(theta), bound + since * U * fabs(theta));
            check_near(g->y.cth, cos(theta), bound + since * U * fabs(theta));
            check_near(g->y.sph, (double)sinl(phi), bound);
            check_near(g->y.cph, (double)cosl(phi), bound);
            check_near(g->y.q * g->y.cth, 1, 2 * U);
            ++done;
        }
    }
    check(done > 25 * count);
}

/* A coin that spins near the table swings by the force there, which is
 * proportional to cos theta.  The rounding of theta is a part 1e-16/cos theta
 * of it: taken anew from theta in every block, cos theta would spoil the rates.
 * As the sines and cosines are kept, a step rounds cos theta by a part u, which
 * shifts the phase by half of that times the phase still to come.  Four
 * standard deviations of the sum of these shifts, and of those in steps half as
 * long, are allowed. */
TEST(near_the_table_the_rounding_of_theta_does_not_reach_the_rates)
{
    const coin_params p = disc();
    const uint64_t steps = 50 * COIN_PRIV_BLOCK + 17;
    const int count = tries_asked(2);
    struct random r = random_begin(305);
    for (int i = 0; i < count; ++i) {
        const double angle = 4 * pow(10, random_between(&r, -6, -3));
        const double size = sqrt(angle), W = 2 / size;
        coin_state s = {.theta = HALF_PI - angle,
                        .wX = 0.1 * size * random_between(&r, -1, 1),
                        .wY = 2 * size * random_between(&r, 0.9, 1.1)};
        const double dt = 0.03 / W, phase = (double)steps * 0.03;
        coin_state half = s;
        check_status(coin_run(&s, &p, COIN_RK8, dt, steps, NULL), COIN_OK);
        check_status(coin_run(&half, &p, COIN_RK8, dt / 2, 2 * steps, NULL),
                     COIN_OK);
        const double bound =
            4 * sqrt(3.0 * (double)steps) * phase / 2 * U * size;
        check_note("%g from flat", angle);
        check_near(s.wX, half.wX, bound);
        check_near(s.wY, half.wY, bound);
    }
}

/* Next to a steady motion a step changes lean and rates by less than their
 * rounding.  A sum that kept what the others lose would drift: by 1e-11 in a
 * million steps.  What n roundings may come to is u sqrt(n), in a well as soft
 * as lambda^2 = -1/4 four times that. */
TEST(rounding_does_not_drift_on_a_circle)
{
    const coin_params p = disc();
    const uint64_t n = 10000;
    const double walk = 4 * U * sqrt((double)n);
    int done = 0;
    for (int i = 0; i < 10; i += 2) {
        const double theta = -1.2 + 0.26 * i, wZ = 0.9 + i * 7 % 20 / 20.0;
        const coin_state start = circle(&p, theta, wZ, i % 4 ? 1 : -1);
        double lambda2;
        check_status(coin_stability(&start, &p, &lambda2), COIN_OK);
        for (int32_t method = 0; lambda2 < -0.25 && method < METHODS;
             ++method) {
            coin_state s = start;
            check_note("theta = %g, wZ = %g, method %d", theta, wZ,
                       (int)method);
            if (coin_run(&s, &p, method, 1e-3, n, NULL) != COIN_OK)
                continue;
            check_near(s.theta, start.theta, walk);
            check_near(s.wY, start.wY, walk * fmax(1, fabs(start.wY)));
            check_near(s.wZ, start.wZ, walk);
            ++done;
        }
    }
    check(done > 10);
}

/* So that how a run is cut does not matter even then. */
TEST(coarse_turns_are_counted_alike_in_one_run_and_in_many)
{
    const coin_params p = disc();
    for (int32_t method = 0; method < METHODS; ++method) {
        coin_state one, many;
        check_status(coin_steady_upright_spin(&one, &p, 1000), COIN_OK);
        many = one;
        const double dt = 0.999 * coin_priv_reaches[method].refusal / 1000;
        check_status(coin_run(&one, &p, method, dt, 1000, NULL), COIN_COARSE);
        for (int i = 0; i < 1000; ++i)
            check_status(coin_run(&many, &p, method, dt, 1, NULL), COIN_COARSE);
        check_note("method %d", (int)method);
        check_near(many.phi, one.phi, 8 * U * 1000 * one.phi);
    }
}

/* Steps of 1e-9 rad from 2^31: half of what a double resolves beyond is passed
 * in the fourth block.  The steps before are kept. */
TEST(a_slow_turn_ends_at_the_edge_of_its_range)
{
    const coin_params p = disc();
    const coin_state edges[] = {{.phi = 0x1p31, .wY = 1},
                                {.psi = -0x1p31, .wZ = -1}};
    for (int32_t method = 0; method < METHODS; ++method)
        for (int i = 0; i < 2; ++i) {
            coin_state s = edges[i];
            uint64_t done;
            check_note("method %d, edge %d", (int)method, i);
            check_status(coin_run(&s, &p, method, 1e-9, 1000, &done),
                         COIN_ERANGE);
            check_within((double)done, 0x1p-22 * 1e9 - 1, 0x1p-22 * 1e9 + 1);
            check(s.phi == edges[i].phi && s.psi == edges[i].psi);
        }
}

/* ------------------------------------------------------------ the limits */
/* COIN_COARSE comes exactly if W, where some step of the run begins or ends,
 * is beyond the method's limit: a run looks at W only where the energy
 * allows it to be. */
TEST(the_warning_is_that_of_the_largest_rate)
{
    struct random r = random_begin(92);
    coin_state path[SAMPLES];
    int coarse = 0, fine = 0;
    for (int i = 0; i < 1000; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.5);
        coin_state end = s;
        const int32_t method = i % METHODS;
        const double limit = coin_priv_reaches[method].coarse;
        const double dt = limit / fastest_rate(&s, &p) *
                          pow(10, random_between(&r, -0.7, 0.01));
        const int32_t status =
            coin_sample(&s, &p, method, dt, 1, SAMPLES, path, NULL);
        check_status(coin_run(&end, &p, method, dt, SAMPLES - 1, NULL), status);
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
