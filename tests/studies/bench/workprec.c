/* SPDX-License-Identifier: MIT */
#include "workprec.h"

#include "atlas.h"
#include "clock.h"
#include "textbook.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Other jobs disturb long windows more than short ones.  So a long run is
 * timed in pieces, of which each counts with its own least time; a short one
 * is repeated within one window. */
#define SHORT 40e3 /* ns */
#define PIECE 400  /* steps */
#define PIECES 8192

/* How long one rung is measured, and how often at least; and how often anew
 * while the textbook's step, timed in between, says that the machine is busy.
 */
#ifndef BUDGET
#define BUDGET 8e6 /* ns */
#endif
#define REPEATS 5
#define LONG 60e6 /* ns: beyond, twice is enough */
#ifndef ROUNDS
#define ROUNDS 12
#endif
#define BUSY 1.08

/* An error beyond this is no accuracy any more, but another motion. */
#define WRONG 1.0

/* A rung under measurement. */
struct rung {
    const scene *c;
    const solver *v;
    double setting;
};

struct reading {
    double error, ns, textbook;
    const char *status;
};

static unsigned long steps_of(const struct rung *r, double t)
{
    if (r->v->slopes == 0)
        return 1;
    const double n = ceil(t / (r->setting * r->c->unit) - 1e-9);
    return n < 1 ? 1 : (unsigned long)n;
}

static const char *judge(const struct rung *r, int failed, double error)
{
    const coin_state s = r->v->state();
    if (isnan(error))
        return "diverged";
    if (failed)
        return "refused";
    if (!(fabs(s.theta) < 1.5707963267948966))
        return "through the table";
    return error > WRONG ? "wrong" : "ok";
}

/* From row to row, to see how far it is from the truth. */
static void check(const struct rung *r, struct reading *out)
{
    r->v->begin(r->v, r->c, r->setting);
    out->error = 0;
    out->status = "ok";
    for (int i = 1; i < r->c->rows; ++i) {
        const double t = r->c->row[i].t - r->c->row[i - 1].t;
        const int failed = r->v->go(t, steps_of(r, t)) < 0;
        const coin_state s = r->v->state();
        const double e = scene_error(r->c, &s, &r->c->row[i].s, r->v->wraps);
        out->error = e <= out->error ? out->error : e;
        out->status = judge(r, failed, out->error);
        if (strcmp(out->status, "ok") != 0)
            break;
    }
}

/* All of the run; least[] takes the least time of each piece, if given. */
static void run(const struct rung *r, double *least, double tare)
{
    int k = 0;
    r->v->begin(r->v, r->c, r->setting);
    for (int i = 1; i < r->c->rows; ++i) {
        const double t = r->c->row[i].t - r->c->row[i - 1].t;
        const unsigned long n = steps_of(r, t);
        for (unsigned long m, done = 0; done < n; done += m, ++k) {
            m = n - done < PIECE || k >= PIECES - 1 ? n - done : PIECE;
            const double begin = least ? clock_ns() : 0;
            r->v->go(t * (double)m / (double)n, m);
            if (least)
                least[k] = fmin(least[k], clock_ns() - begin - tare);
        }
    }
}

/* The yardstick, on the same scene and at the same moment [ns per step]. */
static double textbook_step(const scene *c, double tare)
{
    coin_state s = c->row[0].s;
    const double begin = clock_ns();
    textbook_run(&s, &c->p, 1e-3 * c->unit, 256);
    return (clock_ns() - begin - tare) / 256;
}

static double once(const struct rung *r)
{
    const double begin = clock_ns();
    run(r, NULL, 0);
    return clock_ns() - begin;
}

/* One round: method and textbook take turns, the least of each is kept. */
static void take_turns(const struct rung *r, double rough, double *least,
                       double *textbook)
{
    const double tare = clock_cost();
    const int again = (int)ceil(SHORT / rough);
    const int least_often = rough > LONG ? 2 : REPEATS;
    const int repeats =
        (int)fmax(least_often, fmin(300, BUDGET / fmax(rough, SHORT)));
    for (int i = 0; i < repeats; ++i) {
        if (rough > SHORT) {
            run(r, least, tare);
        } else {
            const double begin = clock_ns();
            for (int k = 0; k < again; ++k)
                run(r, NULL, 0);
            least[0] = fmin(least[0], (clock_ns() - begin - tare) / again);
        }
        *textbook = fmin(*textbook, textbook_step(r->c, tare));
    }
}

/* quiet: the least textbook step seen on this scene so far. */
static void measure(const struct rung *r, struct reading *out, double *quiet)
{
    static double least[PIECES];
    const double rough = fmin(once(r), once(r));
    for (int k = 0; k < PIECES; ++k)
        least[k] = INFINITY;
    out->textbook = INFINITY;
    for (int i = 0; i < ROUNDS && out->textbook > BUSY * *quiet; ++i) {
        take_turns(r, rough, least, &out->textbook);
        if (rough > LONG)
            break;
    }
    *quiet = fmin(*quiet, out->textbook);
    out->ns = 0;
    for (int k = 0; k < PIECES && least[k] < INFINITY; ++k)
        out->ns += least[k];
}

/* The least of many, over some tenths of a second. */
static double quiet_textbook(const scene *c)
{
    const double tare = clock_cost();
    double best = INFINITY;
    for (int i = 0; i < 6000; ++i)
        best = fmin(best, textbook_step(c, tare));
    return best;
}

/* Down the ladder until it ends, or takes too long, or gets no better: so many
 * rungs that do not go below the best are the floor of rounding.  A rung of
 * order 4 goes to 0.5 of the error above, one of a solver that chooses its
 * steps only to 0.8 at times. */
#define IDLE 8
#define BETTER 0.9
#define FLOOR 1e-9 /* an error above it is not rounding */

static void walk(const char *build, const scene *c, const solver *v,
                 double *quiet)
{
    const double span = c->row[c->rows - 1].t / c->unit;
    double before = -1;
    double best = INFINITY;
    for (int i = 0, idle = 0; idle < IDLE; ++i) {
        const double setting = v->first * pow(v->factor, i);
        const struct rung r = {c, v, fmax(setting, v->last)};
        struct reading out = {0, NAN, NAN, ""};
        if (setting < v->last * 0.999)
            break;
        check(&r, &out);
        if (out.error == before)
            continue; /* the same run as the rung above */
        before = out.error;
        const int ok = strcmp(out.status, "ok") == 0;
        if (ok)
            measure(&r, &out, quiet);
        printf("%s,%s,%s,%.4g,%.3g,%.3g,%.3g,%s\n", build, c->name, v->name,
               r.setting, out.error, out.ns / span, out.textbook, out.status);
        fflush(stdout);
        idle = best < FLOOR && ok && out.error > BETTER * best ? idle + 1 : 0;
        best = ok ? fmin(best, out.error) : best;
        if (out.ns > v->patience)
            break;
    }
}

int workprec(const solver *list, int count, int argc, char **argv)
{
    if (argc > 1 && strcmp(argv[1], "atlas") == 0)
        return atlas(list, count, argc - 2, argv + 2);
    static const struct {
        const char *name;
        double until; /* in the scene's unit */
    } scenes[] = {
        {"wobble", 20}, {"generic", 20}, {"tumble", 20},
        {"ring", 20},   {"quarter", 1},  {"nearflat", 5},
    };
    for (unsigned k = 0; k < sizeof scenes / sizeof *scenes; ++k) {
        int chosen = argc <= 2;
        for (int i = 2; i < argc; ++i)
            chosen |= strcmp(argv[i], scenes[k].name) == 0;
        if (!chosen)
            continue;
        scene c;
        scene_load(&c, scenes[k].name, scenes[k].until);
        double quiet = quiet_textbook(&c);
        for (int i = 0; i < count; ++i)
            walk(argc > 1 ? argv[1] : "unnamed", &c, &list[i], &quiet);
    }
    return 0;
}
