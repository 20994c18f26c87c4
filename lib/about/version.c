/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include <coin.h>

#define TEXT(x) #x
#define VERSION(major, minor, patch) TEXT(major) "." TEXT(minor) "." TEXT(patch)

uint32_t coin_version(void)
{
    return (uint32_t)COIN_VERSION_MAJOR << 16 |
           (uint32_t)COIN_VERSION_MINOR << 8 | (uint32_t)COIN_VERSION_PATCH;
}

const char *coin_version_string(void)
{
    return VERSION(COIN_VERSION_MAJOR, COIN_VERSION_MINOR, COIN_VERSION_PATCH);
}
