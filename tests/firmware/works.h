/* SPDX-License-Identifier: MIT */
/* What is counted of the library on other processors: a quarter at steps of
 * 1 ms, by each of some functions, and how deep their stack goes. */
#ifndef WORKS_H
#define WORKS_H

#include <coinf.h>

/* n steps, or as many checks. */
typedef void work(uint32_t n);

static coinf_params quarter_f;
static coin_params quarter;
static coin_table table;

static void begin_f(coinf_state *s)
{
    const coinf_state start = {0.3f, 0, 0, 0, 0, 0, 5, 40, {0}};
    *s = start;
}

static void begin(coin_state *s)
{
    const coin_state start = {0.3, 0, 0, 0, 0, 0, 5, 40};
    *s = start;
}

static int failed;

static void float_steps(uint32_t n)
{
    coinf_state s;
    begin_f(&s);
    while (n-- > 0)
        failed |= coinf_step(&s, &quarter_f, 1e-3f) != COIN_OK;
}

static void float_run(uint32_t n)
{
    coinf_state s;
    begin_f(&s);
    failed |= coinf_run(&s, &quarter_f, COIN_RK4, 1e-3f, n, 0) != COIN_OK;
}

static void float_checks(uint32_t n)
{
    coinf_state s;
    begin_f(&s);
    while (n-- > 0)
        failed |= coinf_check(&s, &quarter_f, COIN_RK4, 1e-3f, 1) != COIN_OK;
}

static void double_steps(uint32_t n)
{
    coin_state s;
    begin(&s);
    while (n-- > 0)
        failed |= coin_step(&s, &quarter, 1e-3) != COIN_OK;
}

static void double_run(uint32_t n)
{
    coin_state s;
    begin(&s);
    failed |= coin_run(&s, &quarter, COIN_RK4, 1e-3, n, 0) != COIN_OK;
}

/* Calls of 1 ms at the tolerance of a game. */
static void settles(uint32_t n)
{
    coin_state s;
    begin(&s);
    while (n-- > 0)
        failed |=
            coin_settle(&s, &quarter, &table.losses, 1e-3, 1e-3, 0) != COIN_OK;
}

static void moves(uint32_t n)
{
    coin_state s;
    coin_body b;
    begin(&s);
    failed |= coin_body_from_state(&b, &s, &quarter) != COIN_OK;
    while (n-- > 0)
        failed |= coin_move(&b, &quarter, &table, 1e-3, 1e-3, 0, 0) != COIN_OK;
}

static void prepare_works(void)
{
    coinf_params_disc(&quarter_f, 0.00567f, 0.01213f, 9.80665f);
    coin_params_disc(&quarter, 0.00567, 0.01213, 9.80665);
    table.mu_static = 0.4;
    table.mu_kinetic = 0.3;
    table.losses.dry = 1e-6;
}

static const struct {
    const char *name;
    work *does;
} works[] = {
    {"coinf_step", float_steps},   {"coinf_run", float_run},
    {"coinf_check", float_checks}, {"coin_step", double_steps},
    {"coin_run", double_run},      {"coin_settle", settles},
    {"coin_move", moves},
};
enum { WORKS = sizeof works / sizeof *works };

/* Bytes of stack below this call that are no longer as they were painted. */
enum { PAINTED = 8192 };

__attribute__((noinline)) static uint32_t paint(int look)
{
    volatile uint32_t below[PAINTED / 4];
    uint32_t i;
    if (!look)
        for (i = 0; i < PAINTED / 4; ++i)
            below[i] = 0x5a5aa5a5;
    for (i = 0; i < PAINTED / 4 && below[i] == 0x5a5aa5a5; ++i)
        ;
    return PAINTED - 4 * i;
}

static uint32_t depth(work *does)
{
    paint(0);
    does(1);
    return paint(1);
}

#endif
