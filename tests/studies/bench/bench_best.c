/* SPDX-License-Identifier: MIT */
/* The best that double precision gives after a hundred natural units of time,
 * on every scene of tests/reference and on its hundred random coins, beside
 * the limit 4 amp 1e-15 + 4e-15, amp being what the motion does to rounding.
 */
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const names[] = {
    "wobble", "generic", "spin",     "circle",   "tumble",  "nearflat",
    "flat3",  "ring",    "ring_b05", "negative", "quarter", "si_washer",
};

/* The coin at the last row, or after as many steps of coin_run(). */
static double by_advance(const scene *c, double tol)
{
    const struct scene_row *last = &c->row[c->rows - 1];
    coin_state s = c->row[0].s;
    return coin_advance(&s, &c->p, last->t, tol, NULL) < 0
               ? (double)INFINITY
               : scene_error(c, &s, &last->s, 0);
}

static double by_rk8(const scene *c, double h)
{
    const struct scene_row *last = &c->row[c->rows - 1];
    const double n = ceil(last->t / (h * c->unit));
    coin_state s = c->row[0].s;
    return coin_run(&s, &c->p, COIN_RK8, last->t / n, (uint64_t)n, NULL) < 0
               ? (double)INFINITY
               : scene_error(c, &s, &last->s, 0);
}

static void report(const scene *c)
{
    double advance = INFINITY, rk8 = INFINITY;
    for (double tol = 1e-9; tol > 0.99e-13; tol /= 1.7782794100389228)
        advance = fmin(advance, by_advance(c, fmax(tol, 1e-13)));
    for (double h = 0.1; h > 1e-3; h /= 1.189207115002721)
        rk8 = fmin(rk8, by_rk8(c, h));
    const double amp = c->row[c->rows - 1].amp;
    const double limit = 4e-15 * amp + 4e-15;
    printf("%s,%.6g,%.2g,%.3g,%.3g,%.3g,%s\n", c->name,
           c->row[c->rows - 1].t / c->unit, amp, advance, rk8, limit,
           fmin(advance, rk8) <= limit ? "yes" : "no");
}

/* b, theta wX wY wZ at the start; theta ... wZ at t = 100; amp. */
static void random_coins(void)
{
    char line[2048], name[32];
    FILE *f = fopen(BENCH_DATA "/random.csv", "r");
    if (!f) {
        perror(BENCH_DATA "/random.csv");
        exit(1);
    }
    for (int k = 0; fgets(line, sizeof line, f);) {
        if (!strchr("0123456789-", line[0]))
            continue;
        double v[14];
        char *at = line;
        for (int i = 0; i < 14; ++i, ++at)
            v[i] = strtod(at, &at);
        scene c = {.name = name, .unit = 1, .rows = 2};
        snprintf(name, sizeof name, "random %d", k++);
        coin_params_ring(&c.p, 1, 1, v[0], 1);
        const coin_state start = {v[1], 0, 0, 0, 0, v[2], v[3], v[4]};
        const coin_state end = {v[5], v[6],  v[7],  v[8],
                                v[9], v[10], v[11], v[12]};
        c.row[0].s = start;
        c.row[1].t = 100;
        c.row[1].amp = v[13];
        c.row[1].s = end;
        report(&c);
    }
    fclose(f);
}

int main(void)
{
    puts("scene,units,amp,coin_advance,rk8,limit,reached");
    for (unsigned i = 0; i < sizeof names / sizeof *names; ++i) {
        scene c;
        scene_load(&c, names[i], INFINITY);
        report(&c);
    }
    random_coins();
    return 0;
}
