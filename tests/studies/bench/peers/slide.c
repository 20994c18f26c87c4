/* SPDX-License-Identifier: MIT */
/* Coins that slip: coin_move() beside friction regularised, by CVODE (BDF), and
 * beside time stepping, as CSV.
 *
 * Each rival is run with every delta and tolerance, or step, of a grid; its
 * rows are those which no other of its runs beats in error and time; step is a
 * tolerance where the method has one.
 *
 * An error is the largest of theta, phi, psi, x and z at eight times.  Natural
 * units; textbook_steps is the least time of many runs over that of a step of
 * textbook.h. */
#include "../clock.h"
#include "../sliding.h"
#include "../textbook.h"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

enum { ENDS = 8, ROWS = 4096 };

/* Windows of a run whose time is looked for [s]. */
#define BUSY 0.03

/* A larger error is none of interest. */
#define WORST 0.5

struct slide_scene {
    const char *name;
    double b; /* the ring's inner radius */
    double mu_static, mu_kinetic;
    double t;
    coin_state s;
    double vX, vh; /* NAN: it rolls */
};

static const struct slide_scene scenes[] = {
    /* It slides, curves, and begins to roll. */
    {"thrown", 0, 0.3, 0.27, 8, {.theta = 0.2, .wY = 0.3, .wZ = -0.2}, 1, .4},
    {"tumble", 0, 0.55, 0.5, 15, {.theta = 1e-3, .wZ = 0.3}, NAN, 0},
    /* Its slip nearly ends, and does not. */
    {"ring", 0.5, 0.375, 0.375, 7, {.theta = .15, .wY = .3, .wZ = 1.25}, 1, .1},
};

static struct {
    const struct slide_scene *scene;
    coin_params p;
    coin_table table;
    coin_body start;
    coin_state truth[ENDS];
    double step_ns; /* of the textbook */
} at;

/* A run, and what came out. */
struct run {
    double delta, step, error, seconds;
};

typedef double run_to_ends(const struct run *r, int ends);

static double end_of(int k)
{
    return at.scene->t * (k + 1) / ENDS;
}

static double apart(const coin_state *a, const coin_state *b)
{
    const double d[] = {a->theta - b->theta, a->phi - b->phi, a->psi - b->psi,
                        a->x - b->x, a->z - b->z};
    double most = 0;
    for (int i = 0; i < 5; ++i)
        most = d[i] == d[i] ? fmax(most, fabs(d[i])) : INFINITY;
    return most;
}

/* -------------------------------------------------------------- the methods */
/* Each moves from the start to the end and returns its error there; or, if
 * `ends`, the largest at all ends. */
static double located(const struct run *r, int ends)
{
    double error = 0;
    for (int k = ends ? 0 : ENDS - 1; k < ENDS; ++k) {
        coin_body d = at.start;
        if (coin_move(&d, &at.p, &at.table, end_of(k), r->step, 0, NULL) < 0)
            return INFINITY;
        error = fmax(error, apart(&d.s, &at.truth[k]));
    }
    return error;
}

static struct sliding rival(double delta)
{
    const coin_table *f = &at.table;
    const struct sliding of = {at.p.inertia_X, at.p.inertia_Z, f->mu_static,
                               f->mu_kinetic, delta};
    return of;
}

static double time_stepping(const struct run *r, int ends)
{
    const struct sliding of = rival(0);
    const long n = (long)ceil(end_of(0) / r->step);
    double y[SLIDING], error = 0;
    (void)ends;
    sliding_start(y, &at.start);
    for (int k = 0; k < ENDS; ++k) {
        sliding_stepping(y, &of, end_of(0) / (double)n, n);
        const coin_state s = sliding_state(y);
        error = fmax(error, apart(&s, &at.truth[k]));
    }
    return error;
}

static void must(int failed)
{
    if (failed) {
        fprintf(stderr, "cvode: set-up failed\n");
        exit(1);
    }
}

static int rates(double t, N_Vector y, N_Vector d, void *of)
{
    (void)t;
    sliding_slopes(N_VGetArrayPointer(d), N_VGetArrayPointer(y), of);
    return 0;
}

static struct {
    void *cvode;
    N_Vector y;
    struct sliding of;
} bdf;

static void set_up(void)
{
    SUNContext context;
    must(SUNContext_Create(NULL, &context));
    bdf.y = N_VNew_Serial(SLIDING, context);
    bdf.cvode = CVodeCreate(CV_BDF, context);
    sliding_start(N_VGetArrayPointer(bdf.y), &at.start);
    must(!bdf.y || !bdf.cvode || CVodeInit(bdf.cvode, rates, 0, bdf.y));
    must(CVodeSetUserData(bdf.cvode, &bdf.of));
    must(CVodeSetMaxNumSteps(bdf.cvode, 20000)); /* in an eighth */
    SUNMatrix A = SUNDenseMatrix(SLIDING, SLIDING, context);
    must(
        CVodeSetLinearSolver(bdf.cvode, SUNLinSol_Dense(bdf.y, A, context), A));
    must(CVodeSetErrFile(bdf.cvode, NULL));
}

static double by_bdf(const struct run *r, int ends)
{
    double t, error = 0;
    if (!bdf.cvode)
        set_up();
    bdf.of = rival(r->delta);
    sliding_start(N_VGetArrayPointer(bdf.y), &at.start);
    must(CVodeReInit(bdf.cvode, 0, bdf.y));
    must(CVodeSStolerances(bdf.cvode, r->step, r->step));
    for (int k = ends ? 0 : ENDS - 1; k < ENDS; ++k) {
        if (CVode(bdf.cvode, end_of(k), bdf.y, &t, CV_NORMAL) < 0)
            return INFINITY;
        const coin_state s = sliding_state(N_VGetArrayPointer(bdf.y));
        error = fmax(error, apart(&s, &at.truth[k]));
    }
    return error;
}

/* ---------------------------------------------------------------- measuring */
/* The least time of a run to the end; what it comes to is used. */
static double least_time(const struct run *r, run_to_ends *go)
{
    const double tare = clock_cost(), begin = clock_ns();
    double least = INFINITY;
    volatile double used;
    do {
        const double from = clock_ns();
        used = go(r, 0);
        least = fmin(least, 1e-9 * (clock_ns() - from - tare));
    } while (clock_ns() - begin < 1e9 * BUSY);
    (void)used;
    return least;
}

static int compare(const void *a, const void *b)
{
    const double d =
        ((const struct run *)a)->seconds - ((const struct run *)b)->seconds;
    return d < 0 ? -1 : d > 0;
}

/* A row has at most this part of the error of the row before. */
#define LESS_ERROR 0.8

/* Those that no other beats. */
static void print_best(const char *method, struct run *r, int n)
{
    double least = WORST;
    qsort(r, (size_t)n, sizeof *r, compare);
    for (int i = 0; i < n; ++i)
        if (r[i].error < LESS_ERROR * least) {
            least = r[i].error;
            printf("%s,%s,%.3g,%.3g,%.3g,%.3g\n", at.scene->name, method,
                   r[i].delta, r[i].step, least,
                   1e9 * r[i].seconds / at.step_ns);
        }
    fflush(stdout);
}

static struct run rows[ROWS];

static void sweep(const char *method, run_to_ends *go, int runs)
{
    for (int i = 0; i < runs; ++i) {
        rows[i].error = go(&rows[i], 1);
        rows[i].seconds =
            rows[i].error < WORST ? least_time(&rows[i], go) : INFINITY;
    }
    print_best(method, rows, runs);
}

/* delta is lessened by a factor of 10^(1/4) at a time. */
#define LESS 1.7782794100389228

static void sweep_all(void)
{
    int n = 0;
    for (; n <= 40; ++n) {
        rows[n].delta = 0;
        rows[n].step = fmax(1e-2 * pow(10, -n / 4.0), 1e-12);
    }
    sweep("located", located, n);
    n = 0;
    for (double delta = 0.1; delta > 9e-6; delta /= LESS)
        for (int i = 0; i <= 12; ++i, ++n) {
            rows[n].delta = delta;
            rows[n].step = 1e-2 * pow(10, -i / 2.0);
        }
    sweep("regularised BDF", by_bdf, n);
    n = 0;
    for (double h = 0.1; h > 3e-6; h /= LESS, ++n) {
        rows[n].delta = 0;
        rows[n].step = h;
    }
    sweep("time stepping", time_stepping, n);
}

static void begin(const struct slide_scene *scene)
{
    at.scene = scene;
    coin_params_ring(&at.p, 1, 1, scene->b, 1);
    at.table.mu_static = scene->mu_static;
    at.table.mu_kinetic = scene->mu_kinetic;
    coin_body_from_state(&at.start, &scene->s, &at.p);
    if (scene->vX == scene->vX) { /* phi is 0 */
        at.start.vx = scene->vX;
        at.start.vz = scene->vh;
    }
    for (int k = 0; k < ENDS; ++k) {
        coin_body d = at.start;
        coin_move(&d, &at.p, &at.table, end_of(k), 1e-12, 0, NULL);
        at.truth[k] = d.s;
    }
}

static void time_textbook(void)
{
    const coin_state start = {.theta = 0.2, .wY = 0.3, .wZ = 1};
    at.step_ns = INFINITY;
    for (int i = 0; i < 2000; ++i) {
        coin_state s = start;
        const double from = clock_ns();
        textbook_run(&s, &at.p, 1e-3, 400);
        at.step_ns = fmin(at.step_ns, (clock_ns() - from) / 400);
    }
}

int main(int argc, char **argv)
{
    setvbuf(stdout, NULL, _IOLBF, 0);
    puts("scene,method,delta,step,error,textbook_steps");
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; ++i) {
        if (argc > 1 && strcmp(argv[1], scenes[i].name) != 0)
            continue;
        begin(&scenes[i]);
        time_textbook();
        sweep_all();
    }
    return 0;
}
