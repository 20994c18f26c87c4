/* SPDX-License-Identifier: MIT */
#include "fine.h"

#include "check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STAGES = 12, SIZE = 9 };

/* The step over the fastest rate: its error, of order 8, is below 1e-17. */
#define STRIDE (1.0L / 40)

typedef long double real;

static real A[STAGES][STAGES], B[STAGES];

static void load_formula(void)
{
    check_long_double();
    FILE *f = fopen(TEST_DATA "/dormand-prince-8.csv", "r");
    char line[256], kind, value[128];
    int i, j;
    check(f != NULL);
    while (fgets(line, sizeof line, f))
        if (sscanf(line, "%c,%d,%d,%127s", &kind, &i, &j, value) == 4) {
            if (kind == 'a')
                A[i - 1][j - 1] = strtold(value, NULL);
        } else if (sscanf(line, "%c,%d,,%127s", &kind, &i, value) == 3) {
            if (kind == 'b')
                B[i - 1] = strtold(value, NULL);
        }
    fclose(f);
    real sum = 0;
    for (i = 0; i < STAGES; ++i)
        sum += B[i];
    check(fabsl(sum - 1) < 1e-17L);
}

/* Eq. (14)-(20) times cos(theta), by Sundman's time, M = a = g = 1. */
static void rates(const struct fine *f, const real y[SIZE], real d[SIZE])
{
    const real IX = f->IX, IZ = f->IZ;
    const real wX = y[5], wY = y[6], wZ = y[7];
    const real s = sinl(y[0]), c = cosl(y[0]);
    const real sph = sinl(y[1]), cph = cosl(y[1]);
    d[0] = c * wX;
    d[1] = wY;
    d[2] = c * wZ + wY * s;
    d[3] = c * (-wZ * cph + wX * c * sph);
    d[4] = c * (wZ * sph + wX * c * cph);
    d[5] = (c * s - (IZ + 1) * c * wY * wZ - IX * wY * wY * s) / (IX + 1);
    d[6] = wX * wY * s + IZ / IX * c * wZ * wX;
    d[7] = c * wX * wY / (IZ + 1);
    d[8] = c;
}

static void step(struct fine *f, real h)
{
    real k[STAGES][SIZE];
    for (int i = 0; i < STAGES; ++i) {
        real at[SIZE];
        memcpy(at, f->y, sizeof at);
        for (int j = 0; j < i; ++j)
            for (int n = 0; A[i][j] != 0 && n < SIZE; ++n)
                at[n] += h * A[i][j] * k[j][n];
        rates(f, at, k[i]);
    }
    for (int i = 0; i < STAGES; ++i)
        for (int n = 0; n < SIZE; ++n)
            f->y[n] += h * B[i] * k[i][n];
}

static real stride_of(const struct fine *f)
{
    const real *y = f->y, c = cosl(y[0]);
    return STRIDE / sqrtl(y[5] * y[5] + 1.5L * y[6] * y[6] +
                          4 * c * c * y[7] * y[7] + c);
}

struct fine fine_begin(const coin_state *s, const coin_params *p)
{
    const real a = p->radius, unit = sqrtl(a / p->gravity);
    const real m = p->mass * a * a;
    const struct fine f = {
        p->inertia_X / m,
        p->inertia_Z / m,
        a,
        unit,
        {s->theta, s->phi, s->psi, s->x / a, s->z / a, s->wX * unit,
         s->wY * unit, s->wZ * unit, 0},
    };
    if (B[0] == 0)
        load_formula();
    return f;
}

/* Full steps until the next one would pass t, and then one whose length
 * Newton's method finds. */
static void go(struct fine *f, real t)
{
    const real side = t < f->y[8] ? -1 : 1;
    struct fine last = *f;
    real fit = 0;
    while ((t - f->y[8]) * side > 0) {
        last = *f;
        fit = side * stride_of(f);
        step(f, fit);
    }
    for (int i = 0; i < 8; ++i) {
        fit -= (f->y[8] - t) / cosl(f->y[0]);
        *f = last;
        step(f, fit);
    }
}

coin_state fine_at(struct fine *f, double t)
{
    go(f, t / f->unit);
    const real *y = f->y, a = f->a, unit = f->unit;
    const coin_state s = {
        (double)y[0],          (double)y[1],          (double)y[2],
        (double)(y[3] * a),    (double)(y[4] * a),    (double)(y[5] / unit),
        (double)(y[6] / unit), (double)(y[7] / unit),
    };
    return s;
}
