/* SPDX-License-Identifier: MIT */
/* Steps to the precision of R: the modified midpoint rule, extrapolated (Gragg,
 * Bulirsch, Stoer). */
#ifndef ROLLCOIN_ADVERSARY_MIDPOINT_HPP
#define ROLLCOIN_ADVERSARY_MIDPOINT_HPP

#include "number.hpp"

#include <array>

/* The change in H by n substeps; rates(v, d) is the slope where the variables
 * have changed by v, d0 that where they have not. */
template <class R, size_t N, class F>
void by_midpoints(const F &rates, const std::array<R, N> &d0, R H, int n,
                  std::array<R, N> &out)
{
    const R h = H / n;
    std::array<R, N> last = {}, d;
    for (size_t i = 0; i < N; ++i)
        out[i] = h * d0[i];
    for (int k = 1; k < n; ++k) {
        rates(out, d);
        for (size_t i = 0; i < N; ++i) {
            const R next = last[i] + 2 * h * d[i];
            last[i] = out[i];
            out[i] = next;
        }
    }
}

/* A correction that is none, in parts of a variable's size. */
template <class R>
constexpr double NONE = std::numeric_limits<R>::digits == 64 ? 0x1p-54 : 1e-26;

/* The change in H, until a correction is at most `none` parts of sizes; false
 * if that takes more columns. */
template <class R, size_t N, class F>
bool extrapolated(const F &rates, const std::array<R, N> &sizes, R H,
                  std::array<R, N> &change, double none = NONE<R>)
{
    constexpr int COLUMNS = 11;
    std::array<R, N> table[COLUMNS], d0;
    rates(std::array<R, N>(), d0);
    for (int k = 0; k < COLUMNS; ++k) {
        by_midpoints<R, N>(rates, d0, H, 2 * k + 2, table[k]);
        R error = 0;
        for (int j = k - 1; j >= 0; --j) {
            const R ratio = R(k + 1) / (j + 1), f = 1 / (ratio * ratio - 1);
            for (size_t i = 0; i < N; ++i) {
                const R off = (table[j + 1][i] - table[j][i]) * f;
                table[j][i] = table[j + 1][i] + off;
                if (j == 0)
                    error = larger(error, magnitude(off) / sizes[i]);
            }
        }
        if (!(error < 1)) /* also NaN */
            return false;
        if (k >= 2 && error < R(none)) {
            change = table[0];
            return true;
        }
    }
    return false;
}

#endif
