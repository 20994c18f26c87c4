/* SPDX-License-Identifier: MIT */
/* What a call costs as a frame loop makes it, against a step of the textbook's
 * in the same windows.
 *     bench_calls BUILD          CSV
 *     bench_calls list           the names of the calls
 *     bench_calls run CALL N     N of them and nothing else, for callgrind */
#include "clock.h"
#include "scene.h"
#include "textbook.h"

#include <coinf.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Calls of a window, a multiple of COINS; windows of each call. */
enum { CALLS = 1024, COINS = 64, ROUNDS = 1000 };

#define DT 0.05

static coin_params p;
static coinf_params pf;
static coin_state along[COINS]; /* a motion, sampled */
static coin_state coins[COINS], samples[CALLS], s;
static coinf_state sf;
static coin_force force;
static double energies;

static int textbook(uint64_t n)
{
    textbook_run(&s, &p, DT, n);
    return 0;
}

static int step(uint64_t n)
{
    int32_t worst = COIN_OK;
    while (n-- > 0)
        worst |= coin_step(&s, &p, DT);
    return worst < 0;
}

static int run_rk8(uint64_t n)
{
    int32_t worst = COIN_OK;
    while (n-- > 0)
        worst |= coin_run(&s, &p, COIN_RK8, DT, 1, NULL);
    return worst < 0;
}

static int long_run(uint64_t n)
{
    return coin_run(&s, &p, COIN_RK4, DT, n, NULL) < 0;
}

static int reaction(uint64_t n)
{
    int32_t worst = COIN_OK;
    while (n-- > 0)
        worst |= coin_reaction(&along[n % COINS], &p, &force);
    return worst < 0;
}

static int check(uint64_t n)
{
    int32_t worst = COIN_OK;
    while (n-- > 0)
        worst |= coin_check(&along[n % COINS], &p, COIN_RK4, DT, 1);
    return worst < 0;
}

static int energy(uint64_t n)
{
    while (n-- > 0)
        energies += coin_energy(&along[n % COINS], &p);
    return !isfinite(energies);
}

static int batch(uint64_t n)
{
    int32_t worst = COIN_OK;
    for (; n >= COINS; n -= COINS)
        worst |= coin_batch_run(coins, COINS, &p, COIN_RK4, DT, 1, NULL);
    return worst < 0;
}

static int sample(uint64_t n)
{
    int32_t worst = COIN_OK;
    for (; n >= CALLS; n -= CALLS)
        worst |= coin_sample(&s, &p, COIN_RK4, DT, 1, CALLS, samples, NULL);
    return worst < 0;
}

static int single_step(uint64_t n)
{
    int32_t worst = COIN_OK;
    while (n-- > 0)
        worst |= coinf_step(&sf, &pf, (float)DT);
    return worst < 0;
}

/* Each does n times what its name says; not 0 if one failed. */
static const struct call {
    const char *name;
    int (*make)(uint64_t n);
} calls[] = {
    {"textbook RK4 step", textbook},
    {"coin_step", step},
    {"coin_run of one RK8 step", run_rk8},
    {"coin_run per RK4 step", long_run},
    {"coin_reaction", reaction},
    {"coin_check", check},
    {"coin_energy", energy},
    {"coin_batch_run of one step per coin of 64", batch},
    {"coin_sample per sample of one step", sample},
    {"coinf_step", single_step},
};

enum { NAMES = sizeof calls / sizeof *calls };

static void prepare(void)
{
    scene c;
    scene_load(&c, "generic", 20);
    p = c.p;
    s = c.row[0].s;
    if (coin_sample(&s, &p, COIN_RK8, DT, 5, COINS, along, NULL) != COIN_OK ||
        coinf_params_body(&pf, (float)p.mass, (float)p.radius, (float)p.gravity,
                          (float)p.inertia_X, (float)p.inertia_Z) != COIN_OK)
        exit(1);
}

/* Every window begins where the others do. */
static void rewind_coins(void)
{
    const coinf_state from = {
        (float)along[0].theta,
        0,
        0,
        0,
        0,
        (float)along[0].wX,
        (float)along[0].wY,
        (float)along[0].wZ,
        {0},
    };
    s = along[0];
    sf = from;
    memcpy(coins, along, sizeof coins);
    energies = 0;
}

static double window(const struct call *call, double tare)
{
    rewind_coins();
    const double begin = clock_ns();
    const int failed = call->make(CALLS);
    const double ns = (clock_ns() - begin - tare) / CALLS;
    return failed ? (double)NAN : ns;
}

/* All take turns, so that each sees the machine's quiet moments. */
static void measure(const char *build)
{
    const double tare = clock_cost();
    double least[NAMES];
    for (int k = 0; k < NAMES; ++k)
        least[k] = (double)INFINITY;
    for (int i = 0; i < ROUNDS; ++i)
        for (int k = 0; k < NAMES; ++k)
            least[k] = fmin(least[k], window(&calls[k], tare));
    for (int k = 0; k < NAMES; ++k)
        printf("%s,%s,%.4g,%.4g\n", build, calls[k].name, least[k],
               least[k] / least[0]);
}

int main(int argc, char **argv)
{
    prepare();
    rewind_coins();
    if (argc == 2 && strcmp(argv[1], "list") == 0) {
        for (int k = 0; k < NAMES; ++k)
            puts(calls[k].name);
    } else if (argc == 4 && strcmp(argv[1], "run") == 0) {
        for (int k = 0; k < NAMES; ++k)
            if (strcmp(argv[2], calls[k].name) == 0)
                return calls[k].make(strtoull(argv[3], NULL, 10));
        fprintf(stderr, "bench_calls: no call %s\n", argv[2]);
        return 2;
    } else
        measure(argc > 1 ? argv[1] : "unnamed");
    return 0;
}
