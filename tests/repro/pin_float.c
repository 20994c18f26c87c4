/* SPDX-License-Identifier: MIT */
/* Prints the hash that lib/float/coinf_selftest.c has to pin, as pin.c does. */
#include <coinf.h>

#include <inttypes.h>
#include <stdio.h>

static int32_t show(uint64_t hash)
{
    printf("0x%016" PRIx64 "\n", hash);
    return 0;
}

#define COIN_OK show(hash)
#define COIN_EBUILD show(hash)
#define coinf_selftest shown_selftest
#include "../../lib/float/coinf_selftest.c"

int main(void)
{
    return coinf_selftest();
}
