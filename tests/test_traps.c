/* SPDX-License-Identifier: MIT */
/* The functions of coin.h and coinf.h with floating-point exceptions trapped: a
 * division by zero, an invalid operation or an overflow in a call that is not
 * refused fails. */
#define _GNU_SOURCE /* feenableexcept() */
#include "support/check.h"
#include "support/functions.h"
#include "support/random.h"

#include <fenv.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define TRAPPED (FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW)

enum { RANDOM_CASES = 20, MAX_CASES = 500 };

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

static struct numbers case_of(const coin_params *p, const double of[8],
                              size_t i)
{
    const double a = p->radius, T = natural_time(p);
    static const double mu[] = {0.3, 0, (double)INFINITY};
    const coin_state s = {of[0],     of[1],     of[2],     a * of[3],
                          a * of[4], of[5] / T, of[6] / T, of[7] / T};
    struct numbers c = {.p = *p, .s = s};
    c.dt = steps[i % STEPS] * T;
    c.t = 100 * c.dt;
    c.mu = mu[i % 3];
    return c;
}

static size_t cases(struct numbers *c)
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
    for (size_t i = 0; i < n; ++i)
        c[i].index = i;
    return n;
}

/* What was asked for is not to be had: coin.h promises nothing then. */
static int is_refusal(int32_t status)
{
    return status == COIN_EARG || status == COIN_EPARAMS ||
           status == COIN_ESTATE || status == COIN_ESTEP ||
           status == COIN_ERANGE || status == NOT_A_NUMBER;
}

/* Fills the stack below with signaling NaNs: arithmetic on one raises an
 * exception, so that a call which reads what it did not write is noticed. */
static void __attribute__((noinline)) paint(void)
{
    volatile uint64_t below[8192];
    for (size_t i = 0; i < sizeof below / sizeof *below; ++i)
        below[i] = UINT64_C(0x7ff4000000000001);
}

static int32_t call(const struct function *f, const struct numbers *c,
                    int trapped)
{
    (void)trapped;
    static union argument memory[POINTERS];
    void *const pointers[] = {&memory[0], &memory[1], &memory[2], &memory[3],
                              &memory[4]};
    function_arguments(memory, f, &c->s, &c->p, c);
    paint();
    feclearexcept(FE_ALL_EXCEPT);
#ifdef __GLIBC__
    if (trapped && feenableexcept(TRAPPED) == -1)
        trapped = 0; /* this processor has no traps */
#endif
    const int32_t status = f->call(pointers, c);
#ifdef __GLIBC__
    if (trapped)
        fedisableexcept(TRAPPED);
#endif
    return status;
}

/* 1 if the call was not refused. */
static int called(const struct function *f, const struct numbers *c)
{
    const int32_t status = call(f, c, 0);
    const int raised = fetestexcept(TRAPPED);
    if (is_refusal(status))
        return 0;
    check_note("%s: theta %a, wX %a, wY %a, wZ %a, dt %a", f->name, c->s.theta,
               c->s.wX, c->s.wY, c->s.wZ, c->dt);
    check(!raised);
    check_status(call(f, c, 1), status);
    return 1;
}

TEST(no_call_that_succeeds_traps)
{
    static struct numbers c[MAX_CASES];
    const size_t n = cases(c);
    for (size_t i = 0; i < function_count; ++i) {
        size_t succeeded = 0;
        for (size_t k = 0; k < n; ++k)
            succeeded += (size_t)called(&functions[i], &c[k]);
        check_note("%s: succeeded %zu times", functions[i].name, succeeded);
        check(succeeded >= 10);
    }
}

/* Each symbol of lib/about/rollcoin.map is called, or some whose names begin
 * with it. */
TEST(every_function_is_called)
{
    char line[128], name[128];
    size_t symbols = 0;
    FILE *map = fopen(TEST_ROOT "/lib/about/rollcoin.map", "r");
    check(map != NULL);
    while (fgets(line, sizeof line, map)) {
        size_t rows = 0;
        if (sscanf(line, " coin%100[a-z0-9_];", name) != 1)
            continue;
        for (size_t i = 0; i < function_count; ++i)
            rows += strncmp(functions[i].name + 4, name, strlen(name)) == 0;
        check_note("coin%s", name);
        check(rows > 0);
        ++symbols;
    }
    fclose(map);
    check(symbols > 0);
}
