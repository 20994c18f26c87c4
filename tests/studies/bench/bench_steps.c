/* SPDX-License-Identifier: MIT */
/* What a step costs: of every method, against the textbook's in the same
 * windows.
 *     bench_steps BUILD            CSV
 *     bench_steps run METHOD N     N steps and nothing else, for callgrind */
#define RATE_LANES 2 /* those of the portable build */
#include "clock.h"
#include "movers.h"
#include "plain.h"
#include "rate.h"
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STEPS 1000
#define ROUNDS 2000

static double window(enum mover_kind kind, const scene *c, double tare)
{
    mover m = mover_at(kind, &c->row[0].s, &c->p, 0.05);
    const double begin = clock_ns();
    const int failed = mover_go(&m, STEPS);
    const double ns = (clock_ns() - begin - tare) / STEPS;
    return failed ? NAN : ns;
}

/* Time for each of the operations, one of which waits for the other. */
#define CHAIN(name, operations, expression)                                    \
    static double name(double tare)                                            \
    {                                                                          \
        volatile double start = 1.0000001;                                     \
        double x = start, y = start;                                           \
        const double begin = clock_ns();                                       \
        for (int k = 0; k < STEPS; ++k) {                                      \
            expression                                                         \
        }                                                                      \
        const double ns = clock_ns() - begin - tare;                           \
        start = x;                                                             \
        return ns / ((operations)*STEPS);                                      \
    }
/* clang-format off */
CHAIN(latency_add, 4, x += y; x += y; x += y; x += y;)
CHAIN(latency_mul, 4, x *= y; x *= y; x *= y; x *= y;)
CHAIN(latency_div, 4, x /= y; x /= y; x /= y; x /= y;)
CHAIN(latency_sqrt, 2, x = sqrt(x); x = sqrt(x); (void)y;)
/* clang-format on */

/* On the scene that the others step, whose unit of time is 1. */
static double plain_step(double tare)
{
    static scene c;
    if (!c.rows)
        scene_load(&c, "generic", 20);
    const struct peer_body b = peer_body_of(&c);
    double y[8];
    scene_to_natural(&c, y);
    const double begin = clock_ns();
    plain_run(y, &b, 0.05, STEPS);
    return (clock_ns() - begin - tare) / STEPS;
}

static const struct {
    const char *name;
    double (*measure)(double tare);
} probes[] = {
    {"latency add", latency_add},      {"latency mul", latency_mul},
    {"latency div", latency_div},      {"latency sqrt", latency_sqrt},
    {"per flop at best", rate_window}, {"RK4 without tangent", plain_step},
};

enum { PROBES = sizeof probes / sizeof *probes };

/* All take turns, so that each sees the machine's quiet moments. */
static void cost_of_steps(const char *build, const scene *c)
{
    const double tare = clock_cost();
    double least[MOVERS + PROBES];
    for (int k = 0; k < MOVERS + PROBES; ++k)
        least[k] = INFINITY;
    for (int i = 0; i < ROUNDS; ++i) {
        for (int k = 0; k < MOVERS; ++k)
            least[k] = fmin(least[k], window((enum mover_kind)k, c, tare));
        for (int k = 0; k < PROBES; ++k)
            least[MOVERS + k] =
                fmin(least[MOVERS + k], probes[k].measure(tare));
    }
    for (int k = 0; k < MOVERS; ++k)
        printf("%s,%s,%.4g,%.4g\n", build, mover_name((enum mover_kind)k),
               least[k], least[MOVER_TEXTBOOK] / least[k]);
    for (int k = 0; k < PROBES; ++k)
        printf("%s,%s,%.4g,\n", build, probes[k].name, least[MOVERS + k]);
}

static int run_only(char **argv)
{
    scene c;
    scene_load(&c, "generic", 20);
    for (int k = 0; k < MOVERS; ++k) {
        if (strcmp(argv[2], mover_name((enum mover_kind)k)) != 0)
            continue;
        mover m = mover_at((enum mover_kind)k, &c.row[0].s, &c.p, 0.05);
        return mover_go(&m, strtoul(argv[3], NULL, 10));
    }
    fprintf(stderr, "bench_steps: no method %s\n", argv[2]);
    return 2;
}

int main(int argc, char **argv)
{
    if (argc == 4 && strcmp(argv[1], "run") == 0)
        return run_only(argv);
    const char *build = argc > 1 ? argv[1] : "unnamed";
    scene c;
    scene_load(&c, "generic", 20);
    cost_of_steps(build, &c);
    return 0;
}
