/* SPDX-License-Identifier: MIT */
/* A second copy of lib/step/advance.c and sundman.c, in which each right-hand
 * side counts. */
#include "counted.h"
#include "workprec.h"

#define coin_priv_sundman_tau counted_tau
#define coin_priv_sundman_accept counted_accept
#define coin_priv_sundman_step counted_step
#define coin_priv_read_lean counted_read_lean
#include <sundman.h>

static inline coin_priv_variables field(const coin_priv_field *f,
                                        const coin_priv_variables *y)
{
    ++workprec_slopes;
    return coin_priv_sundman_rates(f, y);
}

static void landing(coin_priv_run *r, uint64_t n)
{
    workprec_slopes += 4 * n;
    coin_priv_rk4(r, n);
}

#define coin_priv_sundman_rates field
#define coin_priv_rk4 landing
#define coin_advance counted_advance
#include "../../lib/step/sundman.c"

#include "../../lib/step/advance.c"
