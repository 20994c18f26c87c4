/* SPDX-License-Identifier: MIT */
#include "fine.h"

#include "support/check.h"
#include "support/methods.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STAGES = 12, SIZE = 9 };

typedef long double real;

static real A[STAGES][STAGES], B[STAGES];

static void load_formula(void)
{
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

/* theta, phi, psi, x, z, wX, wY, wZ, t for M = a = g = 1: Eq. (14)-(20) times
 * cos(theta), by Sundman's time. */
static void rates(real IX, real IZ, const real y[SIZE], real d[SIZE])
{
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

static void step(real IX, real IZ, real y[SIZE], real h)
{
    real k[STAGES][SIZE];
    for (int i = 0; i < STAGES; ++i) {
        real at[SIZE];
        for (int n = 0; n < SIZE; ++n) {
            at[n] = y[n];
            for (int j = 0; j < i; ++j)
                at[n] += h * A[i][j] * k[j][n];
        }
        rates(IX, IZ, at, k[i]);
    }
    for (int i = 0; i < STAGES; ++i)
        for (int n = 0; n < SIZE; ++n)
            y[n] += h * B[i] * k[i][n];
}

/* Steps to a time: whole ones, and one that Newton's method fits. */
static void go(real IX, real IZ, real y[SIZE], real t)
{
    const real h = (t < y[8] ? -1 : 1) / (real)256;
    real last[SIZE], fit = h;
    do {
        memcpy(last, y, sizeof last);
        step(IX, IZ, y, h);
    } while ((y[8] - t) * h < 0);
    for (int i = 0; i < 6; ++i) {
        fit -= (y[8] - t) / cosl(y[0]) * (i > 0);
        memcpy(y, last, sizeof last);
        step(IX, IZ, y, fit);
    }
}

double fine_error(const struct rung_scene *scene, int looks)
{
    const coin_params *p = &scene->params;
    const coin_state *s = &scene->start;
    const real a = p->radius, unit = sqrtl(a / p->gravity);
    const real m = p->mass * a * a, IX = p->inertia_X / m,
               IZ = p->inertia_Z / m;
    real y[SIZE] = {s->theta,     s->phi,       s->psi,
                    s->x / a,     s->z / a,     s->wX * unit,
                    s->wY * unit, s->wZ * unit, 0};
    coin_orbit *orbit = malloc(sizeof *orbit);
    double most = 0;
    if (B[0] == 0)
        load_formula();
    check_status(coin_orbit_init(orbit, s, p), COIN_OK);
    for (int k = 1; k <= looks; ++k) {
        coin_state said;
        go(IX, IZ, y, scene->horizon / unit * k / looks);
        const coin_state is = {(double)y[0],
                               (double)y[1],
                               (double)y[2],
                               (double)(y[3] * a),
                               (double)(y[4] * a),
                               0,
                               0,
                               0};
        check_status(coin_orbit_at(orbit, scene->horizon * k / looks, &said),
                     COIN_OK);
        most = fmax(most, path_apart(&is, &said, p));
    }
    free(orbit);
    return most;
}
