/* SPDX-License-Identifier: MIT */
/* What calls cost, as programs make them.
 *     bench_costs BUILD    CSV: ns of each, all taking turns
 *     bench_costs count    each once, in a part of its own for callgrind */
#include "clock.h"
#include "scene.h"
#include "textbook.h"

#include <coinf.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <valgrind/callgrind.h>

/* What a window repeats; what a row is measured for [ns], and at least how
 * often. */
enum { CALLS = 1024, COINS = 64, FRAMES = 60, TOSSES = 50, LEAST_OFTEN = 3 };

#define PATIENCE 7e8

/* Along scene generic; the textbook's steps are so short that no angle grows
 * beyond the range in which the sines of glibc are cheapest. */
#define DT 0.05
#define FINE 1e-4

static coin_params generic, quarter, thick, disk;
static coinf_params single;
static coin_state start, along[COINS], coins[COINS], samples[CALLS], s;
static coinf_state sf, startf;
static coin_body b;
static coin_losses slows;
static coin_table rough, slippery;
static coin_orbit orbit;
static coin_force force;
static double sum;

/* ----------------------------------------------------------- steps, queries */
/* EACH(name, call): CALLS times a call, of the i-th coin if it asks for one. */
#define EACH(name, call)                                                       \
    static int name(void)                                                      \
    {                                                                          \
        int worst = 0;                                                         \
        for (int i = 0; i < CALLS; ++i)                                        \
            worst |= (call);                                                   \
        return worst < 0;                                                      \
    }
EACH(one_step, coin_step(&s, &generic, DT))
EACH(one_rk8, coin_run(&s, &generic, COIN_RK8, DT, 1, NULL))
EACH(one_single, coinf_step(&sf, &single, (float)DT))
EACH(reaction, coin_reaction(&along[i % COINS], &generic, &force))
EACH(check, coin_check(&along[i % COINS], &generic, COIN_RK4, DT, 1))
EACH(energy, (sum += coin_energy(&along[i % COINS], &generic)) < 0)
EACH(orbit_at, coin_orbit_at(&orbit, i * 0.1, &s))

/* ONCE(name, failed): what one call, or many by another function, comes to. */
#define ONCE(name, failed)                                                     \
    static int name(void)                                                      \
    {                                                                          \
        return failed;                                                         \
    }

static int run(int32_t method)
{
    return coin_run(&s, &generic, method, DT, CALLS, NULL) < 0;
}

ONCE(textbook, (textbook_run(&s, &generic, FINE, CALLS), 0))
ONCE(run_rk4, run(COIN_RK4))
ONCE(run_rk8, run(COIN_RK8))
ONCE(run_symplectic2, run(COIN_SYMPLECTIC2))
ONCE(run_symplectic4, run(COIN_SYMPLECTIC4))
ONCE(run_single, coinf_run(&sf, &single, COIN_RK4, (float)DT, CALLS, NULL) < 0)

static int batch(int32_t method, unsigned steps)
{
    return coin_batch_run(coins, COINS, &generic, method, DT, steps, NULL) < 0;
}

ONCE(batch_once, batch(COIN_RK4, 1))
ONCE(batch_rk4, batch(COIN_RK4, 64))
ONCE(batch_rk8, batch(COIN_RK8, 64))
ONCE(sample,
     coin_sample(&s, &generic, COIN_RK4, DT, 1, CALLS, samples, NULL) < 0)
ONCE(orbit_init, coin_orbit_init(&orbit, &start, &generic) < 0)

/* --------------------------------------------------- a second of a quarter */
static const coin_state rolls = {0.3, 0, 0, 0, 0, 0, 5, 40};

/* FRAMES calls, each of which has to tell the mode that is meant. */
static int advance(double tol)
{
    int worst = 0;
    s = rolls;
    for (int i = 0; i < FRAMES; ++i)
        worst |= coin_advance(&s, &quarter, 1.0 / 60, tol, NULL);
    return worst != COIN_OK;
}

ONCE(advance6, advance(1e-6))
ONCE(advance9, advance(1e-9))

static int move(const coin_params *p, const coin_table *table, double tol,
                int32_t mode, int frames)
{
    int other = 0;
    for (int i = 0; i < frames; ++i)
        other |= coin_move(&b, p, table, 1.0 / 60, tol, 0, NULL) != mode;
    return other;
}

static int move_rolls(const coin_params *p, double tol)
{
    return coin_body_from_state(&b, &rolls, p) < 0 ||
           move(p, &rough, tol, COIN_OK, FRAMES);
}

ONCE(move_rolls6, move_rolls(&quarter, 1e-6))
ONCE(move_rolls9, move_rolls(&quarter, 1e-9))
ONCE(move_thick6, move_rolls(&thick, 1e-6))
ONCE(move_thick9, move_rolls(&thick, 1e-9))

/* It slides at 2 m/s, spinning about the vertical: it rolls after 0.7 s. */
enum { SLIPS_FOR = 30 };

static int move_slips(void)
{
    const coin_state upright = {0.1, 0, 0, 0, 0, 0, 40, 0};
    coin_body_from_state(&b, &upright, &quarter);
    b.vx = 2;
    return move(&quarter, &slippery, 1e-6, COIN_SLIPS, SLIPS_FOR);
}

/* Thrown up at v m/s from y m, turning ten times a second or so. */
static void thrown(double y, double v)
{
    static const coin_body at_rest;
    b = at_rest;
    b.y = y;
    b.vx = 0.2;
    b.vy = v;
    b.s.theta = 0.9;
    b.s.wX = 60;
    b.s.wY = 4;
    b.s.wZ = 20;
}

static int move_flies(void)
{
    thrown(6, 0);
    return move(&quarter, &rough, 1e-6, COIN_LIFTS, FRAMES);
}

/* Of coins that come down at 1 m/s, a millimetre above the table. */
static int move_bounces(void)
{
    int other = 0;
    for (int i = 0; i < FRAMES; ++i) {
        thrown(0.001, -1);
        b.s.theta = 0.3 + 0.01 * i;
        b.s.wX = 1;
        b.y += quarter.radius * cos(b.s.theta);
        other |= move(&quarter, &rough, 1e-6, COIN_LIFTS, 1);
    }
    return other;
}

static int tosses(void)
{
    int failed = 0;
    coin_table table = rough;
    table.losses = slows;
    for (int i = 0; i < TOSSES; ++i) {
        thrown(0.3, 1 + 0.01 * i);
        failed |= coin_move(&b, &quarter, &table, INFINITY, 1e-6, 0, NULL) !=
                  COIN_RESTS;
    }
    return failed;
}

/* ---------------------------------------------------------------- to rest */
/* A quarter with its losses, in frames for a second. */
static int settle_frames(void)
{
    int worst = 0;
    s = rolls;
    for (int i = 0; i < FRAMES; ++i)
        worst |= coin_settle(&s, &quarter, &slows, 1.0 / 60, 1e-6, NULL);
    return worst != COIN_OK;
}

/* Spins at so many rad from flat, with a nudge, until it rests: dry losses. */
static int life(const coin_params *p, double dry, double angle)
{
    const coin_losses l = {.dry = dry * p->mass * p->gravity * p->radius};
    if (coin_steady_spin(&s, p, 1.5707963267948966 - angle) < 0)
        return 1;
    s.wX = 0.01 * angle * sqrt(p->gravity / p->radius);
    return coin_settle(&s, p, &l, INFINITY, 1e-9, NULL) != COIN_RESTS;
}

ONCE(life_of_quarter, life(&quarter, 8.5e-4, 0.5235987755982988))
ONCE(life_of_disk, life(&disk, 5.24e-5, 0.3054326190990077))

/* A row: what is called how often in a window.  The first is the unit. */
static const struct row {
    const char *name;
    int (*make)(void);
    int times;
} rows[] = {
    {"textbook RK4, a step", textbook, CALLS},
    {"coin_step", one_step, CALLS},
    {"coin_run, one step of RK8", one_rk8, CALLS},
    {"coin_run, a further step of RK4", run_rk4, CALLS},
    {"coin_run, a further step of RK8", run_rk8, CALLS},
    {"coin_run, a further step of symplectic2", run_symplectic2, CALLS},
    {"coin_run, a further step of symplectic4", run_symplectic4, CALLS},
    {"coin_sample, a sample of one step", sample, CALLS},
    {"coin_batch_run of 64 coins, one step of RK4, a coin", batch_once, COINS},
    {"coin_batch_run of 64 coins, 64 steps of RK4, a step", batch_rk4,
     64 * COINS},
    {"coin_batch_run of 64 coins, 64 steps of RK8, a step", batch_rk8,
     64 * COINS},
    {"coinf_step", one_single, CALLS},
    {"coinf_run, a further step of RK4", run_single, CALLS},
    {"coin_energy", energy, CALLS},
    {"coin_reaction", reaction, CALLS},
    {"coin_check", check, CALLS},
    {"coin_orbit_init", orbit_init, 1},
    {"coin_orbit_at", orbit_at, CALLS},
    {"coin_advance, a frame at 1e-6", advance6, FRAMES},
    {"coin_advance, a frame at 1e-9", advance9, FRAMES},
    {"coin_move, a frame that rolls at 1e-6", move_rolls6, FRAMES},
    {"coin_move, a frame that rolls at 1e-9", move_rolls9, FRAMES},
    {"coin_move, a frame that rolls at 1e-6, thick", move_thick6, FRAMES},
    {"coin_move, a frame that rolls at 1e-9, thick", move_thick9, FRAMES},
    {"coin_move, a frame that slips at 1e-6", move_slips, SLIPS_FOR},
    {"coin_move, a frame in the air", move_flies, FRAMES},
    {"coin_move, a frame with a bounce", move_bounces, FRAMES},
    {"coin_move, a toss from the hand to rest at 1e-6", tosses, TOSSES},
    {"coin_settle, a frame at 1e-6", settle_frames, FRAMES},
    {"coin_settle, a quarter to rest at 1e-9", life_of_quarter, 1},
    {"coin_settle, Euler's disk to rest at 1e-9", life_of_disk, 1},
};

enum { ROWS = sizeof rows / sizeof *rows };

static void prepare(void)
{
    const coin_state from = {0.5, 0, 0, 0, 0, 0.1, 0.8, 1.2};
    const coinf_state fromf = {(float)0.5, 0,          0,          0,  0,
                               (float)0.1, (float)0.8, (float)1.2, {0}};
    start = from;
    startf = fromf;
    coin_params_disc(&generic, 1, 1, 1);
    coinf_params_disc(&single, 1, 1, 1);
    coin_params_disc(&quarter, 0.00567, 0.01213, 9.80665);
    coin_params_cylinder(&thick, 0.00567, 0.01213, 1.75e-3, 9.80665);
    coin_params_disc(&disk, 0.438, 0.0375, 9.80665);
    rough =
        (coin_table){.mu_static = 0.6, .mu_kinetic = 0.5, .restitution = 0.5};
    slippery = (coin_table){.mu_static = 0.1, .mu_kinetic = 0.1};
    slows.dry = 2e-3 * quarter.mass * quarter.gravity * quarter.radius;
    if (coin_sample(&start, &generic, COIN_RK8, DT, 5, COINS, along, NULL) ||
        coin_orbit_init(&orbit, &start, &generic))
        exit(1);
}

/* Each window begins where the others do. */
static void rewind_coins(void)
{
    s = start;
    sf = startf;
    memcpy(coins, along, sizeof coins);
}

static void failure(const struct row *r)
{
    fprintf(stderr, "bench_costs: %s: not what it should measure\n", r->name);
    exit(1);
}

static double window(const struct row *r, double tare)
{
    rewind_coins();
    const double begin = clock_ns();
    if (r->make())
        failure(r);
    return clock_ns() - begin - tare;
}

/* All take turns, so that each sees the machine's quiet moments. */
static void measure(const char *build)
{
    const double tare = clock_cost();
    double least[ROWS], spent[ROWS] = {0};
    for (int round = 0, all_done = 0; !all_done; ++round) {
        all_done = 1;
        for (int k = 0; k < ROWS; ++k) {
            if (round >= LEAST_OFTEN && spent[k] > PATIENCE)
                continue;
            const double ns = window(&rows[k], tare);
            least[k] = round == 0 ? ns : fmin(least[k], ns);
            spent[k] += ns;
            all_done = 0;
        }
    }
    for (int k = 0; k < ROWS; ++k)
        printf("%s;%s;%.4g\n", build, rows[k].name, least[k] / rows[k].times);
}

static void count(void)
{
    for (int k = 0; k < ROWS; ++k) {
        rewind_coins();
        CALLGRIND_ZERO_STATS;
        const int failed = rows[k].make();
        CALLGRIND_DUMP_STATS_AT("row");
        if (failed)
            failure(&rows[k]);
        printf("%s;%d\n", rows[k].name, rows[k].times);
    }
}

int main(int argc, char **argv)
{
    prepare();
    if (argc > 1 && strcmp(argv[1], "count") == 0)
        count();
    else
        measure(argc > 1 ? argv[1] : "unnamed");
    return 0;
}
