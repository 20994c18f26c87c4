/* SPDX-License-Identifier: MIT */
/* Operations that C has for one number and not for a vector of them, and sums
 * that keep what rounding leaves out. */
#include "kind.h"
#include "precision.h"

/* A truth value is all ones or 0, as a comparison of vectors gives it. */
#if defined(COIN_PRIV_ABREAST) || defined(COIN_PRIV_PAIR)
COIN_PRIV_INLINE integer coin_priv_truth(integer comparison)
{
    return comparison;
}

COIN_PRIV_INLINE integer coin_priv_bits(number x)
{
    return (integer)x;
}

COIN_PRIV_INLINE number coin_priv_of_bits(integer bits)
{
    return (number)bits;
}

COIN_PRIV_INLINE number coin_priv_magnitude(number x)
{
    return coin_priv_of_bits(coin_priv_bits(x) & COIN_PRIV_ALL_BUT_SIGN);
}

/* Whether a comparison holds for each number. */
COIN_PRIV_INLINE int coin_priv_every(integer comparison)
{
    int64_t of_all = -1;
    for (size_t i = 0; i < sizeof comparison / sizeof of_all; ++i)
        of_all &= comparison[i];
    return of_all == -1;
}

#else
COIN_PRIV_INLINE integer coin_priv_truth(int comparison)
{
    return -(integer)comparison;
}

COIN_PRIV_INLINE integer coin_priv_bits(number x)
{
    union {
        number value;
        integer bits;
    } word;
    word.value = x;
    return word.bits;
}

COIN_PRIV_INLINE number coin_priv_of_bits(integer bits)
{
    union {
        number value;
        integer bits;
    } word;
    word.bits = bits;
    return word.value;
}

COIN_PRIV_INLINE number coin_priv_magnitude(number x)
{
    return FABS(x);
}

COIN_PRIV_INLINE int coin_priv_every(int comparison)
{
    return comparison;
}
#endif

/* a where mask is all ones, b where it is 0. */
COIN_PRIV_INLINE number coin_priv_choose(integer mask, number a, number b)
{
    return coin_priv_of_bits((mask & coin_priv_bits(a)) |
                             (~mask & coin_priv_bits(b)));
}

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
