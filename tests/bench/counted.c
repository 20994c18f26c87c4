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

static int step(coin_priv_run *r, double tau)
{
    workprec_slopes += SLOPES;
    return coin_priv_extrapolate(r, tau);
}

static uint64_t landing(coin_priv_run *r, int32_t method, uint64_t n)
{
    workprec_slopes += (method == COIN_RK4 ? 4 : 12) * n;
    return coin_priv_run_by(r, method, n);
}

#define coin_priv_extrapolate step
#define coin_priv_run_by landing
#define coin_advance counted_advance
#include "../../lib/step/advance.c"
