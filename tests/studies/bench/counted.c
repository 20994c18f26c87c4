/* SPDX-License-Identifier: MIT */
/* A second copy of lib/step/advance.c and sundman.c, in which each right-hand
 * side counts. */
#include "counted.h"
#include "workprec.h"

#include <extrapolation.h>
#include <sundman.h>

/* Of a step of extrapolation: the first, which all columns share, and n - 1 of
 * each column of n substeps. */
enum { SLOPES = 1 + 15 + 11 + 9 + 7 + 5 + 3 + 1 };

static int step(coin_priv_run *r, double tau, double *error)
{
    workprec_slopes += SLOPES;
    return coin_priv_extrapolate(r, tau, error);
}

static void landing4(coin_priv_run *r, uint64_t n)
{
    workprec_slopes += 4 * n;
    coin_priv_rk4(r, n);
}

static void landing8(coin_priv_run *r, uint64_t n)
{
    workprec_slopes += 12 * n;
    coin_priv_rk8(r, n);
}

#define coin_priv_extrapolate step
#define coin_priv_rk4 landing4
#define coin_priv_rk8 landing8
#define coin_advance counted_advance
#include "../../../lib/step/advance.c"
