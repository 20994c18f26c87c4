/* SPDX-License-Identifier: MIT */
/* How often coin_advance() keeps the error that a tolerance asks for, over the
 * random coins of peers/truth.
 *     bench_reliability TRUTH.csv */
#include <coin.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COINS = 1000 };

/* The time from the start to the end of a coin, natural units. */
#define UNITS 4.0

static struct coin {
    coin_params p;
    coin_state start, end;
} coins[COINS];

/* Two rows for each coin: its start and its end. */
static void load(const char *path)
{
    char line[1024];
    FILE *f = fopen(path, "r");
    if (!f || !fgets(line, sizeof line, f)) {
        perror(path);
        exit(1);
    }
    for (int i = 0; i < 2 * COINS; ++i) {
        double v[10];
        char *at = fgets(line, sizeof line, f);
        for (int k = 0; at && k < 10; ++k, ++at)
            v[k] = strtod(at, &at);
        if (!at) {
            fprintf(stderr, "%s: too short\n", path);
            exit(1);
        }
        struct coin *c = &coins[i / 2];
        const coin_state s = {v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9]};
        coin_params_ring(&c->p, 1, 1, v[0], 1);
        *(i % 2 == 0 ? &c->start : &c->end) = s;
    }
    fclose(f);
}

static double error_of(const coin_state *s, const coin_state *truth)
{
    double e = fabs(s->theta - truth->theta);
    e = fmax(e, fabs(s->phi - truth->phi));
    e = fmax(e, fabs(s->psi - truth->psi));
    e = fmax(e, fabs(s->x - truth->x));
    return fmax(e, fabs(s->z - truth->z));
}

/* Error per unit of time; infinity if refused. */
static double attempt(const struct coin *c, double tol)
{
    coin_state s = c->start;
    const int32_t status = coin_advance(&s, &c->p, UNITS, tol, NULL);
    return status < 0 ? (double)INFINITY : error_of(&s, &c->end) / UNITS;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void judge(double tol)
{
    double e[COINS];
    int within[3] = {0, 0, 0}, refused = 0;
    for (int i = 0; i < COINS; ++i) {
        e[i] = attempt(&coins[i], tol);
        within[0] += e[i] <= tol;
        within[1] += e[i] <= 3 * tol;
        within[2] += e[i] <= 10 * tol;
        refused += isinf(e[i]);
    }
    qsort(e, COINS, sizeof *e, ascending);
    printf("%.0e,%d,%d,%.2f,%.2f,%.2f,%.3g,%.3g\n", tol, COINS, refused,
           100.0 * within[0] / COINS, 100.0 * within[1] / COINS,
           100.0 * within[2] / COINS, e[COINS / 2] / tol, e[COINS - 1] / tol);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: bench_reliability TRUTH.csv\n");
        return 2;
    }
    load(argv[1]);
    puts("tol,coins,refused,within_1,within_3,within_10,median_over_tol,"
         "worst_over_tol");
    for (double tol = 1e-2; tol > 5e-13; tol /= 10)
        judge(tol);
    return 0;
}
