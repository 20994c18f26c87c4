/* SPDX-License-Identifier: MIT */
/* 64 coins in a call of coin_batch_run(), beside a loop of coin_run() that
 * takes turns with it: ns per coin and step, for each length of step and of
 * call; and a textbook's step.
 *     bench_batch BUILD    CSV */
#include "clock.h"
#include "textbook.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { COINS = 64 };

/* Each cell is measured for so long [ns], so often: a processor that is slow
 * for a second, for another's sake, then spoils no cell. */
#define PATIENCE 1e8
enum { ROUNDS = 4 };

/* Coins of a quarter of a dollar, and how they are called. */
struct kind {
    const char *name;
    coin_params p;
    coin_state s[COINS];
    double W; /* the fastest rate of all, where they start */
};

static double part(int i, int stride)
{
    return i * stride % 101 / 101.0;
}

/* That of README, though no two lean alike. */
static coin_state rolling(int i)
{
    const coin_state s = {0.3 + 0.001 * part(i, 31), 0, 0, 0, 0, 0, 5, 40};
    return s;
}

/* Slow and fast, upright and near flat; w is the natural rate. */
static coin_state any(int i, double w)
{
    const coin_state s = {
        2.8 * part(i, 31) - 1.4,
        0,
        0,
        0,
        0,
        w * (4 * part(i, 43) - 2),
        w * (4 * part(i, 59) - 2),
        w * (4 * part(i, 73) - 2),
    };
    return s;
}

static struct kind kind_of(const char *name)
{
    struct kind k = {.name = name};
    coin_params_disc(&k.p, 0.00567, 0.01213, 9.80665);
    const double w = sqrt(k.p.gravity / k.p.radius);
    for (int i = 0; i < COINS; ++i) {
        k.s[i] = strcmp(name, "any") ? rolling(i) : any(i, w);
        k.W = fmax(k.W, coin_fastest_rate(&k.s[i], &k.p));
    }
    return k;
}

enum way { ALONE, ABREAST, TEXTBOOK, WAYS };

/* A call for all coins [ns]. */
static double call(enum way way, const struct kind *k, int32_t method,
                   double dt, unsigned steps)
{
    coin_state s[COINS];
    memcpy(s, k->s, sizeof s);
    const double begin = clock_ns();
    if (way == ABREAST)
        coin_batch_run(s, COINS, &k->p, method, dt, steps, NULL);
    for (int i = 0; i < COINS && way == ALONE; ++i)
        coin_run(&s[i], &k->p, method, dt, steps, NULL);
    for (int i = 0; i < COINS && way == TEXTBOOK; ++i)
        textbook_run(&s[i], &k->p, dt, steps);
    return clock_ns() - begin;
}

/* The ways take turns; least[] takes the least time of each so far. */
static void measure(double *least, const struct kind *k, int32_t method,
                    unsigned steps, double dt)
{
    const double begin = clock_ns();
    do
        for (int way = 0; way < WAYS; ++way)
            least[way] =
                fmin(least[way], call((enum way)way, k, method, dt, steps));
    while (clock_ns() - begin < PATIENCE);
}

static void print(const double *least, const char *build, const struct kind *k,
                  int32_t method, unsigned steps, double dtW, double tare)
{
    printf("%s,%s,%s,%u,%g", build, k->name, coin_method_name(method), steps,
           dtW);
    for (int way = 0; way < WAYS; ++way)
        printf(",%.3g", (least[way] - tare) / (COINS * steps));
    puts("");
}

int main(int argc, char **argv)
{
    static const double dtW[] = {0.02, 0.05, 0.1, 0.15, 0.2,
                                 0.25, 0.35, 0.5, 0.7,  1};
    static const unsigned calls[] = {1, 64};
    static double least[2][2][2][10][WAYS];
    const char *build = argc > 1 ? argv[1] : "unnamed";
    const struct kind kinds[] = {kind_of("quarter"), kind_of("any")};
    const double tare = clock_cost();
    for (int round = 0; round < ROUNDS; ++round)
        for (int k = 0; k < 2; ++k)
            for (int32_t m = COIN_RK4; m <= COIN_RK8; ++m)
                for (int n = 0; n < 2; ++n)
                    for (int i = 0; i < (m == COIN_RK4 ? 7 : 10); ++i) {
                        double *const at = least[k][m][n][i];
                        for (int way = 0; way < WAYS && round == 0; ++way)
                            at[way] = INFINITY;
                        measure(at, &kinds[k], m, calls[n],
                                dtW[i] / kinds[k].W);
                        if (round == ROUNDS - 1)
                            print(at, build, &kinds[k], m, calls[n], dtW[i],
                                  tare);
                    }
    return 0;
}
