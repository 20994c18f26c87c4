/* SPDX-License-Identifier: MIT */
/* A second copy of lib/advance.c, in which each right-hand side counts. */
#include "counted.h"
#include "workprec.h"

#include <extrapolation.h>
#include <stepper.h>

/* Of a step of extrapolation: the first, which all columns share, and n - 1 of
 * each column of n substeps. */
enum { SLOPES = 1 + 15 + 11 + 9 + 7 + 5 + 3 + 1 };

static int step(coin_priv_carry *c, const coin_priv_body *b, double tau)
{
    workprec_slopes += SLOPES;
    return coin_priv_extrapolate(c, b, tau);
}

static void landing4(coin_priv_carry *c, const coin_priv_body *b,
                     coin_priv_limits *limits, double dt, uint64_t n)
{
    workprec_slopes += 4 * n;
    coin_priv_rk4(c, b, limits, dt, n);
}

static void landing8(coin_priv_carry *c, const coin_priv_body *b,
                     coin_priv_limits *limits, double dt, uint64_t n)
{
    workprec_slopes += 12 * n;
    coin_priv_rk8(c, b, limits, dt, n);
}

#define coin_priv_extrapolate step
#define coin_priv_rk4 landing4
#define coin_priv_rk8 landing8
#define coin_advance counted_advance
#include "../../lib/advance.c"
