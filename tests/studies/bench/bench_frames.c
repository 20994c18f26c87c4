/* SPDX-License-Identifier: MIT */
/* A frame loop: one call per frame moves a US quarter for a second.  What the
 * call costs, and how far the quarter is from where it should be.
 *     bench_frames          CSV */
#include "clock.h"
#include "scene.h"
#include "textbook.h"

#include <coinf.h>

#include <math.h>
#include <stdio.h>

enum { ROUNDS = 200 };

static scene c;
static coin_state s;
static coinf_state single;
static coinf_params body;
static coin_orbit orbit;
static coin_body real;
static coin_losses slows;
static double t;

/* BY(name, call): one frame of dt. */
#define BY(name, call)                                                         \
    static int by_##name(double dt)                                            \
    {                                                                          \
        return call;                                                           \
    }
BY(textbook, (textbook_run(&s, &c.p, dt, 1), 0))
BY(step, coin_step(&s, &c.p, dt))
BY(rk8, coin_run(&s, &c.p, COIN_RK8, dt, 1, NULL))
BY(advance6, coin_advance(&s, &c.p, dt, 1e-6, NULL))
BY(advance9, coin_advance(&s, &c.p, dt, 1e-9, NULL))
BY(orbit, coin_orbit_at(&orbit, t += dt, &s))
BY(single, coinf_step(&single, &body, (float)dt))
BY(settle, coin_settle(&s, &c.p, &slows, dt, 1e-6, NULL))

static int by_move(double dt)
{
    static const coin_table table = {.mu_static = 0.6, .mu_kinetic = 0.5};
    const int32_t status = coin_move(&real, &c.p, &table, dt, 1e-6, 0, NULL);
    s = real.s;
    return status;
}

/* The first is the yardstick. */
static const struct call {
    const char *name;
    int (*make)(double dt);
} calls[] = {
    {"textbook RK4", by_textbook},      {"coin_step", by_step},
    {"one step of RK8", by_rk8},        {"coin_advance 1e-6", by_advance6},
    {"coin_advance 1e-9", by_advance9}, {"coin_orbit_at", by_orbit},
    {"coinf_step", by_single},          {"coin_move 1e-6", by_move},
    {"coin_settle 1e-6", by_settle},
};

enum { CALLS = sizeof calls / sizeof *calls };

static const int rates[] = {60, 120, 240, 1000};

enum { RATES = sizeof rates / sizeof *rates };

static void begin(void)
{
    const coin_state *from = &c.row[0].s;
    const coinf_state start = {
        (float)from->theta, (float)from->phi, (float)from->psi,
        (float)from->x,     (float)from->z,   (float)from->wX,
        (float)from->wY,    (float)from->wZ,  {0},
    };
    s = *from;
    coin_body_from_state(&real, from, &c.p);
    single = start;
    t = 0;
}

/* A second of calls [ns per call]. */
static double second(const struct call *call, int rate, double tare)
{
    int worst = 0;
    begin();
    const double from = clock_ns();
    for (int i = 0; i < rate; ++i)
        worst |= call->make(1.0 / rate);
    const double ns = (clock_ns() - from - tare) / rate;
    return worst < 0 ? (double)NAN : ns;
}

/* After the second, which is the last row of the scene; with losses it is what
 * one call at the finest tolerance says. */
static double error_of(const struct call *call, int rate)
{
    coin_state truth = c.row[c.rows - 1].s;
    second(call, rate, 0);
    if (call->make == by_settle) {
        truth = c.row[0].s;
        coin_settle(&truth, &c.p, &slows, 1, 1e-12, NULL);
    }
    if (call->make == by_single) {
        const coinf_state *f = &single;
        const coin_state end = {f->theta, f->phi, f->psi, f->x,
                                f->z,     f->wX,  f->wY,  f->wZ};
        s = end;
    }
    return scene_error(&c, &s, &truth, 1);
}

static int prepare(void)
{
    scene_load(&c, "quarter", 1);
    const coin_params *p = &c.p;
    slows.dry = 2e-3 * p->mass * p->gravity * p->radius;
    return fabs(c.row[c.rows - 1].t - 1) < 1e-12 &&
           coin_orbit_init(&orbit, &c.row[0].s, p) >= 0 &&
           coinf_params_body(&body, (float)p->mass, (float)p->radius,
                             (float)p->gravity, (float)p->inertia_X,
                             (float)p->inertia_Z) == COIN_OK;
}

/* All take turns, so that each sees the machine's quiet moments. */
int main(void)
{
    static double least[RATES][CALLS];
    const double tare = clock_cost();
    if (!prepare())
        return 1;
    for (int i = 0; i < ROUNDS; ++i)
        for (int r = 0; r < RATES; ++r)
            for (int k = 0; k < CALLS; ++k) {
                const double ns = second(&calls[k], rates[r], tare);
                least[r][k] = i == 0 ? ns : fmin(least[r][k], ns);
            }
    for (int k = 0; k < CALLS; ++k)
        for (int r = 0; r < RATES; ++r)
            printf("%s,%d,%.4g,%.2g\n", calls[k].name, rates[r], least[r][k],
                   error_of(&calls[k], rates[r]));
    return 0;
}
