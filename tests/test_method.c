/* SPDX-License-Identifier: MIT */
#include "support/check.h"

#include <string.h>

TEST(each_method_has_its_name)
{
    const struct {
        int32_t method;
        const char *name;
    } of[] = {
        {COIN_RK4, "rk4"},
        {COIN_RK8, "rk8"},
        {COIN_SYMPLECTIC2, "symplectic2"},
        {COIN_SYMPLECTIC4, "symplectic4"},
    };
    for (size_t i = 0; i < sizeof of / sizeof *of; ++i) {
        check_note("%s", of[i].name);
        check(strcmp(coin_method_name(of[i].method), of[i].name) == 0);
    }
}

TEST(other_numbers_are_no_methods)
{
    const int32_t absurd[] = {-1, 4, 1000, INT32_MIN, INT32_MAX};
    for (size_t i = 0; i < sizeof absurd / sizeof *absurd; ++i) {
        check_note("method %d", (int)absurd[i]);
        check(coin_method_name(absurd[i]) == NULL);
    }
}
