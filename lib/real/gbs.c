/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "gbs.h"

#include <math.h>

enum { COLUMNS = 7, MOST = COIN_PRIV_GBS_MOST };

/* 2 k midpoint steps over h. */
static void midpoints(double *to, const double *y, size_t n,
                      coin_priv_slopes *slopes, const void *problem, double h,
                      int k)
{
    double before[MOST], d[MOST];
    const double step = h / (2 * k);
    slopes(d, y, problem);
    for (size_t i = 0; i < n; ++i) {
        before[i] = y[i];
        to[i] = y[i] + step * d[i];
    }
    for (int j = 1; j < 2 * k; ++j) {
        slopes(d, to, problem);
        for (size_t i = 0; i < n; ++i) {
            const double next = before[i] + 2 * step * d[i];
            before[i] = to[i];
            to[i] = next;
        }
    }
}

double coin_priv_gbs(double *y, size_t n, coin_priv_slopes *slopes,
                     const void *problem, double h)
{
    double table[COLUMNS][MOST], error = 0;
    for (int k = 0; k < COLUMNS; ++k) {
        midpoints(table[k], y, n, slopes, problem, h, k + 1);
        for (int j = k - 1; j >= 0; --j) { /* Aitken and Neville, in 1/k^2 */
            const double ratio = (double)(k + 1) / (j + 1);
            const double part = 1 / (ratio * ratio - 1);
            for (size_t i = 0; i < n; ++i)
                table[j][i] =
                    table[j + 1][i] + part * (table[j + 1][i] - table[j][i]);
        }
    }
    for (size_t i = 0; i < n; ++i) {
        const double size = 1 + fabs(table[0][i]);
        const double off = fabs(table[0][i] - table[1][i]) / size;
        error = islessequal(off, error) ? error : off; /* NaN is one too */
        y[i] = table[0][i];
    }
    return error;
}
