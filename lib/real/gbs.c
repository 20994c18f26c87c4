/* SPDX-License-Identifier: MIT */
#include "gbs.h"

#include <math.h>

enum { COLUMNS = COIN_PRIV_GBS_COLUMNS, MOST = COIN_PRIV_GBS_MOST };

/* The modified midpoint rule over h, with 2 k substeps. */
static void midpoints(real *to, const real *y, size_t n,
                      PRIV(right_hand_side) * slopes, const void *problem,
                      real h, int k)
{
    real before[MOST], d[MOST];
    const real step = h / (real)(2 * k);
    slopes(d, y, problem);
    for (size_t i = 0; i < n; ++i) {
        before[i] = y[i];
        to[i] = y[i] + step * d[i];
    }
    for (int j = 1; j < 2 * k; ++j) {
        slopes(d, to, problem);
        for (size_t i = 0; i < n; ++i) {
            const real next = before[i] + 2 * step * d[i];
            before[i] = to[i];
            to[i] = next;
        }
    }
}

real PRIV(gbs)(real *y, size_t n, PRIV(right_hand_side) * slopes,
               const void *problem, real h)
{
    real tableau[COLUMNS][MOST], error = 0;
    for (int k = 0; k < COLUMNS; ++k) {
        midpoints(tableau[k], y, n, slopes, problem, h, k + 1);
        for (int j = k - 1; j >= 0; --j) { /* Neville's scheme in 1/k^2 */
            const real ratio = (real)(k + 1) / (real)(j + 1);
            const real part = 1 / (ratio * ratio - 1);
            for (size_t i = 0; i < n; ++i)
                tableau[j][i] = tableau[j + 1][i] +
                                part * (tableau[j + 1][i] - tableau[j][i]);
        }
    }
    for (size_t i = 0; i < n; ++i) {
        const real size = 1 + FABS(tableau[0][i]);
        const real off = FABS(tableau[0][i] - tableau[1][i]) / size;
        error = islessequal(off, error) ? error : off; /* or NaN */
        y[i] = tableau[0][i];
    }
    return error;
}
