/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_LANES_H
#define ROLLCOIN_LANES_H

#include "run.h"

/* A batch of coins, and what became of it so far: the first error, and all
 * warnings. */
typedef struct coin_priv_batch {
    coin_state *s;
    size_t count;
    int32_t *status; /* null if the caller does not want it */
    int32_t error, warnings;
} coin_priv_batch;

/* Notes the status of coin i; the coins come in their order. */
COIN_PRIV_INLINE void coin_priv_note(coin_priv_batch *r, size_t i,
                                     int32_t status)
{
    if (r->status)
        r->status[i] = status;
    if (status > 0)
        r->warnings |= status;
    else if (r->error == COIN_OK)
        r->error = status;
}

/* A run of all coins of a batch, one in each lane of the processor's vectors.
 * Each gets the bits and the status that coin_run() would give it.  *b are
 * their constants; dt is finite and, as steps, not 0.  Returns 0, and does
 * nothing, if the method has no lanes or the processor no vectors. */
int coin_priv_run_abreast(coin_priv_batch *batch, const coin_priv_constants *b,
                          int32_t method, double dt, uint64_t steps);

#endif
