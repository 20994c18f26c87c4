/* SPDX-License-Identifier: MIT */
/* A double that counts: every operation adds to operations, and every value
 * knows when it is ready at the earliest, were there no end of adders: the
 * length in ns of the longest chain of operations that it came from.  Forced
 * into the library's sources in place of double, which compile as C++ then. */
#ifndef ARITHMETIC_H
#define ARITHMETIC_H

#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <stddef.h>

struct counted;

/* How often, and how long each takes [ns]. */
struct arithmetic {
    unsigned long add, mul, div, root;
    double add_ns, mul_ns, div_ns, root_ns;
};
extern arithmetic operations;

struct counted {
    double value, ready;

    counted() = default;
    template <class T> counted(T v) : value((double)v), ready(0)
    {
    }
    counted(double v, double r) : value(v), ready(r)
    {
    }
    template <class T> explicit operator T() const
    {
        return (T)value;
    }
    counted operator-() const
    {
        return {-value, ready};
    }
};

static inline double later(counted a, counted b)
{
    return a.ready > b.ready ? a.ready : b.ready;
}

#define COUNTED(op, kind)                                                      \
    static inline counted operator op(counted a, counted b)                    \
    {                                                                          \
        ++operations.kind;                                                     \
        return {a.value op b.value, later(a, b) + operations.kind##_ns};       \
    }                                                                          \
    static inline counted &operator op##=(counted &a, counted b)               \
    {                                                                          \
        return a = a op b;                                                     \
    }
COUNTED(+, add)
COUNTED(-, add)
COUNTED(*, mul)
COUNTED(/, div)
#undef COUNTED

static inline counted &operator++(counted &a)
{
    return a += 1;
}

#define COMPARED(op)                                                           \
    static inline bool operator op(counted a, counted b)                       \
    {                                                                          \
        return a.value op b.value;                                             \
    }
COMPARED(<)
COMPARED(>)
COMPARED(<=)
COMPARED(>=)
COMPARED(==)
COMPARED(!=)
#undef COMPARED

static inline counted sqrt(counted a)
{
    ++operations.root;
    return {std::sqrt(a.value), a.ready + operations.root_ns};
}

static inline counted fabs(counted a)
{
    return {std::fabs(a.value), a.ready};
}

static inline counted log(counted a)
{
    return {std::log(a.value), a.ready};
}

#define double counted

/* No vectors of them. */
#undef __SSE2__

#endif
