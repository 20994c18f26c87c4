/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/kind.h"

#define LANES COIN_PRIV_LANES
#include "../motion/vector.t.h"

#include "dop853.h"

#define ERROR_TO
#include "../step/tableau.t.h"

#include <string.h>

/* Variables are computed side by side, as many as a vector holds; any number of
 * lanes gives the same bits.  Stages compute those that are read.  The numbers
 * are those of vectors. */
enum {
    READ = (COIN_PRIV_READ + LANES - 1) / LANES,
    ALL = (COIN_PRIV_SIZE + LANES - 1) / LANES
};

/* The stages of the polynomial, without their zeros. */
/* clang-format off */
static const double A14[] = {
    5.61675022830479523392909219681e-2,
    2.53500210216624811088794765333e-1,
    -2.46239037470802489917441475441e-1,
    -1.24191423263816360469010140626e-1,
    1.5329179827876569731206322685e-1,
    8.20105229563468988491666602057e-3,
    7.56789766054569976138603589584e-3,
    -8.298e-3,
};
static const double A15[] = {
    3.18346481635021405060768473261e-2,
    2.83009096723667755288322961402e-2,
    5.35419883074385676223797384372e-2,
    -5.49237485713909884646569340306e-2,
    -1.08347328697249322858509316994e-4,
    3.82571090835658412954920192323e-4,
    -3.40465008687404560802977114492e-4,
    1.41312443674632500278074618366e-1,
};
static const double A16[] = {
    -4.28896301583791923408573538692e-1,
    -4.69762141536116384314449447206e0,
    7.68342119606259904184240953878e0,
    4.06898981839711007970213554331e0,
    3.56727187455281109270669543021e-1,
    -1.39902416515901462129418009734e-3,
    2.9475147891527723389556272149e0,
    -9.15095847217987001081870187138e0,
};
static const double D4[] = {
    -0.84289382761090128651353491142e1, 0.56671495351937776962531783590,
    -0.30689499459498916912797304727e1, 0.23846676565120698287728149680e1,
    0.21170345824450282767155149946e1, -0.87139158377797299206789907490,
    0.22404374302607882758541771650e1, 0.63157877876946881815570249290,
    -0.88990336451333310820698117400e-1, 0.18148505520854727256656404962e2,
    -0.91946323924783554000451984436e1, -0.44360363875948939664310572000e1,
};
static const double D5[] = {
    0.10427508642579134603413151009e2, 0.24228349177525818288430175319e3,
    0.16520045171727028198505394887e3, -0.37454675472269020279518312152e3,
    -0.22113666853125306036270938578e2, 0.77334326684722638389603898808e1,
    -0.30674084731089398182061213626e2, -0.93321305264302278729567221706e1,
    0.15697238121770843886131091075e2, -0.31139403219565177677282850411e2,
    -0.93529243588444783865713862664e1, 0.35816841486394083752465898540e2,
};
static const double D6[] = {
    0.19985053242002433820987653617e2, -0.38703730874935176555105901742e3,
    -0.18917813819516756882830838328e3, 0.52780815920542364900561016686e3,
    -0.11573902539959630126141871134e2, 0.68812326946963000169666922661e1,
    -0.10006050966910838403183860980e1, 0.77771377980534432092869265740,
    -0.27782057523535084065932004339e1, -0.60196695231264120758267380846e2,
    0.84320405506677161018159903784e2, 0.11992291136182789328035130030e2,
};
static const double D7[] = {
    -0.25693933462703749003312586129e2, -0.15418974869023643374053993627e3,
    -0.23152937917604549567536039109e3, 0.35763911791061412378285349910e3,
    0.93405324183624310003907691704e2, -0.37458323136451633156875139351e2,
    0.10409964950896230045147246184e3, 0.29840293426660503123344363579e2,
    -0.43533456590011143754432175058e2, 0.96324553959188282948394950600e2,
    -0.39177261675615439165231486172e2, -0.14972683625798562581422125276e3,
};
/* clang-format on */

/* The stages whose slopes the rows multiply. */
typedef unsigned char stages[12];
static const stages EARLY = {0, 1}, A4_OF = {0, 2}, A5_OF = {0, 2, 3};
static const stages A_OF = {0, 3, 4, 5, 6, 7, 8, 9, 10};
static const stages B_OF = {0, 5, 6, 7, 8, 9, 10, 11};
static const stages E3_OF = {0, 8, 11};
static const stages A14_OF = {0, 6, 7, 8, 9, 10, 11, 12};
static const stages A15_OF = {0, 5, 6, 7, 10, 11, 12, 13};
static const stages A16_OF = {0, 5, 6, 7, 8, 12, 13, 14};
static const stages D_OF = {0, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/* Sets sums to a row of the tableau times the slopes, for `vectors` vectors of
 * variables. */
COIN_PRIV_INLINE void sum_row(lanes *sums, const coin_priv_dop853 *w,
                              const double *row, const stages of, int count,
                              int vectors)
{
#pragma GCC unroll 16
    for (int i = 0; i < vectors; ++i)
        sums[i] = row[0] * load(&w->slope[of[0]][i * LANES]);
    for (int k = 1; k < count; ++k) {
#pragma GCC unroll 16
        for (int i = 0; i < vectors; ++i)
            sums[i] = sums[i] + row[k] * load(&w->slope[of[k]][i * LANES]);
    }
}

/* A stage: the slopes, number `to`, where a row of `count` leads; nothing if
 * those of a stage before mean nothing. */
static void stage(coin_priv_dop853 *w, const double *row, const stages of,
                  int count, int to)
{
    double at[COIN_PRIV_WIDE];
    lanes sums[READ];
    if (!w->sound)
        return;
    sum_row(sums, w, row, of, count, READ);
#pragma GCC unroll 16
    for (int i = 0; i < READ; ++i)
        store(at + i * LANES, load(&w->y[i * LANES]) + w->h * sums[i]);
    w->sound = w->of.rates(w->slope[to], at, &w->of);
}

/* Stages 2 to 12. */
static void all_stages(coin_priv_dop853 *w)
{
    w->sound = 1;
    stage(w, A2, EARLY, 1, 1);
    stage(w, A3, EARLY, 2, 2);
    stage(w, A4, A4_OF, 2, 3);
    stage(w, A5, A5_OF, 3, 4);
    stage(w, A6, A_OF, 3, 5);
    stage(w, A7, A_OF, 4, 6);
    stage(w, A8, A_OF, 5, 7);
    stage(w, A9, A_OF, 6, 8);
    stage(w, A10, A_OF, 7, 9);
    stage(w, A11, A_OF, 8, 10);
    stage(w, A12, A_OF, 9, 11);
}

/* The error of a step is computed from two estimates, one of order 5 and one of
 * order 3.  At some lengths of a step the first is 0 by chance, and so is then
 * the error that is computed.  It is therefore set to at least LEAST_PART times
 * the square of the second, which is of order 8 as the error is.  Measured:
 * LEAST_PART in tables.md. */
#define LEAST_PART 1e-4

double coin_priv_try_step(coin_priv_dop853 *w, double h)
{
    double by5 = 0, by3 = 0, off5[COIN_PRIV_WIDE], off3[COIN_PRIV_WIDE];
    w->h = h;
    w->has_dense = 0;
    all_stages(w);
    if (!w->sound)
        return (double)INFINITY;
    lanes by[ALL], e5[READ], e3[READ];
    sum_row(by, w, B, B_OF, 8, ALL);
    sum_row(e5, w, E5, B_OF, 8, READ);
    sum_row(e3, w, E3, E3_OF, 3, READ);
#pragma GCC unroll 16
    for (int i = 0; i < ALL; ++i)
        store(w->end + i * LANES, load(&w->y[i * LANES]) + h * by[i]);
#pragma GCC unroll 16
    for (int i = 0; i < READ; ++i) {
        store(off5 + i * LANES, h * e5[i]);
        store(off3 + i * LANES, h * (by[i] - e3[i]));
    }
    if (!w->of.rates(0, w->end, &w->of))
        return (double)INFINITY;
#pragma GCC unroll 16
    for (int i = 0; i < COIN_PRIV_READ; ++i) {
        by5 += off5[i] * off5[i];
        by3 += off3[i] * off3[i];
    }
    /* The factor 0.01 is that of DOP853. */
    const double sum = by5 + 0.01 * by3;
    const double error = sum > 0 ? by5 / sqrt(sum) : sum;
    return coin_priv_larger(error, LEAST_PART * by3);
}

/* Sets a coefficient of the polynomial to a row of D. */
COIN_PRIV_NOINLINE void set_dense(coin_priv_dop853 *w, const double *row, int r)
{
    lanes sums[ALL];
    sum_row(sums, w, row, D_OF, 12, ALL);
    for (int i = 0; i < ALL; ++i)
        store(&w->dense[r][i * LANES], w->h * sums[i]);
}

/* Computes the polynomial: a cubic if slopes of a stage mean nothing. */
static void make_dense(coin_priv_dop853 *w)
{
    const double h = w->h;
    w->has_dense = 1;
    w->sound = w->of.rates(w->slope[12], w->end, &w->of);
    for (int i = 0; i < ALL * LANES; i += LANES) {
        const lanes dy = load(&w->end[i]) - load(&w->y[i]);
        const lanes first = h * load(&w->slope[0][i]);
        const lanes last = h * load(&w->slope[12][i]);
        store(&w->dense[0][i], dy);
        store(&w->dense[1][i], first - dy);
        store(&w->dense[2][i], 2 * dy - (first + last));
    }
    stage(w, A14, A14_OF, 8, 13);
    stage(w, A15, A15_OF, 8, 14);
    stage(w, A16, A16_OF, 8, 15);
    if (!w->sound) {
        memset(w->dense + 3, 0, 4 * sizeof *w->dense);
        return;
    }
    set_dense(w, D4, 3);
    set_dense(w, D5, 4);
    set_dense(w, D6, 5);
    set_dense(w, D7, 6);
}

/* The first `vectors` vectors of the variables at the part x of the step. */
COIN_PRIV_INLINE void within(double *to, coin_priv_dop853 *w, double x,
                             int vectors)
{
    if (!w->has_dense)
        make_dense(w);
    for (int i = 0; i < vectors * LANES; i += LANES) {
        lanes sum = x * load(&w->dense[6][i]);
        for (int r = 5; r >= 0; --r)
            sum = (sum + load(&w->dense[r][i])) * (r % 2 ? 1 - x : x);
        store(to + i, load(&w->y[i]) + sum);
    }
}

void coin_priv_within(double *to, coin_priv_dop853 *w, double x)
{
    within(to, w, x, ALL);
}

void coin_priv_read_within(double *to, coin_priv_dop853 *w, double x)
{
    within(to, w, x, (COIN_PRIV_READ + LANES - 1) / LANES);
}
