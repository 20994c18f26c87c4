/* SPDX-License-Identifier: MIT */
/* What coins that slip cost, and how they end: too long for `make check`.
 *     moves launches N SHARE   random launches with mu_kinetic = SHARE
 *                               mu_static: how they end, and the worst cost
 *     moves cost                beside coin_advance(), where nothing slips */
#include "support/slides.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* ---------------------------------------------------------------- launches */
static void launches(int n, double share)
{
    struct random r = random_begin(201);
    int ended[5] = {0}, pulled = 0;
    double rise = 0, worst = 0, all = 0, time = 0;
    for (int i = 0; i < n; ++i) {
        coin_params p;
        coin_params_ring(&p, 1, 1, i % 2 ? 0 : random_between(&r, 0, 1), 1);
        const double mu = random_between(&r, 0.2, 0.6);
        const coin_table f = {.mu_static = mu, .mu_kinetic = share * mu};
        coin_body d = random_launch(&r, &p);
        double E = coin_body_energy(&d, &p), reached = 0;
        int32_t status = COIN_OK;
        const double begin = seconds();
        for (int k = 0; k < 20 && (status == COIN_OK || status == COIN_SLIPS);
             ++k) {
            coin_force force;
            status = coin_move(&d, &p, &f, 1, 1e-9, COIN_LIFTS, &reached);
            rise = fmax(rise, coin_body_energy(&d, &p) - E);
            E = coin_body_energy(&d, &p);
            coin_body_reaction(&d, &p, &f, &force);
            pulled += status >= 0 && force.normal < 0;
            time += reached;
        }
        const double took = seconds() - begin;
        worst = fmax(worst, took);
        all += took;
        ++ended[status < 0 ? 4 : status == COIN_RESTS ? 3 : status];
    }
    printf("%d launches: %d roll, %d slip, %d lift, %d rest, %d other; energy "
           "rises by "
           "%.1e at most; %d of N < 0 unsaid\n",
           n, ended[0], ended[1], ended[2], ended[3], ended[4], rise, pulled);
    printf("%.1f us per natural unit, the worst launch %.1f ms\n",
           1e6 * all / time, 1e3 * worst);
}

/* ------------------------------------------------------------------- rolls */
/* Frames of 1/60 s of a US quarter that rolls. */
static void cost(void)
{
    const coin_state start = {.theta = 0.3, .wY = 5, .wZ = 40};
    const coin_table f = {.mu_static = 0.6, .mu_kinetic = 0.5};
    enum { FRAMES = 60, TRIED = 400 };
    coin_params p;
    coin_params_disc(&p, 0.00567, 0.01213, 9.80665);
    for (double tol = 1e-3; tol > 0.5e-9; tol /= 1000) {
        double rolls = INFINITY, moves = INFINITY;
        for (int k = 0; k < TRIED; ++k) {
            coin_state s = start;
            coin_body d;
            coin_body_from_state(&d, &start, &p);
            const double t0 = seconds();
            for (int i = 0; i < FRAMES; ++i)
                coin_advance(&s, &p, 1.0 / 60, tol, NULL);
            const double t1 = seconds();
            for (int i = 0; i < FRAMES; ++i)
                coin_move(&d, &p, &f, 1.0 / 60, tol, 0, NULL);
            const double t2 = seconds();
            rolls = fmin(rolls, t1 - t0);
            moves = fmin(moves, t2 - t1);
        }
        printf("a frame at %.0e: %.2f us, %.1f times coin_advance()\n", tol,
               1e6 * moves / FRAMES, moves / rolls);
    }
}

int main(int argc, char **argv)
{
    const char *what = argc > 1 ? argv[1] : "";
    if (strcmp(what, "launches") == 0)
        launches(argc > 2 ? atoi(argv[2]) : 10000,
                 argc > 3 ? strtod(argv[3], NULL) : 0.9);
    else if (strcmp(what, "cost") == 0)
        cost();
    else
        return 2;
    return 0;
}
