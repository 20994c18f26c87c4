/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/random.h"
#include "support/steadies.h"

#include "steady_near.h"

#include <math.h>

static int32_t near_of(coin_state *s, const coin_params *p)
{
    coin_priv_body b;
    check_status(coin_priv_check(s, p, &b), COIN_OK);
    return coin_priv_steady_near(s, &b);
}

/* A stable circle, disturbed along its leaf, finds itself again, to what its
 * rounding is worth: u over the curvature of the potential. */
static void a_disturbed_circle_finds_its_circle(void **unused)
{
    (void)unused;
    struct table t;
    table_load(&t, "circles.csv");
    int found = 0;
    for (size_t row = 0; row < t.rows; ++row) {
        const struct circle c = circle_at(&t, row);
        const double w = 1 / natural_time(&c.params);
        coin_state s = c.state;
        double lambda2;
        check_status(coin_stability(&s, &c.params, &lambda2), COIN_OK);
        if (fabs(c.theta) > 1.4 || lambda2 > -1e-3 * w * w)
            continue;
        s.wX = 0.001 * w;
        check_status(coin_advance(&s, &c.params, 0.3 / w, 1e-13, NULL),
                     COIN_OK);
        check_status(near_of(&s, &c.params), COIN_OK);
        check(s.wX == 0);
        check_near(s.theta, c.theta, 1e-11);
        check_near(s.wY, c.wY, 1e-11 * (fabs(c.wY) + fabs(c.wZ) + w));
        check_near(s.wZ, c.wZ, 1e-11 * (fabs(c.wY) + fabs(c.wZ) + w));
        ++found;
    }
    check(found > 10);
}

/* Both integrals are kept on a way of up to 0.6 rad, as is the pose. */
static void the_integrals_are_those_of_the_state(void **unused)
{
    (void)unused;
    struct random r = random_begin(61);
    int found = 0;
    for (int i = 0; i < 1000; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.4);
        coin_state near = s;
        double of_s[2], of_near[2];
        if (near_of(&near, &p) != COIN_OK || fabs(near.theta - s.theta) > 0.6)
            continue;
        check_status(coin_integrals(&s, &p, of_s), COIN_OK);
        check_status(coin_integrals(&near, &p, of_near), COIN_OK);
        for (int k = 0; k < 2; ++k)
            check_near(of_near[k], of_s[k],
                       192 * U * (fabs(near.wY) + fabs(near.wZ)));
        check(near.phi == s.phi && near.psi == s.psi && near.x == s.x &&
              near.z == s.z);
        ++found;
    }
    check(found > 300);
}

/* Beside the top of the hill between two valleys, where Newton's method would
 * lead to the top. */
static void a_valley_is_found_where_newton_leads_uphill(void **unused)
{
    (void)unused;
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    for (int side = -1; side <= 1; side += 2) {
        coin_state s = {.wX = 0.1 * side, .wZ = 0.5};
        double lambda2;
        check_status(coin_advance(&s, &p, 0.2, 1e-13, NULL), COIN_OK);
        check_within(s.theta * side, 0.01, 0.03);
        check_status(near_of(&s, &p), COIN_OK);
        check_status(coin_stability(&s, &p, &lambda2), COIN_OK);
        check(s.theta * side > 0.1 && lambda2 < 0);
    }
}

/* The rounding of theta leaves a fast coin unsteady, if its rates are not
 * balanced. */
static void a_fast_coin_is_balanced(void **unused)
{
    (void)unused;
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    for (double w = 1e3; w <= 1e6; w *= 10) {
        coin_state s = {.theta = 0.35, .wX = 1, .wY = -w, .wZ = -w};
        double lambda2;
        check_note("w %g", w);
        check_status(near_of(&s, &p), COIN_OK);
        check_status(coin_stability(&s, &p, &lambda2), COIN_OK);
    }
}

/* As far as the rounding of theta tells: a part 2 u/e of the angle e. */
static void a_disturbed_spin_next_to_flat_finds_a_spin(void **unused)
{
    (void)unused;
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    for (double e = 1e-2; e > 5e-10; e /= 3) {
        coin_state s;
        check_note("%g from flat", e);
        check_status(coin_steady_spin(&s, &p, acos(0) - e), COIN_OK);
        s.wY *= 1.02;
        check_status(near_of(&s, &p), COIN_OK);
        check_near(s.wY * s.wY, 4 * (acos(0) - s.theta), (1e-2 * e + 4e-16));
    }
}

/* At rest there is no valley before flat. */
static void a_coin_that_falls_flat_has_none(void **unused)
{
    (void)unused;
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    const double leans[] = {0.1, 1.5707, acos(0) - 1e-9};
    for (int i = 0; i < 3; ++i) {
        coin_state s = {leans[i], 1, 2, 3, 4, 0, 0, 0};
        const coin_state start = s;
        check_status(near_of(&s, &p), COIN_EDOMAIN);
        check_same(&s, &start, sizeof s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_disturbed_circle_finds_its_circle),
        TEST(the_integrals_are_those_of_the_state),
        TEST(a_valley_is_found_where_newton_leads_uphill),
        TEST(a_fast_coin_is_balanced),
        TEST(a_disturbed_spin_next_to_flat_finds_a_spin),
        TEST(a_coin_that_falls_flat_has_none),
    };
    return RUN_TESTS(tests);
}
