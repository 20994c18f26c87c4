/* SPDX-License-Identifier: MIT */
#include "support/check.h"

#include <coinf.h>

TEST(the_sizes_are_those_of_the_headers)
{
    const struct {
        const char *type;
        size_t stated, compiled;
    } of[] = {
        {"coin_params", 64, sizeof(coin_params)},
        {"coin_state", 64, sizeof(coin_state)},
        {"coin_force", 48, sizeof(coin_force)},
        {"coin_losses", 96, sizeof(coin_losses)},
        {"coin_table", 160, sizeof(coin_table)},
        {"coin_body", 128, sizeof(coin_body)},
        {"coin_orbit", 32768, sizeof(coin_orbit)},
        {"coinf_params", 32, sizeof(coinf_params)},
        {"coinf_state", 64, sizeof(coinf_state)},
        {"coinf_force", 24, sizeof(coinf_force)},
    };
    for (size_t i = 0; i < sizeof of / sizeof *of; ++i) {
        check_note("%s", of[i].type);
        check(coin_sizeof(of[i].type) == of[i].stated);
        check(of[i].compiled == of[i].stated);
    }
}

TEST(what_is_no_type_has_no_size)
{
    check(coin_sizeof(NULL) == 0);
    check(coin_sizeof("") == 0);
    check(coin_sizeof("coin_stat") == 0);
    check(coin_sizeof("coin_states") == 0);
    check(coin_sizeof("COIN_STATE") == 0);
}
