/* SPDX-License-Identifier: MIT */
/* Prints the hash that lib/about/selftest.c has to pin: runs that very source,
 * with a print in the place of its verdict. */
#include <coin.h>

#include <inttypes.h>
#include <stdio.h>

static int32_t show(uint64_t hash)
{
    printf("0x%016" PRIx64 "\n", hash);
    return 0;
}

#define COIN_OK show(hash)
#define COIN_EBUILD show(hash)
#define coin_selftest shown_selftest
#include "../../lib/about/selftest.c"

int main(void)
{
    return coin_selftest();
}
