/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#define FIELD coin_priv_motion
#define DRIFT coin_priv_drift
#define EACH_POSE(F) F(phi) F(psi) F(x) F(z)
#include "dop8.h"
#include "march.h"

COIN_PRIV_INLINE double lean_step(coin_priv_moment *next,
                                  const coin_priv_moment *now, const void *f)
{
    return coin_priv_pathless(dop8_step, next, now, f);
}

void coin_priv_rk8(coin_priv_carry *c, const coin_priv_body *b,
                   coin_priv_limits *limits, double dt, uint64_t n)
{
    const coin_priv_field f = coin_priv_field_of(b, dt);
    coin_priv_march(c, b, limits, n, dop8_step, &f);
}

void coin_priv_rk8_lean(coin_priv_carry *c, const coin_priv_body *b,
                        coin_priv_limits *limits, double dt, uint64_t n)
{
    const coin_priv_field f = coin_priv_field_of(b, dt);
    coin_priv_march(c, b, limits, n, lean_step, &f);
}
