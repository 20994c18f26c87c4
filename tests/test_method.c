/* SPDX-License-Identifier: MIT */
#include "support/check.h"

#include <string.h>

static void rk4_has_its_name_and_order(void **unused)
{
    (void)unused;
    check(strcmp(coin_method_name(COIN_RK4), "rk4") == 0);
    check(coin_method_order(COIN_RK4) == 4);
}

static void a_method_has_a_name_exactly_if_it_has_an_order(void **unused)
{
    (void)unused;
    for (int32_t method = -3; method < 40; ++method) {
        check_note("method %d", (int)method);
        if (coin_method_name(method))
            check_within(coin_method_order(method), 1, 99);
        else
            check_status(coin_method_order(method), COIN_EARG);
    }
}

static void absurd_numbers_are_no_methods(void **unused)
{
    (void)unused;
    const int32_t absurd[] = {-1, 4, 1000, INT32_MIN, INT32_MAX};
    for (size_t i = 0; i < sizeof absurd / sizeof *absurd; ++i) {
        check_note("method %d", (int)absurd[i]);
        check(coin_method_name(absurd[i]) == NULL);
        check_status(coin_method_order(absurd[i]), COIN_EARG);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(rk4_has_its_name_and_order),
        TEST(a_method_has_a_name_exactly_if_it_has_an_order),
        TEST(absurd_numbers_are_no_methods),
    };
    return RUN_TESTS(tests);
}
