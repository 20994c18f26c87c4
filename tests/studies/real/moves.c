/* SPDX-License-Identifier: MIT */
/* How coins that slip end, and what they cost: too long for `make check`.
 *     moves N SHARE    random launches with mu_kinetic = SHARE mu_static */
#include "support/slides.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

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

int main(int argc, char **argv)
{
    launches(argc > 1 ? atoi(argv[1]) : 10000,
             argc > 2 ? strtod(argv[2], NULL) : 0.9);
    return 0;
}
