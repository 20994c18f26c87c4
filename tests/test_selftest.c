/* SPDX-License-Identifier: MIT */
#include "support/check.h"

#include <coinf.h>

#include <fenv.h>

TEST(this_build_gives_the_pinned_bits)
{
    check_status(coin_selftest(), COIN_OK);
    check_status(coinf_selftest(), COIN_OK);
}

/* Whether the arithmetic follows fesetround(); valgrind's does not. */
static int rounds_otherwise(void)
{
    volatile double one = 1, little = 0x1p-60;
    return one + little != 1 || one - little != 1;
}

TEST(another_rounding_mode_does_not_give_the_pinned_bits)
{
    const int modes[] = {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    for (size_t i = 0; i < 3; ++i) {
        check(fesetround(modes[i]) == 0);
        const int32_t status = coin_selftest(), of_floats = coinf_selftest();
        const int mode = fegetround(), otherwise = rounds_otherwise();
        check(fesetround(FE_TONEAREST) == 0);
        check_note("rounding mode %d", modes[i]);
        check_status(status, otherwise ? COIN_EBUILD : COIN_OK);
        check_status(of_floats, otherwise ? COIN_EBUILD : COIN_OK);
        check(mode == modes[i]);
    }
    check_status(coin_selftest(), COIN_OK);
}
