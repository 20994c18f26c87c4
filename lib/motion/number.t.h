/* SPDX-License-Identifier: MIT */
/* Operations that C has for one number and not for a vector of them. */
#include "kind.h"
#include "precision.h"

/* A truth value is all ones or 0, as a comparison of vectors gives it. */
#if defined(COIN_PRIV_ABREAST) || defined(COIN_PRIV_PAIR)
COIN_PRIV_INLINE whole PRIV(truth)(whole comparison)
{
    return comparison;
}

COIN_PRIV_INLINE whole PRIV(bits)(real x)
{
    return (whole)x;
}

COIN_PRIV_INLINE real PRIV(of_bits)(whole bits)
{
    return (real)bits;
}

COIN_PRIV_INLINE real PRIV(magnitude)(real x)
{
    return PRIV(of_bits)(PRIV(bits)(x) & COIN_PRIV_ALL_BUT_SIGN);
}

/* Whether a comparison holds for each number. */
COIN_PRIV_INLINE int PRIV(every)(whole comparison)
{
    int64_t of_all = -1;
    for (size_t i = 0; i < sizeof comparison / sizeof of_all; ++i)
        of_all &= comparison[i];
    return of_all == -1;
}

#else
COIN_PRIV_INLINE whole PRIV(truth)(int comparison)
{
    return -(whole)comparison;
}

COIN_PRIV_INLINE whole PRIV(bits)(real x)
{
    union {
        real number;
        whole bits;
    } word;
    word.number = x;
    return word.bits;
}

COIN_PRIV_INLINE real PRIV(of_bits)(whole bits)
{
    union {
        real number;
        whole bits;
    } word;
    word.bits = bits;
    return word.number;
}

COIN_PRIV_INLINE real PRIV(magnitude)(real x)
{
    return FABS(x);
}

COIN_PRIV_INLINE int PRIV(every)(int comparison)
{
    return comparison;
}
#endif

/* a where mask is all ones, b where it is 0. */
COIN_PRIV_INLINE real PRIV(choose)(whole mask, real a, real b)
{
    return PRIV(of_bits)((mask & PRIV(bits)(a)) | (~mask & PRIV(bits)(b)));
}

/* The lesser of two, b where one is NaN. */
#if defined(COIN_PRIV_ABREAST) && defined(COIN_PRIV_LESSER)
COIN_PRIV_INLINE real PRIV(lesser)(real a, real b)
{
    return COIN_PRIV_LESSER(a, b);
}
#elif defined(COIN_PRIV_ABREAST) || defined(COIN_PRIV_PAIR)
COIN_PRIV_INLINE real PRIV(lesser)(real a, real b)
{
    return PRIV(choose)(PRIV(truth)(a < b), a, b);
}
#else
COIN_PRIV_INLINE real PRIV(lesser)(real a, real b)
{
    return a < b ? a : b;
}
#endif
