/* SPDX-License-Identifier: MIT */
/* What the tuned numbers of lib/ trade: calls and errors over random motions.
 *     tuning N [WHAT [FILE]]   N motions of each kind, or of the kind WHAT:
 *                              slips, light, onset, down, losses, toss, flat,
 *                              settle, rest, advance, thin, until, peak, fit,
 *                              orbit or falls
 * Change a number, run it again and compare, as constants.py does.  An error is
 * the distance from the same motion with a far smaller tol, over tol and over
 * the time.  That motion is read from FILE, or written to it if there is none.
 * So it shows what a change does; the tests compare with independent
 * references.
 *
 * The linker puts a counter before each function that is counted (--wrap). */
#include "support/coins.h"
#include "support/losses.h"
#include "support/methods.h"
#include "support/peaks.h"
#include "support/slides.h"
#include "support/thrown.h"

#include "air/air.h"
#include "exact/pieces.h"
#include "motion/state.h"
#include "step/extrapolation.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STEP, WITHIN, SLOPES, MARGINS, LOOKS, EXTRAPOLATE, COUNTED };
static double counted[COUNTED];

static const char *const names[COUNTED] = {
    "steps", "within", "slopes", "margins", "looks", "extrapolate",
};

/* ---------------------------------------------------------------- counters */
struct coin_priv_dop853;
struct coin_priv_law;
struct coin_priv_problem;
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
COUNT(SLOPES, int, return, coin_priv_rates,
      (double *d, const double *y, const struct coin_priv_problem *of),
      (d, y, of))
COUNT(MARGINS, double, return, coin_priv_contact_margin,
      (const double *y, const struct coin_priv_law *l, int mode), (y, l, mode))
COUNT(MARGINS, double, return, coin_priv_hold_margin,
      (const double *y, const struct coin_priv_law *l, int mode, double tol),
      (y, l, mode, tol))
COUNT(EXTRAPOLATE, int, return, coin_priv_extrapolate,
      (coin_priv_run * r, double tau, double *error), (r, tau, error))

coin_priv_touch __real_coin_priv_first_touch(const coin_priv_flight *f,
                                             double t, int leaves);
coin_priv_touch __wrap_coin_priv_first_touch(const coin_priv_flight *f,
                                             double t, int leaves);
coin_priv_touch __wrap_coin_priv_first_touch(const coin_priv_flight *f,
                                             double t, int leaves)
{
    const coin_priv_touch r = __real_coin_priv_first_touch(f, t, leaves);
    counted[LOOKS] += r.looks;
    return r;
}

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
enum {
    SLIPS,
    LIGHT,
    ONSET,
    DOWN,
    LOSSES,
    TOSS,
    FLAT,
    SETTLE,
    REST,
    ADVANCE,
    THIN,
    UNTIL,
    PEAK,
    KINDS
};

/* Its name, how long it is, and the tol that is small. */
static const struct kind {
    const char *name;
    double time, small;
} kinds[KINDS] = {
    {"slips", 3, 1e-12},    {"light", 3, 1e-12},  {"onset", 3, 1e-12},
    {"down", 1, 1e-12},     {"losses", 3, 1e-12}, {"toss", 5, 1e-12},
    {"flat", 5, 1e-12},     {"settle", 5, 1e-12}, {"rest", 1000, 1e-12},
    {"advance", 10, 1e-13}, {"thin", 10, 1e-13},  {"until", 10, 1e-12},
    {"peak", 0, 1e-12},
};

/* One of the motions: a body, what it starts from, and what slows it. */
struct moving {
    coin_params p;
    coin_table table;
    coin_body b;
    double time, reached;
    int32_t status;
};

/* A body that lies flat, slides and turns: one of the speeds may be small. */
static coin_body on_its_face(struct random *r)
{
    coin_body b = {.s = {.theta = COIN_PRIV_LAST_LEAN}};
    b.y = cos(b.s.theta);
    b.vx = pow(10, random_between(r, -20, 0));
    b.s.wZ = pow(10, random_between(r, -4, 0));
    return b;
}

/* A coin that needs little more friction than there is, at one moment. */
static void just_slip(struct moving *m, struct random *r)
{
    double most, at;
    const struct motion peak = motion_with_peak(r, &m->time, &most, &at);
    m->p = peak.p;
    m->table.mu_static = most * (1 - pow(10, random_between(r, -5, -2)));
    m->table.mu_kinetic = fmin(m->table.mu_static, 0.1);
    coin_body_from_state(&m->b, &peak.s, &m->p);
}

static struct moving draw(struct random *r, int kind, int i)
{
    struct moving m = {.p = body(r, i), .time = kinds[kind].time};
    const double small = pow(10, random_between(r, -3, 0));
    if (kind == LIGHT)
        coin_params_body(&m.p, 1, 1, 1, 0.5 * small,
                         small * random_between(r, 0.01, 1));
    if (kind == THIN)
        coin_params_body(&m.p, 1, 1, 1, 0.25, 0.5 * small);
    m.table.mu_kinetic = random_between(r, 0.05, 0.6);
    m.table.mu_static = m.table.mu_kinetic * random_between(r, 1, 2);
    if (kind == FLAT)
        coin_params_ring(&m.p, 1, 1, 1 - small * small * small, 1);
    if (kind == ONSET)
        m.table.mu_static = m.table.mu_kinetic;
    if (kind >= DOWN && kind <= REST)
        m.table.losses = random_losses(r, &m.p, 0.3);
    if (kind >= DOWN && kind <= FLAT)
        m.table.losses.damping = 0;
    coin_state s = random_state(r, &m.p, kind == UNTIL ? 1 : 1.4);
    if (kind == DOWN) {
        s.theta = COIN_PRIV_HALF_PI - pow(10, random_between(r, -3, -1));
        s.wX *= 0.1;
    }
    if (kind == TOSS) {
        m.b = random_throw(r, 1, 5);
        m.table.restitution = random_between(r, 0, 0.5);
    } else if (kind == FLAT) {
        m.b = on_its_face(r);
    } else if (kind == PEAK) {
        just_slip(&m, r);
    } else if (kind == SLIPS || kind == LIGHT || kind == LOSSES) {
        m.b = random_launch(r, &m.p);
    } else {
        coin_body_from_state(&m.b, &s, &m.p);
    }
    return m;
}

/* Moves it for a time, to rest, or until friction does not hold it. */
static void go(struct moving *m, int kind, double t, double tol)
{
    const int32_t stop =
        kind >= UNTIL ? COIN_SLIPS | COIN_LIFTS | COIN_NEARLY_FLAT : 0;
    if (kind == SETTLE || kind == REST)
        m->status =
            coin_settle(&m->b.s, &m->p, &m->table.losses, t, tol, &m->reached);
    else if (kind == ADVANCE || kind == THIN)
        m->status = coin_advance(&m->b.s, &m->p, t, tol, &m->reached);
    else
        m->status =
            coin_move(&m->b, &m->p, &m->table, t, tol, stop, &m->reached);
}

/* How far two are apart, per unit of time; of those that end by themselves also
 * in when they do. */
static double apart(const struct moving *a, const struct moving *b, int kind)
{
    const double late = fabs(a->reached - b->reached);
    if (kind == REST || kind >= UNTIL)
        return late / fmax(b->reached, 1);
    if (kind <= FLAT)
        return (slides_apart(&a->b, &b->b, &a->p) + late) / kinds[kind].time;
    return states_apart(&a->b.s, &b->b.s, &a->p) / kinds[kind].time;
}

/* Moves it by a small tol, by many calls if one does not come to the end. */
static void go_exactly(struct moving *m, int kind)
{
    double sum = 0;
    for (int i = 0; i < 20; ++i) {
        m->reached = 0;
        go(m, kind, m->time - sum, kinds[kind].small);
        sum += m->reached;
        if (m->status < 0 || !(m->status & COIN_MORE))
            break;
    }
    m->reached = sum;
}

/* The motions by a small tol, and what they start from, from the file if it is
 * there. */
static void truths(struct moving *small, struct moving *from, int n, int kind,
                   const char *name)
{
    const size_t size = sizeof *small, count = (size_t)n;
    struct random r = random_begin(7);
    FILE *file = name ? fopen(name, "rb") : NULL;
    if (file && fread(small, size, count, file) == count &&
        fread(from, size, count, file) == count) {
        fclose(file);
        return;
    }
    for (int i = 0; i < n; ++i) {
        small[i] = from[i] = draw(&r, kind, i);
        go_exactly(&small[i], kind);
    }
    memset(counted, 0, sizeof counted);
    if (name && (file = fopen(name, "wb"))) {
        fwrite(small, size, count, file);
        fwrite(from, size, count, file);
        fclose(file);
    }
}

/* Adds an error if both motions ended alike.  Those that a small tol does not
 * bring to the end are left out. */
static void motions(struct errors *e, int n, int kind, const char *file)
{
    struct moving *const small = calloc(2 * (size_t)n, sizeof *small);
    if (!small)
        exit(1);
    truths(small, small + n, n, kind, file);
    for (int k = 0; k < 3; ++k) {
        static const double tols[] = {1e-2, 1e-4, 1e-9};
        for (int i = 0; i < n; ++i) {
            struct moving m = small[n + i];
            if (small[i].status < 0 || small[i].status & COIN_MORE)
                continue;
            go(&m, kind, m.time, tols[k]);
            if (m.status == small[i].status)
                e->at[e->n++] = apart(&m, &small[i], kind) / tols[k];
            else
                ++e->other;
        }
        report(kinds[kind].name, tols[k], e);
    }
    free(small);
}

/* Losses for a time to rest; how far that of coin_settle() is from it, in units
 * of 5e-3. */
static void fits(struct errors *e, int n)
{
    struct random r = random_begin(17);
    double before[COUNTED];
    for (int i = 0; i < n; ++i) {
        struct moving m = draw(&r, REST, i);
        coin_losses *const l = &m.table.losses;
        const double time = coin_time_to_rest(&m.b.s, &m.p, l, 1e-6) *
                            random_between(&r, 0.3, 3);
        if (coin_losses_fit(l, &m.b.s, &m.p, time) == COIN_OK) {
            memcpy(before, counted, sizeof before);
            coin_settle(&m.b.s, &m.p, l, 2 * time, 1e-10, &m.reached);
            memcpy(counted, before, sizeof counted);
            e->at[e->n++] = fabs(m.reached / time - 1) / 5e-3;
        } else {
            ++e->other;
        }
    }
    report("fit", 1e-6, e);
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
    struct errors e = {0, 0, calloc(10 * (size_t)n + 1, sizeof(double))};
    if (!e.at || n < 1)
        return 1;
#define IS(name) (strcmp(what, "all") == 0 || strcmp(what, name) == 0)
    for (int kind = 0; kind < KINDS; ++kind)
        if (IS(kinds[kind].name))
            motions(&e, kind == PEAK ? 10 * n : n, kind,
                    argc > 3 ? argv[3] : NULL);
    if (IS("fit"))
        fits(&e, n);
    if (IS("orbit"))
        orbits(&e, n, 0);
    if (IS("falls"))
        orbits(&e, n, 1);
    free(e.at);
    return 0;
}
