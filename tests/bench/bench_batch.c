/* SPDX-License-Identifier: MIT */
/* What a step of a coin costs among many: coin_batch_run() against coin_run()
 * in a loop, in the same windows, beside what its operations must take.
 *     bench_batch BUILD          CSV
 *     bench_batch BUILD COINS    of that many coins alone */
#include "clock.h"
#include "lanes.h"
#define RATE_LANES COIN_PRIV_LANES
#include "rate.h"
#include "textbook.h"

#include <coin.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS = 256, MOST = 1000000 };

/* Whoever measures takes turns with the others for so long [ns]. */
#define PATIENCE 4e8

static coin_params p;
static coin_state *alike, *mixed, *now;

static double part(size_t i, size_t stride)
{
    return (double)(i * stride % MOST) / MOST;
}

/* Coins of a kind, though no two are equal, and coins of all kinds: slow and
 * fast, upright and near flat. */
static void make_coins(void)
{
    alike = calloc(MOST, sizeof *alike);
    mixed = calloc(MOST, sizeof *mixed);
    now = calloc(MOST, sizeof *now);
    if (!alike || !mixed || !now || coin_params_disc(&p, 1, 1, 1) != COIN_OK)
        exit(1);
    for (size_t i = 0; i < MOST; ++i) {
        alike[i].theta = 0.1 + 0.4 * part(i, 7919);
        alike[i].wY = 0.5;
        alike[i].wZ = 1.5;
        mixed[i].theta = 2.8 * part(i, 7919) - 1.4;
        mixed[i].wX = 4 * part(i, 104729) - 2;
        mixed[i].wY = 4 * part(i, 611953) - 2;
        mixed[i].wZ = 4 * part(i, 350377) - 2;
    }
}

static void go_textbook(int32_t method, size_t count)
{
    (void)method;
    for (size_t i = 0; i < count; ++i)
        textbook_run(&now[i], &p, 0.05, STEPS);
}

static void go_alone(int32_t method, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        coin_run(&now[i], &p, method, 0.05, STEPS, NULL);
}

static void go_abreast(int32_t method, size_t count)
{
    coin_batch_run(now, count, &p, method, 0.05, STEPS, NULL);
}

/* Up to how many coins: beyond, what each does alone takes minutes. */
static const struct way {
    const char *name;
    int32_t method;
    void (*go)(int32_t method, size_t count);
    coin_state **coins;
    size_t most;
} ways[] = {
    {"textbook rk4", COIN_RK4, go_textbook, &alike, MOST / 10},
    {"rk4 alone", COIN_RK4, go_alone, &alike, MOST},
    {"rk4 abreast", COIN_RK4, go_abreast, &alike, MOST},
    {"rk8 alone", COIN_RK8, go_alone, &alike, MOST / 10},
    {"rk8 abreast", COIN_RK8, go_abreast, &alike, MOST},
    {"rk4 alone of any", COIN_RK4, go_alone, &mixed, MOST / 100},
    {"rk4 abreast of any", COIN_RK4, go_abreast, &mixed, MOST / 100},
};

enum { WAYS = sizeof ways / sizeof *ways };

/* ns per coin and step. */
static double window(const struct way *way, size_t count, double tare)
{
    memcpy(now, *way->coins, count * sizeof *now);
    const double begin = clock_ns();
    way->go(way->method, count);
    return (clock_ns() - begin - tare) / (double)count / STEPS;
}

static void measure(const char *build, size_t count)
{
    const double tare = clock_cost(), begin = clock_ns();
    double least[WAYS];
    for (int k = 0; k < WAYS; ++k)
        least[k] = INFINITY;
    do
        for (int k = 0; k < WAYS; ++k)
            if (count <= ways[k].most)
                least[k] = fmin(least[k], window(&ways[k], count, tare));
    while (clock_ns() - begin < PATIENCE);
    for (int k = 0; k < WAYS; ++k)
        if (count <= ways[k].most)
            printf("%s,%s,%zu,%.3g,%.3g\n", build, ways[k].name, count,
                   least[k], 1e3 / least[k]);
    fflush(stdout);
}

static void best_rate(const char *build)
{
    const double tare = clock_cost();
    double least = INFINITY;
    for (int i = 0; i < 5000; ++i)
        least = fmin(least, rate_window(tare));
    printf("%s,operation at best,%d,%.3g,%.3g\n", build, COIN_PRIV_LANES, least,
           1e3 / least);
}

int main(int argc, char **argv)
{
    static const size_t counts[] = {1,   2,    4,     8,      16,  64,
                                    256, 1000, 10000, 100000, MOST};
    const char *build = argc > 1 ? argv[1] : "unnamed";
    make_coins();
    best_rate(build);
    if (argc > 2)
        measure(build, strtoul(argv[2], NULL, 10));
    for (size_t k = 0; argc <= 2 && k < sizeof counts / sizeof *counts; ++k)
        measure(build, counts[k]);
    return 0;
}
