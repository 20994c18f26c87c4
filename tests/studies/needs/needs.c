/* SPDX-License-Identifier: MIT */
/* What each need of docs/choosing.md costs, and how far it errs: a line for
 * each way to meet it, NEED | CALL | PARTS | ERROR, and for each line a dump of
 * callgrind's counts of the work alone.  With an argument: the errors of fixed
 * steps.  From `make needs`. */
#include "support/coins.h"
#include "support/scene.h"
#include "support/thrown.h"

#include <coinf.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <valgrind/callgrind.h>

/* Counts what one statement executes, and nothing else. */
#define COUNTED(...)                                                           \
    do {                                                                       \
        CALLGRIND_ZERO_STATS;                                                  \
        __VA_ARGS__;                                                           \
        CALLGRIND_DUMP_STATS;                                                  \
    } while (0)

static void row(const char *need, const char *call, double parts, double error)
{
    printf("%s | %s | %.17g | %.1g\n", need, call, parts, error);
}

/* Of the angles, and of x and z in radii. */
static double apart(const coin_state *s, const coin_state *t, double radius)
{
    const double angles =
        fmax(fabs(s->theta - t->theta),
             fmax(fabs(s->phi - t->phi), fabs(s->psi - t->psi)));
    return fmax(angles, fmax(fabs(s->x - t->x), fabs(s->z - t->z)) / radius);
}

static int ascending(const void *a, const void *b)
{
    const double d = *(const double *)a - *(const double *)b;
    return (d > 0) - (d < 0);
}

static double nine_of_ten(double *errors, size_t n)
{
    qsort(errors, n, sizeof *errors, ascending);
    return errors[n * 9 / 10];
}

/* ---------------------------------------------------------- a US quarter */
static struct scene quarter;

/* The reference's last row, after 3.5 s. */
static double after_3_5(const coin_state *s)
{
    return scene_error(&quarter, quarter.rows.rows - 1, s);
}

/* Frames of dt, which move s. */
#define FRAMES(need, text, rate, call)                                         \
    do {                                                                       \
        const int n = (rate)*7 / 2;                                            \
        const double dt = 1.0 / (rate);                                        \
        coin_state s = scene_state(&quarter, 0);                               \
        COUNTED(for (int i = 0; i < n; ++i) call);                             \
        row(need, text, n, after_3_5(&s));                                     \
    } while (0)

static void step_checked(coin_state *s, double dt)
{
    coin_step(s, &quarter.params, dt);
    coin_check(s, &quarter.params, COIN_RK4, dt, 0.3);
}

static void by_rk8(coin_state *s, double dt)
{
    coin_run(s, &quarter.params, COIN_RK8, dt, 1, NULL);
}

static void frames_of_move(const char *need)
{
    const coin_table table = {.mu_static = 0.4, .mu_kinetic = 0.3};
    const coin_state start = scene_state(&quarter, 0);
    coin_body b;
    coin_body_from_state(&b, &start, &quarter.params);
    COUNTED(for (int i = 0; i < 210; ++i) coin_move(&b, &quarter.params, &table,
                                                    1.0 / 60, 1e-6, 0, NULL));
    row(need, "`coin_move` at 1e-6, a call per frame", 210, after_3_5(&b.s));
}

static void floats(const char *need)
{
    const coin_state start = scene_state(&quarter, 0);
    coinf_params p;
    coinf_state s = {(float)start.theta, 0,  0, 0, 0, 0, (float)start.wY,
                     (float)start.wZ,    {0}};
    double turns = 0, rolls = 0;
    coinf_params_disc(&p, 0.00567f, 0.01213f, 9.80665f);
    CALLGRIND_ZERO_STATS;
    for (int i = 0; i < 3500; ++i) {
        const double phi = s.phi;
        const double psi = s.psi;
        coinf_step(&s, &p, 1e-3f);
        turns += rint((phi - s.phi) / (2 * acos(-1)));
        rolls += rint((psi - s.psi) / (2 * acos(-1)));
    }
    CALLGRIND_DUMP_STATS;
    const coin_state end = {s.theta,
                            s.phi + 2 * acos(-1) * turns,
                            s.psi + 2 * acos(-1) * rolls,
                            s.x,
                            s.z,
                            0,
                            0,
                            0};
    row(need, "`coinf_step` every ms", 3500, after_3_5(&end));
}

static void one_call(const char *need, double tol, const char *call)
{
    coin_state s = scene_state(&quarter, 0);
    COUNTED(coin_advance(&s, &quarter.params, 3.5, tol, NULL));
    row(need, call, 3.5 / natural_time(&quarter.params), after_3_5(&s));
}

/* ------------------------------------------------------------- an exhibit */
/* Rows 6 and 7 of orbits.csv: the quarter after 35 s, and after 9.8 hours. */
static void exhibit(const char *need)
{
    static struct table t;
    static coin_orbit o;
    const coin_state start = scene_state(&quarter, 0);
    const double a = quarter.params.radius;
    table_load(&t, "orbits.csv");
    size_t last = 0;
    while (table_at(&t, last, "scene") != 3)
        ++last;
    const coin_state soon = state_in_row(&t, last);
    const coin_state late = state_in_row(&t, last + 1);
    const double t_soon = table_at(&t, last, "t");
    const double t_late = table_at(&t, last + 1, "t");
    coin_state s = start;
    COUNTED(for (int i = 0; i < 2110; ++i) by_rk8(&s, t_soon / 2110));
    row(need, "`coin_run`, one step of `COIN_RK8` per frame, 35 s", 2110,
        apart(&s, &soon, a));
    s = start;
    COUNTED(for (int i = 0; i < 2110; ++i)
                coin_advance(&s, &quarter.params, t_soon / 2110, 1e-9, NULL));
    row(need, "`coin_advance` at 1e-9, a call per frame, 35 s", 2110,
        apart(&s, &soon, a));
    COUNTED(coin_orbit_init(&o, &start, &quarter.params));
    row(need, "`coin_orbit_init`, once", 1, NAN);
    COUNTED(for (int i = 0; i <= 1000; ++i)
                coin_orbit_at(&o, t_late * i / 1000, &s));
    row(need, "`coin_orbit_at` per frame, 9.8 hours", 1001,
        apart(&s, &late, a));
}

/* --------------------------------------------------------- Euler's disk */
static void disk(const char *need)
{
    coin_params p;
    coin_losses l = {0};
    coin_state start;
    double truth, when;
    coin_params_disc(&p, 0.438, 0.0375, 9.80665);
    l.dry = 5.24e-5 * p.mass * p.gravity * p.radius;
    coin_steady_spin(&start, &p, 1.26536);
    coin_state s = start;
    coin_settle(&s, &p, &l, INFINITY, 1e-12, &truth);
    for (int k = 0; k < 2; ++k) {
        s = start;
        COUNTED(coin_settle(&s, &p, &l, INFINITY, k ? 1e-9 : 1e-6, &when));
        row(need,
            k ? "`coin_settle` at 1e-9, a whole life"
              : "`coin_settle` at 1e-6, a whole life",
            1, fabs(when - truth) / truth);
    }
    int calls = 0;
    double sum = 0, moved;
    s = start;
    COUNTED(while (coin_settle(&s, &p, &l, 1.0 / 60, 1e-6, &moved) == COIN_OK) {
        ++calls;
        sum += moved;
    });
    row(need, "`coin_settle` at 1e-6, a call per frame", calls + 1,
        fabs(sum + moved - truth) / truth);
    COUNTED(when = coin_time_to_rest(&start, &p, &l, 1e-6));
    row(need, "`coin_time_to_rest` at 1e-6", 1, fabs(when - truth) / truth);
}

/* ----------------------------------------------------------------- a toss */
enum { TOSSES = 100 };

static void toss(const char *need)
{
    static struct table t;
    static coin_body b[TOSSES];
    static coin_params p[TOSSES];
    static coin_table on[TOSSES];
    double errors[TOSSES];
    size_t n = 0;
    table_load(&t, "toss/tosses.csv");
    for (; n < t.rows && n < TOSSES; ++n) {
        p[n] = thrown_params(table_at(&t, n, "I_X"), table_at(&t, n, "I_Z"));
        on[n].mu_static = table_at(&t, n, "mu_static");
        on[n].mu_kinetic = table_at(&t, n, "mu_kinetic");
        on[n].restitution = table_at(&t, n, "e");
        b[n] = body_in_row(&t, n, "");
        errors[n] = table_at(&t, n, "t_end");
    }
    COUNTED(for (size_t i = 0; i < n; ++i)
                coin_move(&b[i], &p[i], &on[i], errors[i], 1e-6, 0, NULL));
    for (size_t i = 0; i < n; ++i) {
        const coin_body end = body_in_row(&t, i, "1");
        errors[i] = bodies_apart(&b[i], &end);
    }
    row(need, "`coin_move` at 1e-6, three bounces", (double)n,
        nine_of_ten(errors, n));
}

/* ---------------------------------------------------------------- a sweep */
enum { COINS = 1000 };

static void launch(coin_state *s, int i)
{
    const double turn = 2 * acos(-1) * (i * 0.618033988749895);
    const coin_state let_go = {.theta = 1.4 * (i + 0.5) / COINS,
                               .wY = 1.2 * sin(turn),
                               .wZ = 1.2 * cos(turn)};
    *s = let_go;
}

static void sweep(const char *need)
{
    static coin_state truth[COINS];
    static coin_state s[COINS];
    static int32_t status[COINS];
    double errors[COINS];
    const coin_params p = disc();
    for (int i = 0; i < COINS; ++i) {
        launch(&s[i], i);
        truth[i] = s[i];
        coin_advance(&truth[i], &p, 24, 1e-13, NULL);
    }
    COUNTED(coin_batch_run(s, COINS, &p, COIN_RK8, 0.1, 240, status));
    size_t kept = 0;
    for (int i = 0; i < COINS; ++i)
        if (status[i] >= 0)
            errors[kept++] = apart(&s[i], &truth[i], 1);
    row(need, "`coin_batch_run`, 240 steps of `COIN_RK8`", COINS,
        nine_of_ten(errors, kept));
    for (int i = 0; i < COINS; ++i)
        launch(&s[i], i);
    COUNTED(for (int i = 0; i < COINS; ++i)
                coin_advance(&s[i], &p, 24, 1e-6, NULL));
    for (int i = 0; i < COINS; ++i)
        errors[i] = apart(&s[i], &truth[i], 1);
    row(need, "`coin_advance` at 1e-6, each coin", COINS,
        nine_of_ten(errors, COINS));
}

/* ----------------------------------------------------------------- energy */
static void energy(const char *need)
{
    const coin_params p = disc();
    const coin_state start = {.theta = 0.5, .wX = 0.1, .wY = 0.8, .wZ = 1.2};
    const double E = coin_energy(&start, &p);
    coin_state s = start;
    COUNTED(coin_run(&s, &p, COIN_SYMPLECTIC4, 0.1, 100000, NULL));
    row(need, "`coin_run` by `COIN_SYMPLECTIC4`, steps of 0.1", 1e4,
        fabs(coin_energy(&s, &p) / E - 1));
    s = start;
    COUNTED(coin_advance(&s, &p, 1e4, 1e-6, NULL));
    row(need, "`coin_advance` at 1e-6", 1e4, fabs(coin_energy(&s, &p) / E - 1));
}

/* ------------------------------------------------------------------ circle */
static void steady(const char *need)
{
    struct scene circle;
    scene_load(&circle, "circle");
    const size_t last = circle.rows.rows - 1;
    const coin_state start = scene_state(&circle, 0);
    const double t = scene_at(&circle, last, "t");
    coin_state s = start;
    COUNTED(coin_steady_at(&start, &circle.params, t, &s));
    row(need, "`coin_steady_at`", 1, scene_error(&circle, last, &s));
}

/* ----------------------------------------------------------- fixed steps */
enum { MOTIONS = 1000 };

/* A random ring that keeps away from flat, for 4 natural units of time. */
struct motion {
    coin_params p;
    coin_state start, end;
    double time, W; /* W at its largest */
};

static struct motion motions[MOTIONS];

static void make_motions(void)
{
    struct random r = random_begin(7);
    for (int i = 0; i < MOTIONS; ++i) {
        struct motion *m = &motions[i];
        m->p = random_coin(&r);
        m->start = m->end = random_motion(&r, &m->p, 0.02, 200);
        m->time = 4 * natural_time(&m->p);
        m->W = fastest_ahead(&m->start, &m->p, m->time);
        coin_advance(&m->end, &m->p, m->time, 1e-13, NULL);
    }
}

/* Per natural unit, in 9 of 10 motions and at worst; nothing if a step is
 * refused. */
static void errors_of_steps(int32_t method, double h)
{
    double errors[MOTIONS];
    for (int i = 0; i < MOTIONS; ++i) {
        const struct motion *m = &motions[i];
        const double n = ceil(m->time * m->W / h);
        coin_state s = m->start;
        if (coin_run(&s, &m->p, method, m->time / n, (uint64_t)n, NULL) < 0) {
            printf(" | |");
            return;
        }
        errors[i] = apart(&s, &m->end, m->p.radius) / 4;
    }
    const double most = nine_of_ten(errors, MOTIONS);
    printf(" %.0e | %.0e |", most, errors[MOTIONS - 1]);
}

static void steps(void)
{
    const double h[] = {0.05, 0.1, 0.2, 0.35, 0.7, 1, 1.2};
    make_motions();
    for (size_t k = 0; k < sizeof h / sizeof *h; ++k) {
        printf("| %g |", h[k]);
        for (int32_t method = COIN_RK4; method <= COIN_SYMPLECTIC4; ++method)
            errors_of_steps(method, h[k]);
        printf("\n");
    }
}

int main(int argc, char **argv)
{
    (void)argv;
    if (argc > 1) {
        steps();
        return 0;
    }
    scene_load(&quarter, "quarter");
    const char *need = "a prop in a game: a US quarter, 60 frames a second, "
                       "after 3.5 s";
    FRAMES(need, "`coin_run`, one step of `COIN_RK8` per frame", 60,
           by_rk8(&s, dt));
    FRAMES(need, "`coin_advance` at 1e-6, a call per frame", 60,
           coin_advance(&s, &quarter.params, dt, 1e-6, NULL));
    frames_of_move(need);
    toss("a coin toss, to its third bounce");
    disk("Euler's disk, to rest; error: part of the time of rest");
    exhibit("an exhibit that rolls for hours");
    steady("a steady circle");
    need = "a controller at 1 kHz, after 3.5 s";
    FRAMES(need, "`coin_step` every ms", 1000,
           coin_step(&s, &quarter.params, dt));
    FRAMES(need, "`coin_step` and `coin_check` every ms", 1000,
           step_checked(&s, dt));
    floats("firmware without doubles, after 3.5 s");
    sweep("a sweep: launches of 24 natural units, of each coin");
    need = "a figure in a paper, per natural unit of time";
    one_call(need, 1e-9, "`coin_advance` at 1e-9");
    one_call(need, 1e-12, "`coin_advance` at 1e-12");
    energy("an energy that must not drift; cost of a natural unit, error: "
           "part of the energy after 1e4");
    return 0;
}
