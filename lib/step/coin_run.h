/* SPDX-License-Identifier: MIT */
/* A run by any method. */
#ifndef ROLLCOIN_COIN_RUN_H
#define ROLLCOIN_COIN_RUN_H

#include "rk4.h"
#include "rk8.h"
#include "symplectic.h"

#define COIN_PRIV_CASE(method, name, coarse, refusal)                          \
    case method:                                                               \
        coin_priv_##name(r, n);                                                \
        break;

/* Up to n steps of dt; returns how many were done.  If dt is 0, all count. */
COIN_PRIV_INLINE uint64_t coin_priv_run_on(coin_priv_run *r, int32_t method,
                                           uint64_t n)
{
    const uint64_t before = r->steps;
    if (r->dt == 0 || n == 0)
        return n;
    switch (method) { /* one of them: GCOVR_EXCL_BR_LINE */
        COIN_PRIV_METHODS(COIN_PRIV_CASE)
    }
    return r->steps - before;
}

/* Completes a run of `steps` steps and returns its status.  *s becomes the
 * state at the end and, if done is not null, *done the number of steps done.
 * If a rate has left its range, *s is left as it was and no step counts as
 * done. */
int32_t coin_priv_run_to_end(coin_priv_run *r, int32_t method, uint64_t steps,
                             coin_state *s, uint64_t *done);

#endif
