/* SPDX-License-Identifier: MIT */
/* What the tuned numbers of lib/ trade: calls and errors over random motions.
 *     tuning N [WHAT]      N motions of each kind, or of those in WHAT: slips,
 *                          light, losses, settle, rest, advance, thin, until,
 *                          orbit, falls
 * Change a number, run it again and compare.  An error is the distance from the
 * same call with a far smaller tol, over tol and over the time.  So it shows
 * what a change does; the tests compare with independent references.
 *
 * The linker puts a counter before each function that is counted (--wrap). */
#include "support/coins.h"
#include "support/losses.h"
#include "support/methods.h"
#include "support/slides.h"

#include "exact/orbit.h"
#include "step/extrapolation.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STEP, WITHIN, SLOPES, EXTRAPOLATE, COUNTED };
static double counted[COUNTED];

static const char *const names[COUNTED] = {
    "steps",
    "within",
    "slopes",
    "extrapolate",
};

/* ---------------------------------------------------------------- counters */
struct coin_priv_dop853;
struct coin_priv_law;
#define COUNT(which, type, back, name, params, args)                           \
    type __real_##name params;                                                 \
    type __wrap_##name params;                                                 \
    type __wrap_##name params                                                  \
    {                                                                          \
        ++counted[which];                                                      \
        back __real_##name args;                                               \
    }
COUNT(STEP, double, return, coin_priv_try_step,
      (struct coin_priv_dop853 * w, double h), (w, h))
COUNT(WITHIN, void, , coin_priv_within,
      (double *to, struct coin_priv_dop853 *w, double x), (to, w, x))
COUNT(SLOPES, void, , coin_priv_rates,
      (double *d, const double *y, const struct coin_priv_law *l, int mode),
      (d, y, l, mode))
COUNT(EXTRAPOLATE, int, return, coin_priv_extrapolate,
      (coin_priv_run * r, double tau, double *error), (r, tau, error))

/* ----------------------------------------------------------------- reports */
/* The errors of one kind of motion, and how many calls ended otherwise than
 * those of a small tol. */
struct errors {
    int n, other;
    double *at;
};

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double part(const struct errors *e, int percent)
{
    return e->n > 0 ? e->at[(e->n - 1) * percent / 100] : 0;
}

static void report(const char *what, double tol, struct errors *e)
{
    qsort(e->at, (size_t)e->n, sizeof *e->at, ascending);
    printf("%-8s %-6g %5d", what, tol, e->n);
    printf("  other %d  median %.2g, 90 %% %.2g, 99 %% %.2g, most %.2g ",
           e->other, part(e, 50), part(e, 90), part(e, 99), part(e, 100));
    for (int i = 0; i < COUNTED; ++i)
        if (counted[i] > 0)
            printf("  %s %.0f", names[i], counted[i]);
    printf("\n");
    memset(counted, 0, sizeof counted);
    e->n = e->other = 0;
}

/* A disc, or a ring, in natural units. */
static coin_params body(struct random *r, int i)
{
    coin_params p;
    coin_params_ring(&p, 1, 1, i % 2 ? 0 : random_between(r, 0, 1), 1);
    return p;
}

/* ----------------------------------------------------------------- motions */
enum { SLIPS, LIGHT, LOSSES, SETTLE, REST, ADVANCE, THIN, UNTIL, KINDS };

/* Its name, how long it is, and the tol that is small. */
static const struct kind {
    const char *name;
    double time, small;
} kinds[KINDS] = {
    {"slips", 3, 1e-12},  {"light", 3, 1e-12},   {"losses", 3, 1e-12},
    {"settle", 5, 1e-12}, {"rest", 1000, 1e-12}, {"advance", 10, 1e-13},
    {"thin", 10, 1e-13},  {"until", 10, 1e-12},
};

/* One of the motions: a body, what it starts from, and what slows it. */
struct motion {
    coin_params p;
    coin_table table;
    coin_body b;
    double reached;
};

static struct motion draw(struct random *r, int kind, int i)
{
    struct motion m = {.p = body(r, i), .reached = 0};
    const double small = pow(10, random_between(r, -3, 0));
    if (kind == LIGHT)
        coin_params_body(&m.p, 1, 1, 1, 0.5 * small,
                         small * random_between(r, 0.01, 1));
    if (kind == THIN)
        coin_params_body(&m.p, 1, 1, 1, 0.25, 0.5 * small);
    m.table.mu_kinetic = random_between(r, 0.05, 0.6);
    m.table.mu_static = m.table.mu_kinetic * random_between(r, 1, 2);
    if (kind >= LOSSES && kind <= REST)
        m.table.losses = random_losses(r, &m.p, 0.3);
    if (kind == LOSSES)
        m.table.losses.damping = 0;
    const coin_state s = random_state(r, &m.p, kind == UNTIL ? 1 : 1.4);
    if (kind <= LOSSES)
        m.b = random_launch(r, &m.p);
    else
        coin_body_from_state(&m.b, &s, &m.p);
    return m;
}

/* Moves it for its time, to rest, or until friction does not hold it. */
static int32_t go(struct motion *m, int kind, double tol)
{
    const double t = kinds[kind].time;
    const int32_t stop =
        kind == UNTIL ? COIN_SLIPS | COIN_LIFTS | COIN_NEARLY_FLAT : 0;
    if (kind == SETTLE || kind == REST)
        return coin_settle(&m->b.s, &m->p, &m->table.losses, t, tol,
                           &m->reached);
    if (kind == ADVANCE || kind == THIN)
        return coin_advance(&m->b.s, &m->p, t, tol, &m->reached);
    return coin_move(&m->b, &m->p, &m->table, t, tol, stop, &m->reached);
}

/* How far two are apart, per unit of time; of those that end by themselves also
 * in when they do. */
static double apart(const struct motion *a, const struct motion *b, int kind)
{
    const double late = fabs(a->reached - b->reached);
    if (kind == REST || kind == UNTIL)
        return late / fmax(b->reached, 1);
    if (kind <= LOSSES)
        return (slides_apart(&a->b, &b->b, &a->p) + late) / kinds[kind].time;
    return states_apart(&a->b.s, &b->b.s, &a->p) / kinds[kind].time;
}

/* Adds an error if both calls ended alike, and forgets what the call of a small
 * tol counted. */
static void motions(struct errors *e, int n, int kind, double tol)
{
    struct random r = random_begin(7);
    for (int i = 0; i < n; ++i) {
        struct motion m = draw(&r, kind, i), small = m;
        double before[COUNTED];
        const int32_t status = go(&m, kind, tol);
        memcpy(before, counted, sizeof before);
        const int32_t wanted = go(&small, kind, kinds[kind].small);
        memcpy(counted, before, sizeof counted);
        if (status == wanted && status >= 0)
            e->at[e->n++] = apart(&m, &small, kind) / tol;
        e->other += status != wanted;
    }
    report(kinds[kind].name, tol, e);
}

/* Orbits; of coins that start next to flat without falling if `falls`, whose
 * errors are not looked at.  The errors of the others are in units of 1e-13 per
 * unit. */
static void orbits(struct errors *e, int n, int falls)
{
    static coin_orbit o;
    struct random r = random_begin(13);
    double pieces = 0, most = 0;
    int refused = 0;
    for (int i = 0; i < n; ++i) {
        const coin_params p = body(&r, i);
        coin_state s = random_state(&r, &p, 1.4), at = s, small = s;
        if (falls) {
            s.theta = COIN_PRIV_HALF_PI - pow(10, random_between(&r, -7, -3));
            s.wX = 0;
            s.wY = 1e-7 * random_between(&r, -1, 1);
        }
        if (coin_orbit_init(&o, &s, &p) != COIN_OK) {
            ++refused;
            continue;
        }
        pieces += o.private_frame[COIN_PRIV_COUNT];
        most = fmax(most, o.private_frame[COIN_PRIV_COUNT]);
        if (falls)
            continue;
        coin_orbit_at(&o, 10, &at);
        coin_advance(&small, &p, 10, 1e-13, NULL);
        e->at[e->n++] = states_apart(&at, &small, &p) / 1e-12;
    }
    memset(counted, 0, sizeof counted);
    printf("refused %d, pieces %.0f, at most %.0f: ", refused, pieces, most);
    report(falls ? "falls" : "orbit", 1e-13, e);
}

int main(int argc, char **argv)
{
    const int n = argc > 1 ? atoi(argv[1]) : 500;
    const char *const what = argc > 2 ? argv[2] : "all";
    struct errors e = {0, 0, calloc((size_t)n + 1, sizeof(double))};
    if (!e.at || n < 1)
        return 1;
#define IS(name) (strcmp(what, "all") == 0 || strcmp(what, name) == 0)
    for (int k = 0; k < 3; ++k) {
        static const double tols[] = {1e-2, 1e-4, 1e-9};
        for (int kind = 0; kind < KINDS; ++kind)
            if (IS(kinds[kind].name))
                motions(&e, n, kind, tols[k]);
    }
    if (IS("orbit"))
        orbits(&e, n, 0);
    if (IS("falls"))
        orbits(&e, n, 1);
    free(e.at);
    return 0;
}
