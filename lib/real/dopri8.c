/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/kind.h"

#include "dopri8.h"

#define ERROR_TO
#include "../step/tableau.t.h"

#include <math.h>

enum { MOST = COIN_PRIV_DOPRI8_MOST, SLOPES = 10 };

/* A step under way: its start, and the slopes that rows to come read. */
struct stages {
    const double *y;
    size_t n;
    double h;
    double d[SLOPES][MOST];
};

/* h times a row of the tableau times the slopes number `first` and on. */
static void add_row(double *to, const struct stages *s, const double *row,
                    int first, int count)
{
    for (size_t i = 0; i < s->n; ++i) {
        double sum = 0;
        for (int k = 0; k < count; ++k)
            sum += row[k] * s->d[first + k][i];
        to[i] += s->h * sum;
    }
}

/* A stage: the slopes, number `to`, where a row of `count` leads. */
static void stage(struct stages *s, coin_priv_gbs_slopes *slopes,
                  const void *problem, const double *row, int count, int to)
{
    double at[MOST];
    for (size_t i = 0; i < s->n; ++i)
        at[i] = s->y[i];
    add_row(at, s, row, 0, count);
    slopes(s->d[to], at, problem);
}

/* Stages 2 to 12.  Their slopes lie as the rows list them: those of stages 2
 * and 3 are overwritten as soon as no row reads them. */
static void all_stages(struct stages *s, coin_priv_gbs_slopes *f,
                       const void *of)
{
    stage(s, f, of, A2, 1, 1);
    stage(s, f, of, A3, 2, 1);
    stage(s, f, of, A4, 2, 2);
    stage(s, f, of, A5, 3, 3);
    for (size_t i = 0; i < s->n; ++i) {
        s->d[1][i] = s->d[2][i];
        s->d[2][i] = s->d[3][i];
    }
    stage(s, f, of, A6, 3, 3);
    stage(s, f, of, A7, 4, 4);
    stage(s, f, of, A8, 5, 5);
    stage(s, f, of, A9, 6, 6);
    stage(s, f, of, A10, 7, 7);
    stage(s, f, of, A11, 8, 8);
    stage(s, f, of, A12, 9, 9);
}

void coin_priv_dopri8(double *y, const double *d, size_t n,
                      coin_priv_gbs_slopes *slopes, const void *problem,
                      double h, coin_priv_estimates *error)
{
    struct stages s;
    double end[MOST];
    s.y = y;
    s.n = n;
    s.h = h;
    for (size_t i = 0; i < n; ++i) {
        s.d[0][i] = d[i];
        end[i] = error->by5[i] = error->by3[i] = 0;
    }
    all_stages(&s, slopes, problem);
    add_row(end, &s, B, 0, 1); /* b_1; then b_6 to b_12 */
    add_row(end, &s, B + 1, 3, 7);
    add_row(error->by5, &s, E5, 0, 1);
    add_row(error->by5, &s, E5 + 1, 3, 7);
    for (size_t i = 0; i < n; ++i) {
        const double low = E3[0] * s.d[0][i] + E3[1] * s.d[6][i] +
                           E3[2] * s.d[9][i]; /* stages 1, 9 and 12 */
        error->by3[i] = end[i] - h * low;
        y[i] += end[i];
    }
}
