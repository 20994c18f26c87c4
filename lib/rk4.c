/* SPDX-License-Identifier: MIT */
#include "pinned.h"

/* gcc would allocate registers loop by loop, and spill at the seams: 3 % of a
 * step; renamed, they let the processor start the next stage sooner: 2 %. */
#if defined(__GNUC__) && !defined(__clang__) && !defined(__TINYC__)
#pragma GCC optimize("ira-region=all", "rename-registers")
#endif

#include "march.h"
#include "rk4.h"

COIN_PRIV_INLINE double lean_step(coin_priv_moment *next,
                                  const coin_priv_moment *now, const void *k)
{
    return coin_priv_pathless(coin_priv_rk4_step, next, now, k);
}

static coin_priv_rk4_slopes coefficients(const coin_priv_body *b, double dt)
{
    const coin_priv_rk4_slopes k = {
        coin_priv_field_of(b, dt / 2),
        coin_priv_field_of(b, dt),
        coin_priv_field_of(b, dt / 6),
    };
    return k;
}

void coin_priv_rk4(coin_priv_carry *c, const coin_priv_body *b,
                   coin_priv_limits *limits, double dt, uint64_t n)
{
    const coin_priv_rk4_slopes k = coefficients(b, dt);
    coin_priv_march(c, b, limits, n, coin_priv_rk4_step, &k);
}

void coin_priv_rk4_lean(coin_priv_carry *c, const coin_priv_body *b,
                        coin_priv_limits *limits, double dt, uint64_t n)
{
    const coin_priv_rk4_slopes k = coefficients(b, dt);
    coin_priv_march(c, b, limits, n, lean_step, &k);
}
