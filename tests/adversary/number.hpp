/* SPDX-License-Identifier: MIT */
/* The two numbers of the truth: long double (64 bits), quick, and __float128
 * (113 bits), by which every candidate is confirmed. */
#ifndef ROLLCOIN_ADVERSARY_NUMBER_HPP
#define ROLLCOIN_ADVERSARY_NUMBER_HPP

#include <cmath>
#include <limits>
#include <quadmath.h>

using quad = __float128;

inline long double sine(long double x)
{
    return std::sin(x);
}
inline long double cosine(long double x)
{
    return std::cos(x);
}
inline long double root(long double x)
{
    return std::sqrt(x);
}
inline long double logarithm(long double x)
{
    return std::log(x);
}
inline long double exponential(long double x)
{
    return std::exp(x);
}
inline long double angle(long double y, long double x)
{
    return std::atan2(y, x);
}
inline quad sine(quad x)
{
    return sinq(x);
}
inline quad cosine(quad x)
{
    return cosq(x);
}
inline quad root(quad x)
{
    return sqrtq(x);
}
inline quad logarithm(quad x)
{
    return logq(x);
}
inline quad exponential(quad x)
{
    return expq(x);
}
inline quad angle(quad y, quad x)
{
    return atan2q(y, x);
}
inline long double whole_part(long double x)
{
    return std::trunc(x);
}
inline quad whole_part(quad x)
{
    return truncq(x);
}

template <class R> R magnitude(R x)
{
    return x < 0 ? -x : x;
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
template <class R> R precision();
template <> inline long double precision<long double>()
{
    return 0x1p-64L;
}
template <> inline quad precision<quad>()
{
    return FLT128_EPSILON / 2;
}
template <class R> R half_pi();
template <> inline long double half_pi<long double>()
{
    return 1.570796326794896619231321691639751442L;
}
template <> inline quad half_pi<quad>()
{
    return M_PI_2q;
}

/* A sum beside the sum of its terms' absolute values, which is what "8 u of
 * the terms" counts in. */
template <class R> struct terms {
    R value = 0, size = 0;
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
