/* SPDX-License-Identifier: MIT */
/* How often the error that a tolerance asks for is kept: of coin_advance() and
 * of runs at coin_max_dt(), over the random coins of peers/truth, and over its
 * coins that spin nearly upright.
 *     bench_reliability TRUTH.csv SPINS.csv */
#include <coin.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COINS = 1000, ADVANCE = -1 };

/* A run of more steps than this is not made, but counted as skipped. */
#define PATIENCE 300000.0

struct coin {
    coin_params p;
    coin_state start, end[2];
};

static struct set {
    const char *name;
    double times[2];
    struct coin coins[COINS];
} sets[2] = {{.name = "random"}, {.name = "spins"}};

/* Three rows for each coin: at the start and at both times. */
static void load(struct set *set, const char *path)
{
    char line[1024];
    FILE *f = fopen(path, "r");
    if (!f || !fgets(line, sizeof line, f)) {
        perror(path);
        exit(1);
    }
    for (int i = 0; i < 3 * COINS; ++i) {
        double v[10];
        char *at = fgets(line, sizeof line, f);
        for (int k = 0; at && k < 10; ++k, ++at)
            v[k] = strtod(at, &at);
        if (!at) {
            fprintf(stderr, "%s: too short\n", path);
            exit(1);
        }
        struct coin *c = &set->coins[i / 3];
        const coin_state s = {v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9]};
        coin_params_ring(&c->p, 1, 1, v[0], 1);
        if (i % 3 > 0)
            set->times[i % 3 - 1] = v[1];
        *(i % 3 == 0 ? &c->start : &c->end[i % 3 - 1]) = s;
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

/* Error per unit of time; NaN if it would take too long; infinity if refused.
 */
static double attempt(const struct set *set, int i, int method, double tol,
                      int k)
{
    const struct coin *c = &set->coins[i];
    coin_state s = c->start;
    const double T = set->times[k];
    int32_t status;
    if (method == ADVANCE) {
        status = coin_advance(&s, &c->p, T, tol, NULL);
    } else {
        const double n = ceil(T / coin_max_dt(&s, &c->p, method, tol));
        if (!(n <= PATIENCE))
            return NAN;
        status = coin_run(&s, &c->p, method, T / n, (uint64_t)n, NULL);
    }
    return status < 0 ? (double)INFINITY : error_of(&s, &c->end[k]) / T;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void judge(const struct set *set, int method, double tol, int k)
{
    double e[COINS];
    int n = 0, within[3] = {0, 0, 0}, refused = 0;
    for (int i = 0; i < COINS; ++i) {
        e[n] = attempt(set, i, method, tol, k);
        if (isnan(e[n]))
            continue;
        within[0] += e[n] <= tol;
        within[1] += e[n] <= 3 * tol;
        within[2] += e[n] <= 10 * tol;
        refused += isinf(e[n]);
        ++n;
    }
    qsort(e, (size_t)n, sizeof *e, ascending);
    printf("%s,%s,%.0e,%g,%d,%d,%d,%.2f,%.2f,%.2f,%.3g,%.3g\n", set->name,
           method == ADVANCE ? "coin_advance" : coin_method_name(method), tol,
           set->times[k], n, COINS - n, refused, 100.0 * within[0] / n,
           100.0 * within[1] / n, 100.0 * within[2] / n, e[n / 2] / tol,
           e[n - 1] / tol);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    /* The finest tolerance that a method reaches in so many steps. */
    static const double finest[] = {1e-8, 1e-12, 1e-4, 1e-6};
    if (argc != 3) {
        fprintf(stderr, "usage: bench_reliability TRUTH.csv SPINS.csv\n");
        return 2;
    }
    load(&sets[0], argv[1]);
    load(&sets[1], argv[2]);
    puts("scenes,method,tol,time,coins,skipped,refused,within_1,within_3,"
         "within_10,"
         "median_over_tol,worst_over_tol");
    for (double tol = 1e-2; tol > 5e-13; tol /= 10)
        judge(&sets[0], ADVANCE, tol, 0);
    for (int m = 0; m < 4; ++m)
        for (double tol = 1e-2; tol > 0.5 * finest[m]; tol /= 100)
            judge(&sets[0], m, tol, 1);
    for (int m = 0; m < 4; ++m)
        for (double tol = 1e-2; tol > 0.5 * finest[m]; tol /= 100)
            for (int k = 0; k < 2; ++k)
                judge(&sets[1], m, tol, k);
    return 0;
}
