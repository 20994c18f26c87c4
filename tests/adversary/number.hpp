/* SPDX-License-Identifier: MIT */
/* The two numbers of the truth: long double (64 bits), quick, and __float128
 * (113 bits), by which every candidate is confirmed. */
#ifndef ROLLCOIN_ADVERSARY_NUMBER_HPP
#define ROLLCOIN_ADVERSARY_NUMBER_HPP

#include <cmath>
#include <limits>
#include <quadmath.h>

using quad = __float128;

#define OF_BOTH(name, function)                                                \
    inline long double name(long double x)                                     \
    {                                                                          \
        return function##l(x);                                                 \
    }                                                                          \
    inline quad name(quad x)                                                   \
    {                                                                          \
        return function##q(x);                                                 \
    }
OF_BOTH(sine, sin)
OF_BOTH(cosine, cos)
OF_BOTH(root, sqrt)
OF_BOTH(logarithm, log)
OF_BOTH(whole_part, trunc)
OF_BOTH(magnitude, fabs)

inline double magnitude(double x)
{
    return std::fabs(x);
}
inline long double angle(long double y, long double x)
{
    return atan2l(y, x);
}
inline quad angle(quad y, quad x)
{
    return atan2q(y, x);
}

template <class R> R larger(R a, R b)
{
    return a < b ? b : a;
}
template <class R> R lesser(R a, R b)
{
    return b < a ? b : a;
}
template <class R> R whole_power(R x, int n)
{
    R y = 1;
    for (; n > 0; --n)
        y *= x;
    return y;
}

/* The unit of rounding, and pi/2. */
template <class R>
constexpr R precision = std::numeric_limits<R>::digits == 64
                            ? R(0x1p-64L)
                            : R(FLT128_EPSILON / 2);
template <class R> constexpr R half_pi = R(M_PI_2q);

/* A sum beside the sum of its terms' absolute values, which is what "8 u of
 * the terms" counts in. */
template <class R> struct terms {
    R value = 0, size = 0;

    terms() = default;
    terms(R only) : value(only), size(magnitude(only))
    {
    }
    terms(R whole, R of) : value(whole), size(of)
    {
    }
    terms &add(R term)
    {
        value += term;
        size += magnitude(term);
        return *this;
    }
    terms &add(const terms &t, R factor)
    {
        value += factor * t.value;
        size += magnitude(factor) * t.size;
        return *this;
    }
};

#endif
