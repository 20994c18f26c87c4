/* SPDX-License-Identifier: MIT */
/* Wobbles that lead to no state: each member leaves its range. */
#include "support/check.h"
#include "support/coins.h"
#include "support/vast.h"

#include <float.h>
#include <math.h>

static void refused(const coin_state *steady, const coin_state *start, double t)
{
    const coin_params p = ring(0);
    coin_state out = {1, 2, 3, 4, 5, 6, 7, 8};
    const coin_state before = out;
    check_status(coin_wobble_at(steady, &p, start, t, &out), COIN_ESTEP);
    check_same(&out, &before, sizeof out);
}

/* The fastest upright spin that coin_state_check() accepts. */
static double fastest_spin(const coin_params *p)
{
    double least = 1, most = DBL_MAX;
    for (int i = 0; i < 2000; ++i) {
        const double mid = sqrt(least) * sqrt(most);
        const coin_state s = {.wY = mid};
        *(coin_state_check(&s, p) == COIN_OK ? &least : &most) = mid;
    }
    return least;
}

/* It nods, and |omega| exceeds its limit where wX is largest. */
static void what_leaves_the_range_of_rates_is_refused(void **unused)
{
    (void)unused;
    const coin_params p = ring(0);
    const coin_state spin = {.wY = fastest_spin(&p)};
    coin_state start = spin;
    start.theta = 0.01;
    refused(&spin, &start, 1 / spin.wY);
}

/* Roll, heading and path each. */
static void what_leaves_the_range_of_the_pose_is_refused(void **unused)
{
    (void)unused;
    const coin_params p = ring(0);
    coin_state start = {.wZ = 1};
    start.psi = 0x1p31 - 1;
    refused(&start, &start, 2);
    /* A spin just above its critical rate turns 100 times in a wobble. */
    coin_state spin;
    check_status(
        coin_steady_upright_spin(&spin, &p, 1.0001 * coin_critical_spin(&p)),
        COIN_OK);
    start = spin;
    start.theta = 1e-9;
    refused(&spin, &start, 1e11);
    for (int along_z = 0; along_z < 2; ++along_z) {
        coin_params vast;
        coin_state out;
        double dt;
        const coin_state edge = vast_coin(&vast, along_z ? acos(0) : 0, &dt);
        check_status(coin_wobble_at(&edge, &vast, &edge, 10 * dt, &out),
                     COIN_OK);
        check_status(coin_wobble_at(&edge, &vast, &edge, 100 * dt, &out),
                     COIN_ESTEP);
    }
}

/* phi is rounded, but not the direction of the path. */
static void a_large_heading_does_not_displace_the_path(void **unused)
{
    (void)unused;
    const coin_params p = ring(0);
    coin_state s, is, want;
    check_status(coin_steady_circle(&s, &p, 0.5, 1, 1), COIN_OK);
    s.phi = 2e9;
    for (double t = 0.1; t < 3; t += 0.4) {
        check_status(coin_wobble_at(&s, &p, &s, t, &is), COIN_OK);
        check_status(coin_steady_at(&s, &p, t, &want), COIN_OK);
        check_near(is.x, want.x, 1e-13);
        check_near(is.z, want.z, 1e-13);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(what_leaves_the_range_of_rates_is_refused),
        TEST(what_leaves_the_range_of_the_pose_is_refused),
        TEST(a_large_heading_does_not_displace_the_path),
    };
    return RUN_TESTS(tests);
}
