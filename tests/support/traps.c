/* SPDX-License-Identifier: MIT */
#define _GNU_SOURCE /* feenableexcept() */
#include "traps.h"

#include "check.h"
#include "floats.h"
#include "random.h"

#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define TRAPPED (FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW)

enum { RANDOM_CASES = 20, MAX_CASES = 500, MAX_FUNCTIONS = 100 };

static struct trap_function {
    const char *name;
    int32_t (*call)(const struct trap_case *c);
} functions[MAX_FUNCTIONS];
static size_t count;

void traps_add(const char *name, int32_t (*call)(const struct trap_case *c))
{
    check(count < MAX_FUNCTIONS);
    functions[count++] = (struct trap_function){name, call};
}

#define FLATTEST 1.5707963267948963 /* the last lean that is accepted */

/* In natural units, for any body. */
static const double states[][8] = {
    {0, 0, 0, 0, 0, 0, 0, 0}, /* upright, at rest */
    {-0.0, -0.0, -0.0, -0.0, -0.0, -0.0, -0.0, -0.0},
    {0, 0, 0, 0, 0, 0, 0, 1},             /* a roll */
    {0, 0, 0, 0, 0, 0, 0, 0.3},           /* an unstable one */
    {0, 0, 0, 0, 0, 0, 1.5, 0},           /* an upright spin */
    {0, 0, 0, 0, 0, 0, -0.5, 0},          /* an unstable one */
    {0.4, 1, -2, 3, 4, 0, 0, 0},          /* falls flat */
    {-0.4, 1, -2, 3, 4, -0.1, 0, 0},      /* falls flat */
    {0.4, 1, -2, 3, 4, 0, 0.25502914, 1}, /* nearly a circle */
    {0.3, 0, 0, 0, 0, 0.1, 0.7, -1.2},
    {1.2, 3e9, 0, 0, 0, 0, 0, 0}, /* refused */
    {-1.2, 2147483648.0, -2147483648.0, 1e9, -1e9, 1, 2, 3},
    {1.57, 0, 0, 0, 0, 0, 1e-3, 1e-3}, /* all but flat */
    {-1.5707963, 0, 0, 0, 0, -1, 1e-8, 0.5},
    {FLATTEST, 0, 0, 0, 0, 0, 0, 0},
    {-FLATTEST, 0, 0, 0, 0, 0, 0, 0},
    {FLATTEST, 0, 0, 0, 0, -1, 1e-16, 1},
    {1e-300, 0, 0, 0, 0, 1e-300, 1e-300, 1e-300},
    {5e-324, 5e-324, 5e-324, 0, 0, 0, 0, 0},
    {0, 0, 0, 0, 0, 1e-40, 1e-40, 1e-40},
    {0.2, 0, 0, 0, 0, 1e-310, 0, 1e-310},
    {0.2, 0, 0, 0, 0, 1e3, 1e3, -1e3},  /* as fast as floats may be */
    {0.2, 0, 0, 0, 0, 1e6, 1e6, -1e6},  /* as fast as doubles may be */
    {0.2, 0, 0, 0, 0, 0, 1e100, 1e100}, /* absurd */
};
enum { STATES = sizeof states / sizeof *states };

/* Ordinary ones first; then units far from 1, for doubles and for floats, and
 * mass far from the rim. */
static size_t bodies(coin_params *p)
{
    check_status(coin_params_disc(&p[0], 1, 1, 1), COIN_OK);
    check_status(coin_params_disc(&p[1], 0.00567, 0.01213, 9.80665), COIN_OK);
    check_status(coin_params_ring(&p[2], 1, 1, 1, 1), COIN_OK);
    check_status(coin_params_disc(&p[3], 1e-15, 1e15, 1e-15), COIN_OK);
    check_status(coin_params_disc(&p[4], 1e15, 1e-15, 1e15), COIN_OK);
    check_status(coin_params_disc(&p[5], 1e-8, 1e8, 1e-8), COIN_OK);
    check_status(coin_params_disc(&p[6], 1e8, 1e-8, 1e8), COIN_OK);
    check_status(coin_params_body(&p[7], 1, 1, 1, 500, 1), COIN_OK);
    check_status(coin_params_body(&p[8], 1, 1, 1, 1.001e-3, 2e-3), COIN_OK);
    return 9;
}

static const double steps[] = {0.01, 0, -0.0, -0.01, 5e-324, 1e-300, 0.3, 1e9};
enum { STEPS = sizeof steps / sizeof *steps };

static struct trap_case case_of(const coin_params *p, const double of[8],
                                size_t i)
{
    const double a = p->radius, T = natural_time(p);
    static const double mu[] = {0.3, 0, (double)INFINITY};
    const coin_state s = {of[0],     of[1],     of[2],     a * of[3],
                          a * of[4], of[5] / T, of[6] / T, of[7] / T};
    struct trap_case c = {.p = *p, .s = s};
    c.dt = steps[i % STEPS] * T;
    c.t = 100 * c.dt;
    c.mu = mu[i % 3];
    return c;
}

static size_t cases(struct trap_case *c)
{
    coin_params p[9];
    const size_t of_body = bodies(p);
    size_t n = 0;
    for (size_t i = 0; i < STATES; ++i)
        for (size_t k = 0; k < of_body; ++k)
            for (size_t step = 0; step < (k ? 1 : 3); ++step, ++n)
                c[n] = case_of(&p[k], states[i], n + 3 * step);
    struct random r = random_begin(31);
    const int more = tries_asked(RANDOM_CASES);
    check(n + (size_t)more <= MAX_CASES);
    for (int i = 0; i < more; ++i, ++n) {
        const coin_params q = random_coin(&r);
        c[n] = case_of(&q, states[0], (size_t)i);
        c[n].s = random_state(&r, &q, i % 2 ? 1.57 : 1);
    }
    for (size_t i = 0; i < n; ++i) {
        c[i].index = i;
        c[i].fp = floats_params(&c[i].p);
        c[i].fs = floats_state(&c[i].s);
        c[i].fdt = (float)c[i].dt;
        c[i].fmu = (float)c[i].mu;
    }
    return n;
}

/* What was asked for is not to be had: coin.h promises nothing then. */
static int is_refusal(int32_t status)
{
    return status == COIN_EARG || status == COIN_EPARAMS ||
           status == COIN_ESTATE || status == COIN_ESTEP ||
           status == COIN_ERANGE;
}

/* 1 if the call was not refused. */
static int called(const struct trap_function *f, const struct trap_case *c)
{
    feclearexcept(FE_ALL_EXCEPT);
    const int32_t status = f->call(c);
    const int raised = fetestexcept(TRAPPED);
    if (is_refusal(status))
        return 0;
    check_note("%s: theta %a, wX %a, wY %a, wZ %a, dt %a", f->name, c->s.theta,
               c->s.wX, c->s.wY, c->s.wZ, c->dt);
    check(!raised);
#ifdef __GLIBC__
    if (feenableexcept(TRAPPED) == -1)
        return 1; /* this processor has no traps */
    const int32_t again = f->call(c);
    fedisableexcept(TRAPPED);
    check_status(again, status);
#endif
    return 1;
}

void traps_run(void)
{
    static struct trap_case c[MAX_CASES];
    const size_t n = cases(c);
    for (size_t i = 0; i < count; ++i) {
        size_t succeeded = 0;
        for (size_t k = 0; k < n; ++k)
            succeeded += (size_t)called(&functions[i], &c[k]);
        check_note("%s: succeeded %zu times", functions[i].name, succeeded);
        check(succeeded >= 10);
    }
}

void traps_are_complete(void)
{
    char line[128], name[128];
    size_t symbols = 0;
    FILE *map = fopen(TEST_ROOT "/lib/about/rollcoin.map", "r");
    check(map != NULL);
    while (fgets(line, sizeof line, map)) {
        size_t rows = 0;
        if (sscanf(line, " coin%100[a-z0-9_];", name) != 1)
            continue;
        for (size_t i = 0; i < count; ++i)
            rows += strncmp(functions[i].name + 4, name, strlen(name)) == 0;
        check_note("coin%s", name);
        check(rows > 0);
        ++symbols;
    }
    fclose(map);
    check(symbols > 0);
}
