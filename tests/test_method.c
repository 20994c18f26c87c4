/* SPDX-License-Identifier: MIT */
#include "support/check.h"

#include <string.h>

static void each_method_has_its_name_and_order(void **unused)
{
    (void)unused;
    const struct {
        int32_t method, order;
        const char *name;
    } of[] = {
        {COIN_RK4, 4, "rk4"},
        {COIN_RK8, 8, "rk8"},
        {COIN_SYMPLECTIC2, 2, "symplectic2"},
        {COIN_SYMPLECTIC4, 4, "symplectic4"},
    };
    for (size_t i = 0; i < sizeof of / sizeof *of; ++i) {
        check_note("%s", of[i].name);
        check(strcmp(coin_method_name(of[i].method), of[i].name) == 0);
        check(coin_method_order(of[i].method) == of[i].order);
    }
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
        TEST(each_method_has_its_name_and_order),
        TEST(a_method_has_a_name_exactly_if_it_has_an_order),
        TEST(absurd_numbers_are_no_methods),
    };
    return RUN_TESTS(tests);
}
