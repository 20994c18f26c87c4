/* SPDX-License-Identifier: MIT */
/* What a step of floats keeps of what rounding leaves out, against doubles, in
 * which a product of two floats is exact.  The source is compiled once more,
 * for its functions that no other file sees. */
#define coinf_step included_step
#define coinf_run included_run
#include "coinf_step.c"

#include "support/check.h"
#include "support/random.h"

#include <math.h>

/* Half the distance between 1 and the next float. */
#define UF 0x1p-24

static float between(struct random *r, double low, double high)
{
    return (float)random_between(r, low, high);
}

TEST(the_residue_of_a_product_is_all_that_rounding_leaves_out)
{
    const int count = tries_asked(5000);
    struct random r = random_begin(651);
    for (int i = 0; i < count; ++i) {
        const float a = between(&r, -3, 3), b = between(&r, -3, 3), ab = a * b;
        check_note("%a times %a", (double)a, (double)b);
        check(coinf_priv_residue(a, b) == (double)a * b - ab);
    }
}

/* An ulp of the function itself, and half of one of the sum.  What the square
 * of a remainder adds is 5e-13. */
TEST(sine_and_cosine_are_those_of_an_angle_and_its_remainder)
{
    const int count = tries_asked(5000);
    struct random r = random_begin(652);
    for (int i = 0; i < count; ++i) {
        const float x = between(&r, -4, 4), low = between(&r, -1, 1) * 0x1p-20f;
        const coin_priv_sc got = coinf_priv_sine_cosine_with_low(x, low);
        const double s = sin((double)x + low), c = cos((double)x + low);
        check_note("%a + %a", (double)x, (double)low);
        check_near(got.s, s, 3 * UF * fabs(s) + 1e-12);
        check_near(got.c, c, 3 * UF * fabs(c) + 1e-12);
    }
}

/* Each quarter turn but for P4, 2.6e-12, and the rounding of the remainders,
 * which are up to 2^-24 radians there.  The number of turns is rounded from a
 * float: three roundings of it. */
TEST(whole_turns_are_subtracted_to_the_last_part_of_pi)
{
    const int count = tries_asked(5000);
    struct random r = random_begin(653);
    const double turn = 6.283185307179586;
    for (int i = 0; i < count; ++i) {
        const float from = between(&r, -4096, 4096);
        const float left = between(&r, -1, 1) * 0x1p-22f;
        float angle = from, low = left;
        coinf_priv_reduce(&angle, &low);
        const double sum = (double)from + left, got = (double)angle + low;
        const double turns = rint((sum - got) / turn);
        check_note("%a + %a", (double)from, (double)left);
        check_within(fabs(got), 0, turn / 2 + 3 * UF * fabs(sum));
        check_near(got, sum - turns * turn, 1.1e-11 * fabs(turns) + 0x1p-46);
    }
}

/* The stepper of a random body, and a state.  I_Z has so few digits that the
 * sum a + I_Z/(M a) of its float is exact. */
static coinf_priv_stepper random_stepper(struct random *r, coinf_params *p,
                                         coinf_state *s)
{
    coinf_priv_stepper stepper;
    const float a = floorf(between(r, 1, 1024)) / 64;
    const float IZ = a * floorf(between(r, 32, 256)) / 64;
    const coinf_params body = {1, a, between(r, 1, 100), IZ, IZ, 0, {0, 0}};
    const coinf_state state = {.theta = between(r, -1.4, 1.4),
                               .wX = between(r, -1, 1),
                               .wY = between(r, -1, 1),
                               .wZ = between(r, -1, 1)};
    *p = body;
    *s = state;
    check_status(
        coinf_priv_stepper_of(&stepper, s, p, COIN_RK4, between(r, 1e-3, 1e-2)),
        COIN_OK);
    return stepper;
}

/* KJ_low is a few roundings of KJ, and computed to a few of itself. */
TEST(the_torques_of_roll_and_weight_balance_to_twice_the_digits)
{
    const int count = tries_asked(5000);
    struct random r = random_begin(654);
    for (int i = 0; i < count; ++i) {
        coinf_params p;
        coinf_state s;
        const coinf_priv_stepper stepper = random_stepper(&r, &p, &s);
        const double KJ = (double)stepper.f.KJ + stepper.KJ_low;
        const double sum = p.radius + (double)p.inertia_Z / p.radius;
        check_note("body %d", i);
        check_near(KJ / stepper.f.GJ, sum / p.gravity,
                   32 * UF * UF * sum / p.gravity);
    }
}

/* Likewise the remainders of the first slope. */
TEST(what_the_first_slope_leaves_out_completes_it)
{
    const int count = tries_asked(5000);
    struct random r = random_begin(655);
    for (int i = 0; i < count; ++i) {
        coinf_params p;
        coinf_state s;
        const coinf_priv_stepper stepper = random_stepper(&r, &p, &s);
        const coin_priv_variables y = coinf_priv_variables_with_low(&s);
        const coinf_priv_slope first = coinf_priv_slope_at(&stepper, &y);
        const coinf_priv_slope low = coinf_priv_left_out(&first, &stepper, &y);
        const double dphi = (double)stepper.f.h * y.wY / y.cth;
        const double fall = -(double)stepper.KJ_low * y.wZ * y.wY;
        check_note("state %d", i);
        check_near(first.phi + (double)low.phi, dphi,
                   32 * UF * UF * fabs(dphi));
        check_near(low.psi, (double)low.phi * y.sth, UF * fabs(low.phi));
        check_near(low.wX, fall, 2 * UF * fabs(fall));
        check(low.theta == 0 && low.x == 0 && low.z == 0 && low.wY == 0 &&
              low.wZ == 0);
    }
}
