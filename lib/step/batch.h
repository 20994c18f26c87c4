/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_BATCH_H
#define ROLLCOIN_BATCH_H

#include "../motion/state.h"

/* What became of a batch: the first coin that failed, and all warnings. */
typedef struct PRIV(batch_result) {
    size_t first;
    int32_t error, warnings;
} PRIV(batch_result);

static inline void PRIV(note)(PRIV(batch_result) * r, int32_t *status,
                              size_t index, int32_t code)
{
    if (status)
        status[index] = code;
    if (code > 0)
        r->warnings |= code;
    if (code < 0 && (r->error == COIN_OK || index < r->first)) {
        r->error = code;
        r->first = index;
    }
}

#endif
