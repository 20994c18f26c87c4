/* SPDX-License-Identifier: MIT */
/* The size of every public struct.  Bindings of other languages compare their
 * own structs with it. */
#include "../motion/pinned.h"

#include <coin.h>
#include <coinf.h>

uint32_t coin_sizeof_params(void)
{
    return (uint32_t)sizeof(coin_params);
}

uint32_t coin_sizeof_state(void)
{
    return (uint32_t)sizeof(coin_state);
}

uint32_t coin_sizeof_force(void)
{
    return (uint32_t)sizeof(coin_force);
}

uint32_t coin_sizeof_losses(void)
{
    return (uint32_t)sizeof(coin_losses);
}

uint32_t coin_sizeof_friction(void)
{
    return (uint32_t)sizeof(coin_friction);
}

uint32_t coin_sizeof_slide(void)
{
    return (uint32_t)sizeof(coin_slide);
}

uint32_t coin_sizeof_orbit(void)
{
    return (uint32_t)sizeof(coin_orbit);
}

uint32_t coinf_sizeof_params(void)
{
    return (uint32_t)sizeof(coinf_params);
}

uint32_t coinf_sizeof_state(void)
{
    return (uint32_t)sizeof(coinf_state);
}

uint32_t coinf_sizeof_force(void)
{
    return (uint32_t)sizeof(coinf_force);
}

uint32_t coinf_sizeof_losses(void)
{
    return (uint32_t)sizeof(coinf_losses);
}
