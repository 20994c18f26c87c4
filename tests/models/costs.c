/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L

#include "costs.h"

#include "bench/clock.h"
#include "bench/textbook.h"
#include "support/check.h"

#include <stdio.h>
#include <stdlib.h>

enum { CALLS = 200, TURNS = 400 };

static coin_params disc;
static coin_state steady, start;
static coin_orbit orbit;

static double sink; /* so that no call is left out */

static void textbook(int k)
{
    coin_state s = start;
    textbook_run(&s, &disc, 0.02 + 1e-5 * k, 1);
    sink += s.x;
}

static void steady_at(int k)
{
    coin_state s;
    sink += coin_steady_at(&steady, &disc, 0.1 * k, &s) + s.x;
}

static void wobble_at(int k)
{
    coin_state s;
    sink += coin_wobble_at(&steady, &disc, &start, 0.1 * k, &s) + s.x;
}

static void orbit_at(int k)
{
    coin_state s;
    sink += coin_orbit_at(&orbit, 0.1 * k, &s) + s.x;
}

static void orbit_init(int k)
{
    coin_state s = start;
    s.wY += 1e-6 * k;
    sink += coin_orbit_init(&orbit, &s, &disc);
}

/* 100 steps at once, as a run takes them. */
static void full_run(int k)
{
    coin_state s = start;
    s.wY += 1e-6 * k;
    sink += coin_run(&s, &disc, COIN_RK8, 0.1, 100, NULL) + s.x;
}

static void steady_near(int k)
{
    coin_state s = start, near;
    s.wY += 1e-6 * k;
    sink += coin_steady_near(&s, &disc, &near) + near.theta;
}

/* The dearest answer: neither steady nor wobble, by a little. */
static void model_needed(int k)
{
    sink += coin_model_needed(&start, &disc, 30, 4e-4 + 1e-9 * k);
}

static const struct {
    const char *what;
    void (*call)(int k);
    int parts;
} things[] = {
    {"textbook step", textbook, 1},
    {"coin_steady_at", steady_at, 1},
    {"coin_wobble_at", wobble_at, 1},
    {"coin_orbit_at", orbit_at, 1},
    {"RK8 step of coin_run", full_run, 100},
    {"coin_steady_near", steady_near, 1},
    {"coin_orbit_init", orbit_init, 1},
    {"coin_model_needed", model_needed, 1},
};
enum { THINGS = sizeof things / sizeof *things };

int study_costs(void)
{
    double least[THINGS];
    check_status(coin_params_disc(&disc, 1, 1, 1), COIN_OK);
    check_status(coin_steady_circle(&steady, &disc, 0.4, 1, 1), COIN_OK);
    start = steady;
    start.theta += 1e-2;
    check_status(coin_orbit_init(&orbit, &start, &disc), COIN_OK);
    for (int turn = 0; turn < TURNS; ++turn)
        for (int i = 0; i < THINGS; ++i) {
            const int calls = i < 4 ? CALLS : 1;
            const double begun = clock_ns();
            for (int k = 0; k < calls; ++k)
                things[i].call(k + turn);
            const double took = (clock_ns() - begun) / calls / things[i].parts;
            if (turn == 0 || took < least[i])
                least[i] = took;
        }
    printf("what,ns,over_textbook_step\n");
    for (int i = 0; i < THINGS; ++i)
        printf("%s,%.0f,%.2f\n", things[i].what, least[i], least[i] / least[0]);
    return sink != sink ? EXIT_FAILURE : EXIT_SUCCESS;
}
