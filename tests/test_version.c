/* SPDX-License-Identifier: MIT */
#include "support/check.h"

#include <stdio.h>
#include <string.h>

TEST(the_number_is_that_of_the_header)
{
    const uint32_t v = coin_version();
    check(v >> 16 == COIN_VERSION_MAJOR);
    check((v >> 8 & 0xff) == COIN_VERSION_MINOR);
    check((v & 0xff) == COIN_VERSION_PATCH);
}

TEST(the_text_says_the_same)
{
    char want[32];
    snprintf(want, sizeof want, "%d.%d.%d", COIN_VERSION_MAJOR,
             COIN_VERSION_MINOR, COIN_VERSION_PATCH);
    check(strcmp(coin_version_string(), want) == 0);
}
