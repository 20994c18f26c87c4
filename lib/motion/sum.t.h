/* SPDX-License-Identifier: MIT */
/* Sums that keep what rounding leaves out. */
#include "kind.h"

/* A sum and what its rounding left out. */
typedef struct coin_priv_sum {
    number sum, low;
} coin_priv_sum;

/* Adds a part, by Knuth's exact sum. */
COIN_PRIV_INLINE_UNLESS_SMALL void coin_priv_add(coin_priv_sum *to, number part)
{
    const number y = part + to->low, sum = to->sum + y;
    const number of_y = sum - to->sum;
    to->low = (to->sum - (sum - of_y)) + (y - of_y);
    to->sum = sum;
}

/* A sum with a part that is not in it yet. */
COIN_PRIV_INLINE number coin_priv_total(coin_priv_sum so_far, number part)
{
    coin_priv_add(&so_far, part);
    return so_far.sum;
}
