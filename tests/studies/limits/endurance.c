/* SPDX-License-Identifier: MIT */
/* A thousand million steps of RK4 on steady motions, whose end is known in
 * closed form.
 *
 * Rolling straight on nothing changes but two sums, and these carry what
 * rounding leaves out: a few u in all.  On a circle the lean and the rates
 * wobble by what n roundings may have come to, u sqrt(n), about what the
 * integrals make them; of that nothing stays in heading and roll. */
#include "check.h"
#include "coins.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define STEPS 1000000000
#define DT 1e-3

static coin_state after(const coin_state *start, const coin_params *p)
{
    coin_state s = *start;
    uint64_t done = 0;
    check_status(coin_run(&s, p, COIN_RK4, DT, STEPS, &done), COIN_OK);
    check(done == STEPS);
    return s;
}

TEST(a_straight_roll_is_right_to_the_last_digit)
{
    const coin_params p = disc();
    coin_state start;
    check_status(coin_steady_roll(&start, &p, 1.25), COIN_OK);
    const coin_state s = after(&start, &p);
    const double turned = 1.25 * STEPS * DT;
    check_near(s.psi, turned, 8 * U * turned);
    check_near(fabs(s.x), turned, 8 * U * turned);
    check(s.theta == 0 && s.z == 0 && s.wZ == 1.25);
}

TEST(a_circle_is_right_to_a_few_u)
{
    const coin_params p = disc();
    const coin_state start = circle(&p, 0.5, 1.5, 1);
    const coin_state s = after(&start, &p);
    coin_state want;
    check_status(coin_steady_at(&start, &p, STEPS * DT, &want), COIN_OK);
    const double walk = U * sqrt(STEPS);
    printf("heading off by %.2g of %.7g, roll by %.2g of %.7g\n",
           s.phi - want.phi, want.phi, s.psi - want.psi, want.psi);
    check_near(s.theta, start.theta, walk);
    check_near(s.wY, start.wY, walk);
    check_near(s.wZ, start.wZ, walk);
    check_near(s.phi, want.phi, 16 * U * fabs(want.phi));
    check_near(s.psi, want.psi, 16 * U * fabs(want.psi));
}
