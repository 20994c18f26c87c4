/* SPDX-License-Identifier: MIT */
/* Steps in Sundman's variable tau, dt = cos theta dtau. */
#include "support/check.h"
#include "support/methods.h"
#include "support/observable.h"
#include "support/random.h"

#include "advance.h"

#include <math.h>

/* Bound: 8 u of the terms in either form, and cos theta's own. */
TEST(the_slope_of_wX_is_that_in_time_times_cos_theta)
{
    struct random r = random_begin(48);
    for (int i = 0; i < 1000; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.57);
        const struct parts k = parts_of(&s, &p);
        const coin_priv_constants b = coin_priv_constants_of(&p);
        const double h = natural_time(&p);
        const coin_priv_field f = coin_priv_field_of(&b, h);
        const coin_priv_variables y = coin_priv_variables_of(&s);
        check_near(coin_priv_sundman_slope(&f, &y),
                   y.cth * coin_priv_slopes_at(&f, &y).wX,
                   20 * U * h * y.cth * k.dwX);
    }
}

/* Where wX is 0 and the heading turns, its slope says how fast the motion
 * changes: by at most a third of the rate in a step of stride 1. */
TEST(a_stride_bounds_what_the_slope_of_wX_adds)
{
    struct random r = random_begin(49);
    int decides = 0;
    for (int i = 0; i < 1000; ++i) {
        const double I_X = random_between(&r, 0.01, 0.5);
        const double ratio = random_between(&r, 0.01, 2);
        const coin_state s = {
            .wY = random_between(&r, -3, 3),
            .wZ = random_between(&r, -9, 9),
        };
        coin_params p;
        check_status(coin_params_body(&p, 1, 1, 1, I_X, ratio * I_X), COIN_OK);
        const coin_priv_constants b = coin_priv_constants_of(&p);
        const coin_priv_field f = coin_priv_field_of(&b, 1);
        const coin_priv_variables y = coin_priv_variables_of(&s);
        const double tau = coin_priv_sundman_tau(&b, &y, 1);
        const double part = fabs(coin_priv_sundman_slope(&f, &y)) * tau * tau;
        check_note("seed 49, body %d", i);
        check_within(part, 0, 1.0 / 3 + 8 * U);
        decides += part > 0.333;
    }
    check(decides > 30);
}

/* Pairs of length 1 + d get the length 1 and keep their direction.  The error
 * that is left is the first term left out, 5/16 e^3 with e = 2 |d|. */
TEST(pairs_get_the_length_1)
{
    struct random r = random_begin(50);
    for (int i = 0; i < 1000; ++i) {
        const double size = pow(10, random_between(&r, -8, -2));
        const double th = random_between(&r, -1.57, 1.57);
        const double ph = random_between(&r, -3.14, 3.14);
        const double lean = 1 + size * random_between(&r, -1, 1);
        const double turn = 1 + size * random_between(&r, -1, 1);
        coin_priv_variables y = {
            .sth = lean * sin(th),
            .cth = lean * cos(th),
            .sph = turn * sin(ph),
            .cph = turn * cos(ph),
        };
        const double bound = 3 * size * size * size + 8 * U;
        coin_priv_normalize(&y);
        check_note("%g, %g off by %g", th, ph, size);
        check_near(y.sth, sin(th), bound);
        check_near(y.cth, cos(th), bound * cos(th));
        check_near(y.sph, sin(ph), bound);
        check_near(y.cph, cos(ph), bound);
        check_near(y.q * cos(th), 1, bound);
        check_near(y.tth * cos(th), sin(th), bound);
    }
}

/* Found by trials.  The series of (54) has the wrong sign here: 2^20 steps led
 * nowhere. */
TEST(a_heavy_rim_that_turns_fast_comes_to_the_end)
{
    const coin_state start = {.theta = -0.21288164719607758,
                              .wX = -25.489078586150711,
                              .wY = 24.76220656786483,
                              .wZ = 25.405091383051769};
    const double t = 0.05640572291110902, I_X = 2.4265773581669983;
    coin_params p;
    coin_state exact = start;
    check_status(coin_params_body(&p, 1, 1, 1, I_X, 2 * I_X), COIN_OK);
    check_status(coin_run(&exact, &p, COIN_RK8, t / 4096, 4096, NULL), COIN_OK);
    for (double tol = 1e-2; tol > 1e-5; tol /= 10) {
        coin_state s = start;
        double reached;
        check_status(coin_advance(&s, &p, t, tol, &reached), COIN_OK);
        check(reached == t);
        const double n = t * sqrt(2 * coin_energy(&start, &p));
        check_within(path_apart(&s, &exact, &p), 0, 2 * tol * (1 + n));
    }
}

/* Bodies of any I_Z, that may roll far faster than they turn and fall. */
static coin_priv_variables any_coin(struct random *r, coin_priv_constants *b)
{
    coin_params p;
    const double IX = pow(10, random_between(r, -3, 3));
    const double part = 2 * pow(10, random_between(r, -3.3, 0));
    check_status(coin_params_body(&p, 1, 1, 1, IX, part * IX), COIN_OK);
    coin_state s = random_state(r, &p, 1.57);
    s.wX *= pow(10, random_between(r, -4, 0));
    s.wY *= pow(10, random_between(r, -4, 0));
    s.wZ *= pow(10, random_between(r, 0, 2));
    *b = coin_priv_constants_of(&p);
    return coin_priv_variables_of(&s);
}

/* So that phi and psi are watched closely enough near the ends of their range
 * (coin_priv_refusal()). */
TEST(no_step_in_tau_turns_or_rolls_by_16_rad)
{
    struct random r = random_begin(49);
    for (int i = 0; i < 10000; ++i) {
        coin_priv_constants b;
        const coin_priv_variables y = any_coin(&r, &b);
        const double tau = coin_priv_sundman_tau(&b, &y, COIN_PRIV_LONGEST);
        check_within(tau * (fabs(y.wY) + fabs(y.cth * y.wZ)), 0, 16);
    }
}

/* Each step to an end that two steps reach leads on, whatever its series. */
TEST(a_step_to_the_end_leads_on)
{
    struct random r = random_begin(50);
    for (int i = 0; i < 10000; ++i) {
        coin_priv_constants b;
        const coin_priv_variables y = any_coin(&r, &b);
        const double full = coin_priv_sundman_tau(&b, &y, COIN_PRIV_LONGEST);
        const double rem = random_between(&r, 0, 2) * full * y.cth;
        check(coin_priv_tau_of(&b, &y, rem) > 0);
        check(coin_priv_tau_of(&b, &y, -rem) < 0);
    }
}
