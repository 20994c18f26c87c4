/* SPDX-License-Identifier: MIT */
/* A US quarter to rest by coin_settle() and by fixed steps of order 4 and 8.
 *     fixed                    a row for each setting: the errors
 *     fixed count METHOD SET   that life, to be counted
 *
 * Fixed steps know no rest: they end when the coin has gone through the table,
 * gained energy or is no number. */
#include "studies/bench/textbook.h"

#include <coin.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define HALF_PI 1.5707963267948966
#define DRY (8.5e-4 * 0.00567 * 9.80665 * 0.01213)

enum { STAGES = 11 };

/* Cooper and Verner's method of order 8, SIAM J. Numer. Anal. 9 (1972) 389,
 * by rows: a_i1 ... a_i,i-1. */
#define S 4.58257569495584000659 /* sqrt(21) */
static const double A[STAGES][STAGES] = {
    {0},
    {1. / 2},
    {1. / 4, 1. / 4},
    {1. / 7, (-7 - 3 * S) / 98, (21 + 5 * S) / 49},
    {(11 + S) / 84, 0, (18 + 4 * S) / 63, (21 - S) / 252},
    {(5 + S) / 48, 0, (9 + S) / 36, (-231 + 14 * S) / 360, (63 - 7 * S) / 80},
    {(10 - S) / 42, 0, (-432 + 92 * S) / 315, (633 - 145 * S) / 90,
     (-504 + 115 * S) / 70, (63 - 13 * S) / 35},
    {1. / 14, 0, 0, 0, (14 - 3 * S) / 126, (13 - 3 * S) / 63, 1. / 9},
    {1. / 32, 0, 0, 0, (91 - 21 * S) / 576, 11. / 72, (-385 - 75 * S) / 1152,
     (63 + 13 * S) / 128},
    {1. / 14, 0, 0, 0, 1. / 9, (-733 - 147 * S) / 2205, (515 + 111 * S) / 504,
     (-51 - 11 * S) / 56, (132 + 28 * S) / 245},
    {0, 0, 0, 0, (-42 + 7 * S) / 18, (-18 + 28 * S) / 45, (-273 - 53 * S) / 72,
     (301 + 53 * S) / 72, (28 - 28 * S) / 45, (49 - 7 * S) / 18},
};
static const double B[STAGES] = {
    1. / 20, 0, 0, 0, 0, 0, 0, 49. / 180, 16. / 45, 49. / 180, 1. / 20};

static const double A4[4][STAGES] = {{0}, {0.5}, {0, 0.5}, {0, 0, 1}};
static const double B4[4] = {1. / 6, 1. / 3, 1. / 3, 1. / 6};

static coin_params quarter;
static const coin_losses losses = {.dry = DRY};

/* From 30 degrees, with a nutation of a hundredth. */
static coin_state start(void)
{
    coin_state s;
    coin_params_disc(&quarter, 0.00567, 0.01213, 9.80665);
    coin_steady_spin(&s, &quarter, HALF_PI * 2 / 3);
    s.wX = 0.01 * HALF_PI / 3 * sqrt(quarter.gravity / quarter.radius);
    return s;
}

/* ------------------------------------------------------------- fixed steps */
/* Textbook rates, and the torque (65) of dry friction, softened as the library
 * does it. */
static void rates(double d[8], const double y[8])
{
    const coin_params *p = &quarter;
    const double soft = sqrt(p->gravity / p->radius) / 1024;
    textbook_rates(d, p, y);
    const double Q = -DRY * d[2] / sqrt(d[2] * d[2] + soft * soft);
    d[6] += Q * tan(y[0]) / p->inertia_X;
    d[7] += Q / (p->inertia_Z + p->mass * p->radius * p->radius);
}

static void step(double y[8], double dt, int stages, const double a[][STAGES],
                 const double *b)
{
    double k[STAGES][8];
    for (int i = 0; i < stages; ++i) {
        double at[8];
        for (int n = 0; n < 8; ++n) {
            at[n] = y[n];
            for (int j = 0; j < i; ++j)
                at[n] += dt * a[i][j] * k[j][n];
        }
        rates(k[i], at);
    }
    for (int n = 0; n < 8; ++n)
        for (int i = 0; i < stages; ++i)
            y[n] += dt * b[i] * k[i][n];
}

/* Two times that all steps meet: nine tenths of the life, and 13 ms before its
 * end. */
static const double LOOK[2] = {7.2, 8.0064};

/* What a life shows: the headings then, when it ends, and how. */
struct life {
    double heading[2], end;
    const char *how;
};

static const char *failed(const double y[8], double *E)
{
    const coin_state s = {y[0], y[1], y[2], y[3], y[4], y[5], y[6], y[7]};
    if (isnan(y[0]))
        return "no number";
    if (fabs(y[0]) >= HALF_PI)
        return "through the table";
    const double now = coin_energy(&s, &quarter);
    if (!(now < *E * (1 + 1e-6)))
        return "energy gained";
    *E = now;
    return NULL;
}

static struct life fixed(int order, double dt)
{
    const coin_state s = start();
    double y[8] = {s.theta, s.phi, s.psi, s.x, s.z, s.wX, s.wY, s.wZ};
    double E = coin_energy(&s, &quarter);
    struct life l = {{NAN, NAN}, 0, NULL};
    for (unsigned long k = 1; l.how == NULL; ++k) {
        if (order == 4)
            step(y, dt, 4, A4, B4);
        else
            step(y, dt, STAGES, A, B);
        l.end = (double)k * dt;
        l.how = failed(y, &E);
        for (int i = 0; i < 2; ++i)
            if (fabs(l.end - LOOK[i]) < dt / 2 && l.how == NULL)
                l.heading[i] = y[1];
    }
    return l;
}

/* ------------------------------------------------------------------ settle */
static struct life settled(double tol)
{
    coin_state s = start();
    struct life l = {{0, 0}, 0, "no rest"};
    for (int i = 0; i < 2; ++i) {
        const double t = LOOK[i] - l.end;
        coin_settle(&s, &quarter, &losses, t, tol, NULL);
        l.heading[i] = s.phi;
        l.end += t;
    }
    double rest;
    if (coin_settle(&s, &quarter, &losses, 60, tol, &rest) == COIN_RESTS)
        l.how = "rests";
    l.end += rest;
    return l;
}

static struct life one(const char *method, double set)
{
    if (!strcmp(method, "settle"))
        return settled(set);
    return fixed(!strcmp(method, "rk4") ? 4 : 8, set);
}

static void row(const char *method, double set, const struct life *truth)
{
    const struct life l = one(method, set);
    printf("%s,%.3e,%.2e,%.2e,%.2e,%s\n", method, set,
           fabs(l.heading[0] - truth->heading[0]),
           fabs(l.heading[1] - truth->heading[1]), fabs(l.end - truth->end),
           l.how);
}

int main(int count, char **of)
{
    if (count == 4 && !strcmp(of[1], "count")) {
        const struct life l = one(of[2], atof(of[3]));
        printf("%.17g %s\n", l.end, l.how);
        return 0;
    }
    const struct life truth = settled(1e-12);
    printf("method,setting,nine tenths,late,end,how\n");
    for (int k = 5; k <= 12; ++k)
        row("settle", pow(10, -k), &truth);
    for (int k = 0; k <= 8; ++k)
        row("rk4", 0.0072 / pow(2, k), &truth);
    for (int k = 0; k <= 6; ++k)
        row("rk8", 0.0144 / pow(2, k), &truth);
    return 0;
}
