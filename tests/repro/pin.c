/* SPDX-License-Identifier: MIT */
/* Prints the hash that lib/about/selftest.c has to pin, or with FLOATS that of
 * lib/float/coinf_selftest.c: runs that very source, with a print in the place
 * of its verdict. */
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
#define coin_selftest shown_selftest
#define coinf_selftest shown_selftest
#ifdef FLOATS
#include "../../lib/float/coinf_selftest.c"
#else
#include "../../lib/about/selftest.c"
#endif

int main(void)
{
    return shown_selftest();
}
