/* SPDX-License-Identifier: MIT */
#include "support/check.h"

#include <coinf.h>

/* Each is stated in the header, and what the compiler makes of it. */
static void the_sizes_are_those_of_the_headers(void **unused)
{
    (void)unused;
    check(coin_sizeof_params() == 64 && sizeof(coin_params) == 64);
    check(coin_sizeof_state() == 64 && sizeof(coin_state) == 64);
    check(coin_sizeof_force() == 48 && sizeof(coin_force) == 48);
    check(coin_sizeof_losses() == 64 && sizeof(coin_losses) == 64);
    check(coin_sizeof_friction() == 16 && sizeof(coin_friction) == 16);
    check(coin_sizeof_slide() == 80 && sizeof(coin_slide) == 80);
    check(coin_sizeof_orbit() == 32768 && sizeof(coin_orbit) == 32768);
    check(coinf_sizeof_params() == 32 && sizeof(coinf_params) == 32);
    check(coinf_sizeof_state() == 64 && sizeof(coinf_state) == 64);
    check(coinf_sizeof_force() == 24 && sizeof(coinf_force) == 24);
    check(coinf_sizeof_losses() == 32 && sizeof(coinf_losses) == 32);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(the_sizes_are_those_of_the_headers),
    };
    return RUN_TESTS(tests);
}
