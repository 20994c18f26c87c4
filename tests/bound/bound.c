/* SPDX-License-Identifier: MIT */
/* Calls whose instructions callgrind counts, each in a part of its own:
 *     KIND first      a call of one step, whatever becomes of it
 *     KIND further    64 steps more, of those that all are done
 *     advance N       a call of coin_advance()
 *     NAME call       a call of another function, that is not refused
 * bound.py reads the parts. */
#include "coins.h"
#include "functions.h"
#include "random.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <valgrind/callgrind.h>

enum { STATES = 1000, MORE = 64, KINDS = 4, SCENES = 100 };

static const char *const names[KINDS] = {
    "rk4",
    "rk8",
    "symplectic2",
    "symplectic4",
};

/* Any valid state: leaning by any power of ten from flat, rates from nothing
 * to a thousand, the pose at the end of its range now and then. */
static coin_state any_state(struct random *r, const coin_params *p)
{
    coin_state s = random_state(r, p, 1.57);
    const double fast = pow(10, random_between(r, -3, 3));
    if (random_between(r, 0, 1) < 0.3)
        s.theta = 1.5707963267948963 - pow(10, random_between(r, -15, 0));
    if (random_between(r, 0, 1) < 0.05)
        s.phi = 0x1p31 - random_between(r, 0, 300);
    s.wX *= fast;
    s.wY *= fast;
    s.wZ *= fast;
    return s;
}

static int32_t run(int kind, coin_state s, const coin_params *p, double dt,
                   uint64_t steps)
{
    CALLGRIND_TOGGLE_COLLECT;
    const int32_t status = coin_run(&s, p, kind, dt, steps, NULL);
    CALLGRIND_TOGGLE_COLLECT;
    return status;
}

static void part(const char *name, const char *what)
{
    char label[64];
    snprintf(label, sizeof label, "%s,%s", name, what);
    CALLGRIND_DUMP_STATS_AT(label);
}

/* Steps from a millionth of the fastest rate's time to beyond the limits. */
static void steps_of(int kind)
{
    struct random r = random_begin(1000 + (uint64_t)kind);
    for (int i = 0; i < STATES; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = any_state(&r, &p);
        const double dt =
            pow(10, random_between(&r, -6, 0.3)) / fastest_rate(&s, &p);
        run(kind, s, &p, dt, 1);
        part(names[kind], "first");
        const int32_t status = run(kind, s, &p, dt, 1 + MORE);
        part(names[kind], status < 0 ? "refused" : "all");
    }
}

static void landings(void)
{
    struct random r = random_begin(1010);
    for (int i = 0; i < STATES; ++i) {
        const coin_params p = random_coin(&r);
        coin_state s = any_state(&r, &p);
        const double t = random_between(&r, -9, 9) / fastest_rate(&s, &p);
        const double tol = pow(10, random_between(&r, -12, -3));
        CALLGRIND_TOGGLE_COLLECT;
        coin_advance(&s, &p, t, tol, NULL);
        CALLGRIND_TOGGLE_COLLECT;
        part("advance", "landed");
    }
}

/* A thick coin is asked on a slope. */
static void set_pull(union argument *a, const struct numbers *c)
{
    coin_table table;
    memcpy(&table, a, sizeof table);
    table.pull[0] = (c->mu - 0.5) * c->p.gravity;
    table.pull[1] = (0.5 - c->mu) * c->mu * c->p.gravity;
    memcpy(a, &table, sizeof table);
}

/* A call of a function about a scene; of coin_move() one of no time. */
static void call(const struct function *f, const struct numbers *c)
{
    static union argument memory[POINTERS];
    void *const a[] = {&memory[0], &memory[1], &memory[2], &memory[3],
                       &memory[4]};
    const int moves = strcmp(f->name, "coin_move") == 0;
    function_arguments(memory, f, &c->s, &c->p, c);
    const char *const table = strchr(f->kinds, 't');
    if (table && c->p.thickness > 0)
        set_pull(&memory[table - f->kinds], c);
    CALLGRIND_TOGGLE_COLLECT;
    const int32_t status =
        moves ? coin_move(a[0], a[1], a[2], 0, 1e-6, 0, NULL) : f->call(a, c);
    CALLGRIND_TOGGLE_COLLECT;
    part(f->name, status < 0 ? "refused" : "call");
}

/* Every function but those that move a state or fit losses: S, L.  A thick
 * coin is refused by most. */
static void calls(const struct numbers *c)
{
    for (size_t k = 0; k < function_count; ++k)
        if (!strpbrk(functions[k].kinds, "SL"))
            call(&functions[k], c);
}

/* The coins roll, slip or fly, on a table with losses or without; then with a
 * thickness, some of them upright on both rims. */
static void other_calls(void)
{
    struct random r = random_begin(1020);
    for (int i = 0; i < SCENES; ++i) {
        struct numbers c = {.p = random_coin(&r)};
        c.s = any_state(&r, &c.p);
        c.dt = random_between(&r, -0.3, 0.3) / fastest_rate(&c.s, &c.p);
        c.t = i % 10 ? 100 * c.dt * (i % 2 ? 1 : -1) : 0;
        c.mu = random_between(&r, 0, 1);
        calls(&c);
        c.p.thickness = c.p.radius * pow(10, random_between(&r, -3, 0.6));
        if (i % 10 == 3)
            c.s.theta = c.s.wX = 0;
        calls(&c);
    }
}

int main(void)
{
    for (int kind = 0; kind < KINDS; ++kind)
        steps_of(kind);
    landings();
    other_calls();
    return 0;
}
