/* SPDX-License-Identifier: MIT */
/* Power series in time, made one order after the other: what a product, a
 * quotient and a root of series have at the next order.  The first orders are
 * long doubles.  The others are doubles: in a step they count for less than
 * 2^-9 of a sum, so that it is sharp to a long double's rounding. */
#ifndef ROLLCOIN_ADVERSARY_SERIES_HPP
#define ROLLCOIN_ADVERSARY_SERIES_HPP

#include "number.hpp"

#include <cstring>
#include <type_traits>

constexpr int ORDER = 28; /* the last */
constexpr int SHARP = 4;  /* orders below it are long doubles */

class series
{
  public:
    template <class T> T at(int n) const
    {
        if constexpr (std::is_same_v<T, double>)
            return n == 0 ? first : up[n];
        else
            return sharp[n];
    }

    template <class T> void set(int n, T value)
    {
        if constexpr (!std::is_same_v<T, double>)
            sharp[n] = value;
        if (n == 0)
            first = double(value);
        else
            up[n] = down[ORDER - n] = double(value);
    }

    /* The sum of a_k b_(n-k) without the first and the last.  The doubles are
     * summed in four parts; what is read beyond n meets a zero. */
    template <class T> static T between(const series &a, const series &b, int n)
    {
        if constexpr (std::is_same_v<T, double>) {
            pair s = {}, t = {};
            const double *const back = b.down + (ORDER - n);
            for (int k = 1; k < n; k += 4) {
                s += load(a.up + k) * load(back + k);
                t += load(a.up + k + 2) * load(back + k + 2);
            }
            s += t;
            return s[0] + s[1];
        } else {
            T sum = 0;
            for (int k = 1; k < n; ++k)
                sum += a.sharp[k] * b.sharp[n - k];
            return sum;
        }
    }

    /* Of a b. */
    template <class T> static T product(const series &a, const series &b, int n)
    {
        const T ends = a.at<T>(0) * b.at<T>(n);
        return n == 0 ? ends
                      : ends + a.at<T>(n) * b.at<T>(0) + between<T>(a, b, n);
    }

    /* Of this as the quotient of what has `a` there by b: to be set in order.
     */
    template <class T> T quotient(T a, const series &b, int n) const
    {
        if (n == 0)
            return a / b.at<T>(0);
        return (a - b.at<T>(n) * at<T>(0) - between<T>(b, *this, n)) /
               b.at<T>(0);
    }

    /* Of this as the root of what has `a` there: to be set in order. */
    template <class T> T root_of(T a, int n) const
    {
        if (n == 0)
            return std::sqrt(a);
        return (a - between<T>(*this, *this, n)) / (2 * at<T>(0));
    }

  private:
    typedef double pair __attribute__((vector_size(16)));

    long double sharp[SHARP + 1] = {};
    double first = 0;
    double up[ORDER + 4] = {};   /* from 1 on; 0 at 0 */
    double down[ORDER + 4] = {}; /* from ORDER - 1 down; then 0 */

    static pair load(const double *from)
    {
        pair p;
        std::memcpy(&p, from, sizeof p);
        return p;
    }
};

/* What N variables change by: their series, to be summed anywhere in a step.
 * Time is in parts of `unit`. */
template <int N> class changes
{
  public:
    template <class T> void set(int i, int n, T value)
    {
        if (n < SHARP)
            first[n][i] = value;
        else
            rest[n - SHARP][i] = double(value);
    }

    /* How far the series goes, in units: until its last two terms are `none`
     * parts of the sizes; at most `most`. */
    double reach(const double *sizes, double none, double most) const
    {
        double far = most;
        for (int n = ORDER - 1; n <= ORDER; ++n) {
            double large = 0;
            for (int i = 0; i < N; ++i)
                large = larger(large, std::fabs(rest[n - SHARP][i]) / sizes[i]);
            if (!(large <= 1e300))
                return 0;
            if (large * std::pow(far, n) > none)
                far = std::pow(none / large, 1.0 / n);
        }
        return far;
    }

    template <class V> void sum(long double t, V &out) const
    {
        const double by = double(t);
        double tail[N];
        for (int i = 0; i < N; ++i)
            tail[i] = rest[ORDER - SHARP][i];
        for (int n = ORDER - SHARP - 1; n >= 0; --n)
            for (int i = 0; i < N; ++i)
                tail[i] = tail[i] * by + rest[n][i];
        for (int i = 0; i < N; ++i) {
            long double head = tail[i];
            for (int n = SHARP - 1; n > 0; --n)
                head = head * t + first[n][i];
            out[i] = head * t;
        }
    }

  private:
    long double first[SHARP][N];
    double rest[ORDER - SHARP + 1][N];
};

#endif
