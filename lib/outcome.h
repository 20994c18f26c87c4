/* SPDX-License-Identifier: MIT */
/* What became of a batch: the first coin that failed, and all warnings. */
#ifndef ROLLCOIN_OUTCOME_H
#define ROLLCOIN_OUTCOME_H

#include <coin.h>

typedef struct coin_priv_outcome {
    size_t first;
    int32_t error, warnings;
} coin_priv_outcome;

static inline void coin_priv_note(coin_priv_outcome *o, int32_t *status,
                                  size_t index, int32_t code)
{
    if (status)
        status[index] = code;
    if (code > 0)
        o->warnings |= code;
    if (code < 0 && (o->error == COIN_OK || index < o->first)) {
        o->error = code;
        o->first = index;
    }
}

#endif
