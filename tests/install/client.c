/* SPDX-License-Identifier: MIT */
/* A user's program, built through pkg-config against an installed library:
 *     client VERSION
 * where VERSION is what pkg-config says.  Header, library and package must be
 * of one version, the library must compute the pinned bits, and the integrals
 * need libm, so that a missing -lm shows when linking statically. */
#include <coinf.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

static int fail(const char *what)
{
    fprintf(stderr, "client: %s\n", what);
    return 1;
}

static int roll(void)
{
    coin_params p;
    coin_state s = {1.2, 0, 0, 0, 0, 0, 0.1, 1.5};
    double before[2], after[2];

    if (coin_params_disc(&p, 1, 1, 1) != COIN_OK ||
        coin_integrals(&s, &p, before) != COIN_OK ||
        coin_run(&s, &p, COIN_RK4, 0x1p-10, 1024, NULL) != COIN_OK ||
        coin_integrals(&s, &p, after) != COIN_OK)
        return fail("a call failed");
    /* 1024 steps of order 4 at dt = 2^-10: far below 1e-9 if all is well. */
    if (!(fabs(after[0] - before[0]) < 1e-9) ||
        !(fabs(after[1] - before[1]) < 1e-9))
        return fail("the integrals drift");
    return 0;
}

int main(int argc, char **argv)
{
    const uint32_t header = (uint32_t)COIN_VERSION_MAJOR << 16 |
                            (uint32_t)COIN_VERSION_MINOR << 8 |
                            (uint32_t)COIN_VERSION_PATCH;

    if (argc != 2 || strcmp(argv[1], coin_version_string()) != 0)
        return fail("pkg-config and library differ in version");
    if (coin_version() != header)
        return fail("header and library differ in version");
    if (coin_sizeof("coin_state") != sizeof(coin_state) ||
        coin_sizeof("coin_params") != sizeof(coin_params))
        return fail("header and library differ in layout");
    if (coin_selftest() != COIN_OK || coinf_selftest() != COIN_OK)
        return fail("the library does not compute the pinned bits");
    return roll();
}
