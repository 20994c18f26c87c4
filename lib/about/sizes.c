/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include <coin.h>
#include <coinf.h>

#define SIZE(type)                                                             \
    {                                                                          \
#type, (uint32_t)sizeof(type)                                          \
    }
static int is_equal(const char *a, const char *b)
{
    while (*a && *a == *b) {
        ++a;
        ++b;
    }
    return *a == *b;
}

uint32_t coin_sizeof(const char *type)
{
    /* No pointers in the table, as in motion/methods.c. */
    static const struct {
        char type[16];
        uint32_t size;
    } sizes[] = {
        SIZE(coin_params), SIZE(coin_state),   SIZE(coin_force),
        SIZE(coin_losses), SIZE(coin_table),   SIZE(coin_body),
        SIZE(coin_orbit),  SIZE(coinf_params), SIZE(coinf_state),
        SIZE(coinf_force),
    };
    for (size_t i = 0; type && i < sizeof sizes / sizeof *sizes; ++i)
        if (is_equal(type, sizes[i].type))
            return sizes[i].size;
    return 0;
}
