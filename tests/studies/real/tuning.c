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
      (double *d, const double *y, const struct coin_priv_law *l, int mode,
       int in_t),
      (d, y, l, mode, in_t))
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

/* Adds an error if both calls ended alike, and forgets what was counted since
 * `before`: the calls of a small tol. */
static void note(struct errors *e, const double *before, int32_t status,
                 int32_t wanted, double error)
{
    memcpy(counted, before, sizeof counted);
    if (status == wanted && status >= 0)
        e->at[e->n++] = error;
    e->other += status != wanted;
}

/* A disc, or a ring, in natural units. */
static coin_params body(struct random *r, int i)
{
    coin_params p;
    coin_params_ring(&p, 1, 1, i % 2 ? 0 : random_between(r, 0, 1), 1);
    return p;
}

/* ----------------------------------------------------------------- motions */
enum { SLIPS, LIGHT, LOSSES };

/* Coins that slip, for 3 units. */
static void slips(struct errors *e, int n, int kind, double tol)
{
    static const char *const kinds[] = {"slips", "light", "losses"};
    struct random r = random_begin(7);
    for (int i = 0; i < n; ++i) {
        coin_params p = body(&r, i);
        double before[COUNTED], a = 0, b = 0;
        if (kind == LIGHT) {
            const double IX = 0.5 * pow(10, random_between(&r, -2.6, 0));
            coin_params_body(&p, 1, 1, 1, IX,
                             2 * IX * random_between(&r, 0.01, 1));
        }
        coin_losses l = random_losses(&r, &p, 0.3);
        const double mu = random_between(&r, 0.05, 0.6);
        coin_table f = {.mu_static = mu,
                        .mu_kinetic = mu * random_between(&r, 0.5, 1)};
        if (kind == LOSSES)
            f.losses = l;
        f.losses.damping = 0;
        coin_body d = random_launch(&r, &p), small = d;
        const int32_t status = coin_move(&d, &p, &f, 3, tol, 0, &a);
        memcpy(before, counted, sizeof before);
        const int32_t wanted = coin_move(&small, &p, &f, 3, 1e-12, 0, &b);
        note(e, before, status, wanted,
             (slides_apart(&d, &small, &p) + fabs(a - b)) / (3 * tol));
    }
    report(kinds[kind], tol, e);
}

/* Coins with losses, for 5 units or to rest. */
static void settles(struct errors *e, int n, double t, double tol)
{
    struct random r = random_begin(8);
    for (int i = 0; i < n; ++i) {
        const coin_params p = body(&r, i);
        const coin_losses l = random_losses(&r, &p, 0.3);
        coin_state s = random_state(&r, &p, 1.4), small = s;
        double before[COUNTED], a = 0, b = 0;
        const int32_t status = coin_settle(&s, &p, &l, t, tol, &a);
        memcpy(before, counted, sizeof before);
        const int32_t wanted = coin_settle(&small, &p, &l, t, 1e-12, &b);
        const double late = fabs(a - b) / fmax(b, 1);
        note(e, before, status, wanted,
             (wanted == COIN_OK ? states_apart(&s, &small, &p) / t : late) /
                 tol);
    }
    report(t > 5 ? "rest" : "settle", tol, e);
}

static void advances(struct errors *e, int n, int thin, double tol)
{
    struct random r = random_begin(10);
    for (int i = 0; i < n; ++i) {
        coin_params p = body(&r, i);
        double before[COUNTED];
        if (thin)
            coin_params_body(&p, 1, 1, 1, 0.25,
                             0.5 * pow(10, random_between(&r, -3, 0)));
        coin_state s = random_state(&r, &p, 1.4), small = s;
        const int32_t status = coin_advance(&s, &p, 10, tol, NULL);
        memcpy(before, counted, sizeof before);
        const int32_t wanted = coin_advance(&small, &p, 10, 1e-13, NULL);
        note(e, before, status, wanted,
             states_apart(&s, &small, &p) / (10 * tol));
    }
    report(thin ? "thin" : "advance", tol, e);
}

static void untils(struct errors *e, int n, double tol)
{
    const int32_t bits = COIN_SLIPS | COIN_LIFTS | COIN_NEARLY_FLAT;
    struct random r = random_begin(12);
    for (int i = 0; i < n; ++i) {
        const coin_params p = body(&r, i);
        const coin_state s = random_state(&r, &p, 1);
        const double mu = random_between(&r, 0.1, 1);
        const coin_table f = {.mu_static = mu, .mu_kinetic = 0.1};
        coin_body d, small;
        coin_body_from_state(&d, &s, &p);
        small = d;
        double before[COUNTED], a = 0, b = 0;
        const int32_t status = coin_move(&d, &p, &f, 10, tol, bits, &a);
        memcpy(before, counted, sizeof before);
        const int32_t wanted = coin_move(&small, &p, &f, 10, 1e-12, bits, &b);
        note(e, before, status, wanted, fabs(a - b) / tol);
    }
    report("until", tol, e);
}

/* Orbits; of coins that start next to flat without falling if `falls`.  The
 * errors of the others are in units of 1e-13 per unit. */
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
        const int32_t wanted = coin_advance(&small, &p, 10, 1e-13, NULL);
        note(e, counted, COIN_OK, wanted,
             states_apart(&at, &small, &p) / 1e-12);
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
        const double tol = tols[k];
        if (IS("slips"))
            slips(&e, n, SLIPS, tol);
        if (IS("light"))
            slips(&e, n, LIGHT, tol);
        if (IS("losses"))
            slips(&e, n, LOSSES, tol);
        if (IS("settle"))
            settles(&e, n, 5, tol);
        if (IS("rest"))
            settles(&e, n, 1000, tol);
        if (IS("advance"))
            advances(&e, n, 0, tol);
        if (IS("thin"))
            advances(&e, n, 1, tol);
        if (IS("until"))
            untils(&e, n, tol);
    }
    if (IS("orbit"))
        orbits(&e, n, 0);
    if (IS("falls"))
        orbits(&e, n, 1);
    free(e.at);
    return 0;
}
