/* SPDX-License-Identifier: MIT */
/* Sine and cosine of floats, against the C library's of doubles. */
#include "floats.h"

#include "angles.h"

#include "support/check.h"
#include "support/random.h"

#include <math.h>

/* Distance to the next float away from 0. */
static double ulp(double x)
{
    const float size = fabsf((float)x);
    return (double)nextafterf(size, INFINITY) - size;
}

static void check_pair(coin_priv_sc got, double angle, double ulps)
{
    const double s = sin(angle), c = cos(angle);
    check_note("angle %a", angle);
    check_near(got.s, s, ulps * ulp(s));
    check_near(got.c, c, ulps * ulp(c));
}

TEST(both_are_within_one_ulp_up_to_4096)
{
    const int count = tries_asked(20000);
    struct random r = random_begin(306);
    for (int i = 0; i < count; ++i) {
        const float x = (float)pow(2, random_between(&r, -30, 12));
        check_pair(coin_priv_sincos(x), x, 1);
        check_pair(coin_priv_sincos(-x), -x, 1);
    }
}

/* The floats about each multiple of pi/2, where one of the two is small: down
 * to 4e-9, which takes all parts of pi/2. */
TEST(both_are_within_one_ulp_near_multiples_of_half_pi)
{
    double least = 1;
    for (int n = 1; n * 1.5707963267948966 < 4096; ++n) {
        const float x = (float)(n * 1.5707963267948966);
        check_pair(coin_priv_sincos(x), x, 1);
        check_pair(coin_priv_sincos(nextafterf(x, 5000)), nextafterf(x, 5000),
                   1);
        check_pair(coin_priv_sincos(nextafterf(x, 0)), nextafterf(x, 0), 1);
        least = fmin(least, fmin(fabs(sin((double)x)), fabs(cos((double)x))));
    }
    check_within(least, 4e-9, 5e-9);
}

/* A remainder of a whole ulp, the most there is, next to pi/4, where 2^-24 is
 * an ulp of both.  Their last additions round by half of it.  What the sine
 * adds is at most 0.08, with five roundings of a part of 2^-24: another 0.4
 * ulp.  The cosine adds the rounding of z/2, 0.25 ulp, and 0.03 with three of
 * its own. */
TEST(a_remainder_is_added_as_exactly)
{
    const int count = tries_asked(20000);
    struct random r = random_begin(307);
    for (int i = 0; i < count; ++i) {
        const float x = (float)random_between(&r, 0.5236, 0.7853);
        const float y = (float)(i % 2 ? ulp(x) : -ulp(x));
        check_pair(coin_priv_sine_cosine_reduced(x, y), (double)x + y, 0.9);
    }
}
