/* SPDX-License-Identifier: MIT */
/* A second copy of lib/advance.c, in which each right-hand side counts. */
#include "counted.h"
#include "workprec.h"

#include <motion.h>
#include <stepper.h>

static inline coin_priv_stage field(const coin_priv_field *f,
                                    const coin_priv_stage *y)
{
    ++workprec_slopes;
    return coin_priv_sundman(f, y);
}

static void landing(coin_priv_carry *c, const coin_priv_body *b,
                    coin_priv_limits *limits, double dt, uint64_t n)
{
    workprec_slopes += 4 * n;
    coin_priv_rk4(c, b, limits, dt, n);
}

#define coin_priv_sundman field
#define coin_priv_rk4 landing
#define coin_priv_sundman_tau counted_tau
#define coin_priv_sundman_step counted_step
#define coin_advance counted_advance
#include "../../lib/advance.c"
