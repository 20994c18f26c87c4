/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/kind.h"

#define LANES COIN_PRIV_LANES
#include "../motion/vector.t.h"

#include "dopri8.h"

#define ERROR_TO
#include "../step/tableau.t.h"

#include <math.h>

/* The variables are computed side by side, as many as a vector holds; any
 * number of lanes gives the same bits.  Stages compute those that are read, and
 * some of the others where a vector is not full. */
enum {
    SIZE = COIN_PRIV_DOPRI8_SIZE,
    WIDE = 16,
    READ = (COIN_PRIV_DOPRI8_READ + LANES - 1) / LANES * LANES,
    SLOPES = 10
};

/* A step under way: its start, and the slopes that rows to come read. */
struct stages {
    double h;
    double y[WIDE], d[SLOPES][WIDE];
};

/* A row of the tableau times `count` slopes from number `first` on, for the
 * variables from number i on. */
COIN_PRIV_INLINE lanes sum_row(const struct stages *s, const double *row,
                               int first, int count, int i)
{
    lanes sum = {0};
#pragma GCC unroll 10
    for (int k = 0; k < count; ++k)
        sum = sum + row[k] * load(&s->d[first + k][i]);
    return sum;
}

/* h times a row that begins with stage 1 and goes on with stages 6 to 12. */
COIN_PRIV_INLINE void sum_end(double *to, const struct stages *s,
                              const double *row, int width)
{
    for (int i = 0; i < width; i += LANES)
        store(to + i, s->h * (row[0] * load(&s->d[0][i])) +
                          s->h * sum_row(s, row + 1, 3, 7, i));
}

/* A stage: the slopes, number `to`, where a row of `count` leads. */
COIN_PRIV_INLINE void stage(struct stages *s, coin_priv_right_hand_side *slopes,
                            const void *problem, const double *row, int count,
                            int to)
{
    double at[WIDE];
    for (int i = 0; i < READ; i += LANES)
        store(at + i, load(&s->y[i]) + s->h * sum_row(s, row, 0, count, i));
    slopes(s->d[to], at, problem);
}

/* Stages 2 to 12.  Their slopes lie as the rows list them: those of stages 2
 * and 3 are overwritten as soon as no row reads them. */
static void all_stages(struct stages *s, coin_priv_right_hand_side *f,
                       const void *of)
{
    stage(s, f, of, A2, 1, 1);
    stage(s, f, of, A3, 2, 1);
    stage(s, f, of, A4, 2, 2);
    stage(s, f, of, A5, 3, 3);
    for (int i = 0; i < READ; ++i) {
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

void coin_priv_dopri8(double *y, const double *d,
                      coin_priv_right_hand_side *slopes, const void *problem,
                      double h, coin_priv_estimates *error)
{
    struct stages s;
    double end[WIDE], by5[READ];
    s.h = h;
    for (int i = 0; i < SIZE; ++i) {
        s.y[i] = y[i];
        s.d[0][i] = d[i];
    }
    for (int i = SIZE; i < WIDE; ++i) { /* nothing reads what they lead to */
        s.y[i] = 0;
        for (int k = 0; k < SLOPES; ++k)
            s.d[k][i] = 0;
    }
    all_stages(&s, slopes, problem);
    sum_end(end, &s, B, WIDE);
    sum_end(by5, &s, E5, READ);
    for (int i = 0; i < COIN_PRIV_DOPRI8_READ; ++i) {
        const double low = E3[0] * s.d[0][i] + E3[1] * s.d[6][i] +
                           E3[2] * s.d[9][i]; /* stages 1, 9 and 12 */
        error->by5[i] = by5[i];
        error->by3[i] = end[i] - h * low;
    }
    for (int i = 0; i < SIZE; ++i)
        y[i] += end[i];
}
