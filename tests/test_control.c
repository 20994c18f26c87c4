/* SPDX-License-Identifier: MIT */
/* How the length of the next step follows from the estimate of the error of
 * this one. */
#include "support/check.h"

#include "control.h"

#include <math.h>

/* Whatever its length was: a step that was cut short by an event or by the end
 * of a call, too. */
static void a_refused_step_is_followed_by_a_shorter_one(void **unused)
{
    (void)unused;
    for (double used = 1; used > 1e-6; used /= 10)
        for (double error = 1.1; error < 1e30; error *= 10) {
            const double next = coin_priv_next_stride(1, used, error, 1);
            check_within(next, 0.2 * used, 0.9 * used);
        }
    check_near(coin_priv_next_stride(1, 1, (double)INFINITY, 1), 0.2, 1e-3);
}

static void a_step_that_was_cut_short_does_not_lessen_the_stride(void **unused)
{
    (void)unused;
    for (double used = 0.4; used > 1e-12; used /= 10) {
        check(coin_priv_next_stride(1, used, 0, 1) == 1);
        check(coin_priv_next_stride(1, used, 1, 1) == 1);
    }
}

/* The error is of the 8th order: to grow by f it may be 1/f^8 of the most. */
static void an_accepted_step_is_followed_by_as_long_a_one_as_its_error_allows(
    void **unused)
{
    (void)unused;
    for (double f = 0.9; f < 1.9; f += 0.1) {
        const double error = pow((f - 0.2) / 0.7, -8);
        if (error <= 1)
            check_near(coin_priv_next_stride(0.1, 0.1, error, 1), f * 0.1,
                       1e-12);
    }
    check(coin_priv_next_stride(0.1, 0.1, 0, 1) == 0.2);
    check_near(coin_priv_next_stride(0.1, 0.1, 1, 1), 0.09, 1e-12);
    check(coin_priv_next_stride(1, 1, 0, 1) == COIN_PRIV_LONGEST_STRIDE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_refused_step_is_followed_by_a_shorter_one),
        TEST(a_step_that_was_cut_short_does_not_lessen_the_stride),
        TEST(an_accepted_step_is_followed_by_as_long_a_one_as_its_error_allows),
    };
    return RUN_TESTS(tests);
}
