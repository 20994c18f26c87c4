/* SPDX-License-Identifier: MIT */
/* Rolls a coin over a table, prints how it moves and draws it.  Or throws it.
 *
 *   cc rolling_quarter.c $(pkg-config --cflags --libs rollcoin) -lm
 *
 * roll() and print_row() are what a program of your own would do; the rest is
 * the command line (options.h), a choice of coins (scenes.h), a coin that may
 * slip and fly (thrown.h) and drawings (pictures.h, svg.h, live.h). */
#define _POSIX_C_SOURCE 200809L /* for live.h */
#include "options.h"
#include "pictures.h"
#include "scenes.h"
#include "thrown.h"

#include "live.h"

#include <coin.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS = 20, REST_ROWS = 8 }; /* of the tables, after the start */

/* What is remarkable about a whole motion. */
typedef struct summary {
    double lean_min, lean_max, rolled, energy_error, normal_min, friction;
} summary;

static int fail(const char *what, const char *why)
{
    fprintf(stderr, "rolling_quarter: %s: %s\n", what, why);
    return EXIT_FAILURE;
}

/* -------------------------------------------------------------- rolling -- */

/* Rolls the coin and keeps up to MOMENTS + 1 states, evenly spread.  On an
 * error the motion holds what came before it. */
static int32_t roll(motion *m, const options *o)
{
    const uint64_t kept = o->steps < MOMENTS ? o->steps : MOMENTS;
    coin_state s = m->scene->start;
    uint64_t at = 0;

    for (uint64_t k = 0; k <= kept; ++k) {
        const uint64_t goal = k * o->steps / kept;
        const int32_t status =
            coin_run(&s, &m->params, o->method, o->dt, goal - at, NULL);
        if (status < 0)
            return status;
        const int32_t check =
            coin_check(&s, &m->params, o->method, o->dt, o->mu);
        if (check < 0)
            return check;
        at = goal;
        const moment now = {(double)at * o->dt, s, status | check, 0, 0, 0, 0};
        m->at[m->count++] = now;
    }
    return COIN_OK;
}

/* The error of the energy, which a coin that rolls keeps. */
static double energy_error(const motion *m, size_t k)
{
    const double E = coin_energy(&m->at[k].state, &m->params);

    return E / coin_energy(&m->at[0].state, &m->params) - 1;
}

static summary summarize(const motion *m)
{
    const double weight = m->params.mass * m->params.gravity;
    const double huge = (double)INFINITY;
    summary y = {huge, -huge, 0, 0, huge, 0};
    for (size_t k = 0; k < m->count; ++k) {
        const coin_state *s = &m->at[k].state;
        const double lean = s->theta * DEGREES;
        coin_force R = {{0, 0, 0}, 0, 0, 0};
        coin_reaction(s, &m->params, &R);
        y.lean_min = fmin(y.lean_min, lean);
        y.lean_max = fmax(y.lean_max, lean);
        y.energy_error = fmax(y.energy_error, fabs(energy_error(m, k)));
        y.normal_min = fmin(y.normal_min, R.normal / weight);
        y.friction = fmax(y.friction, R.ratio);
        if (k > 0) /* the contact moves at radius |d(psi)/dt|, Eq. (22) */
            y.rolled +=
                m->params.radius * fabs(s->psi - m->at[k - 1].state.psi);
    }
    return y;
}

/* ------------------------------------------------------------- printing -- */

static void print_heading(const motion *m, const options *o)
{
    const body *b = m->scene->body;
    const units *in = b->in;

    printf("%s: %s\n", m->scene->name, m->scene->story);
    printf("mass %g, radius %g, inner radius %g, gravity %g, %s\n", b->mass,
           b->radius, b->inner_radius, b->gravity, in->given);
    if (m->slides)
        print_slide_heading(o);
    else
        printf("%s, %lu steps of %g %s\n\n", coin_method_name(o->method),
               (unsigned long)o->steps, o->dt, in->time);
    if (o->steps > MOMENTS)
        printf("what follows looks at %d of these moments\n\n", MOMENTS);
}

static void print_columns(const motion *m, double mu)
{
    const units *in = m->scene->body->in;

    printf("%9s %7s %8s %8s %8s %8s %7s %7s  validity\n", "time", "lean",
           "heading", "x", "z", "energy", "N/(Mg)", "F/N");
    printf("%9s %7s %8s %8s %8s %8s %17s mu %g\n", in->time, "deg", "deg",
           in->length, in->length, "error", "", mu);
}

static void print_validity(int32_t bits)
{
    static const struct {
        int32_t bit;
        const char *word;
    } WORDS[] = {{COIN_SLIPS, "slips"},
                 {COIN_LIFTS, "lifts"},
                 {COIN_COARSE, "coarse"},
                 {COIN_NEARLY_FLAT, "nearly flat"}};
    const char *comma = "";

    if (bits == 0)
        printf("rolls");
    for (size_t k = 0; k < sizeof WORDS / sizeof WORDS[0]; ++k) {
        if ((bits & WORDS[k].bit) == 0)
            continue;
        printf("%s%s", comma, WORDS[k].word);
        comma = ", ";
    }
}

/* Where the coin is, how it leans, what the table has to do for it, and
 * whether a real coin would follow. */
static void print_row(const motion *m, size_t k)
{
    const coin_state *s = &m->at[k].state;
    const double weight = m->params.mass * m->params.gravity;
    const double shown = m->scene->body->in->shown;
    coin_force R = {{0, 0, 0}, 0, 0, 0};

    coin_reaction(s, &m->params, &R);
    printf("%9.3f %7.2f %8.1f ", m->at[k].t, plain(s->theta * DEGREES, 2),
           plain(s->phi * DEGREES, 1));
    printf("%8.2f %8.2f ", plain(s->x * shown, 2), plain(s->z * shown, 2));
    printf("%8.0e %7.3f %7.3f  ", energy_error(m, k),
           plain(R.normal / weight, 3), R.ratio);
    print_validity(m->at[k].bits);
    printf("\n");
}

/* Since when a real coin would do something else. */
static int print_first(const motion *m, int32_t bit, const char *what)
{
    for (size_t k = 0; k < m->count; ++k)
        if ((m->at[k].bits & bit) != 0) {
            printf("%s from %.3g on\n", what, m->at[k].t);
            return 1;
        }
    return 0;
}

static void print_summary(const motion *m, double mu)
{
    const summary y = summarize(m);
    const units *in = m->scene->body->in;

    printf("\nlean            %.2f to %.2f degrees\n", plain(y.lean_min, 2),
           plain(y.lean_max, 2));
    printf("track           %.2f %s\n", y.rolled * in->shown, in->length);
    printf("energy error    %.0e at most\n", y.energy_error);
    printf("N/(Mg)          %.3f at least\n", y.normal_min);
    printf("F/N             %.3f at most\n", y.friction);
    printf("a real coin     ");
    if (print_first(m, COIN_SLIPS | COIN_LIFTS, "slips or lifts") == 0)
        printf("can do this with mu %g\n", mu);
    print_first(m, COIN_COARSE, "the step        is coarse");
}

/* ----------------------------------------------------------------- rest -- */

/* Dry friction over weight times radius: that of a quarter which, spun from a
 * lean of 60 degrees, lies flat after 8 s. */
#define DRY 8.5e-4

static void print_rest_row(const motion *m, const coin_losses *l,
                           const coin_state *s, double t)
{
    const coin_state *from = &m->at[m->count - 1].state;
    const double E = coin_energy(from, &m->params);
    coin_state rates = {0};

    coin_losses_rates(s, &m->params, l, &rates);
    printf("%9.2f %7.2f %8.2f %8.2f %8.3f\n", t, plain(s->theta * DEGREES, 2),
           plain((s->psi - from->psi) * DEGREES / 360, 2),
           plain(rates.psi * DEGREES / 360, 2), coin_energy(s, &m->params) / E);
}

/* The coin goes on, slowed by friction, until it lies flat. */
static void print_rest(const motion *m)
{
    const coin_params *p = &m->params;
    const char *unit = m->scene->body->in->time;
    const coin_losses l = {.dry = DRY * p->mass * p->gravity * p->radius};
    coin_state s = m->at[m->count - 1].state, flat = s;
    double rest;

    if (coin_settle(&flat, p, &l, 1e5 * sqrt(p->radius / p->gravity), 1e-6,
                    &rest) != COIN_RESTS)
        return;
    printf("\nAnd then dry friction of %g of its weight times its radius "
           "lays it flat:\n\n",
           DRY);
    printf("%9s %7s %8s %8s %8s\n", "time", "lean", "contact", "its rate",
           "energy");
    printf("%9s %7s %8s %8s %8s\n", unit, "deg", "turns", "", "left");
    for (int k = 0; k < REST_ROWS; ++k) {
        print_rest_row(m, &l, &s, rest * k / REST_ROWS);
        coin_settle(&s, p, &l, rest / REST_ROWS, 1e-6, NULL);
    }
    printf("%9.2f   flat; its face turns %.2f times per %s\n", rest,
           fabs(flat.wZ) * DEGREES / 360, unit);
}

/* Of a coin that rolls, or of one that may slip. */
static void print_one_row(const motion *m, const options *o, size_t k)
{
    if (m->slides)
        print_slide_row(m, o, k);
    else
        print_row(m, k);
}

static void print_either_columns(const motion *m, const options *o)
{
    if (m->slides)
        print_slide_columns(m);
    else
        print_columns(m, o->mu);
}

static void print_motion(const motion *m, const options *o)
{
    print_heading(m, o);
    print_either_columns(m, o);
    if (m->count == 0)
        return;
    for (size_t row = 0; row <= ROWS; ++row)
        if (row == 0 ||
            row * (m->count - 1) / ROWS != (row - 1) * (m->count - 1) / ROWS)
            print_one_row(m, o, row * (m->count - 1) / ROWS);
    if (m->slides)
        print_slide_summary(m);
    else
        print_summary(m, o->mu);
    if (!m->slides || m->end == COIN_OK)
        print_rest(m);
    if (m->slides)
        print_verdict(m);
}

/* -------------------------------------------------------------- drawing -- */

static int draw(const motion *m, const char *folder)
{
    char path[FILENAME_MAX];

    for (size_t k = 0; k < PICTURE_COUNT; ++k) {
        const int length = snprintf(path, sizeof path, "%s/%s%s.svg", folder,
                                    m->scene->name, PICTURES[k].suffix);
        if (length < 0 || (size_t)length >= sizeof path)
            return fail(folder, "the name is too long");
        if (draw_picture(m, k, path) != 0)
            return fail(path, strerror(errno));
        printf("drew %s\n", path);
    }
    return EXIT_SUCCESS;
}

/* ------------------------------------------------------------------ csv -- */

static void write_row(FILE *f, const motion *m, const options *o, size_t k)
{
    const coin_params *p = &m->params;
    const coin_table table = table_of(o);
    const coin_state *s = &m->at[k].state;
    coin_body b = {0};
    coin_force R = {{0, 0, 0}, 0, 0, 0};

    if (m->slides) {
        b = body_at(m, k);
        coin_body_reaction(&b, p, &table, &R);
    } else {
        coin_body_from_state(&b, s, p);
        coin_reaction(s, p, &R);
    }
    fprintf(f, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,", m->at[k].t, s->theta,
            s->phi, s->psi, s->x, s->z);
    fprintf(f, "%.17g,%.17g,%.17g,%.17g,%.17g,%.17g,", s->wX, s->wY, s->wZ, b.y,
            R.normal, R.ratio);
    fprintf(f, "%.17g,%ld\n", coin_body_energy(&b, p), (long)m->at[k].bits);
}

/* The columns that the page saves too, but those of the contact. */
static int write_csv(const motion *m, const options *o)
{
    FILE *f = fopen(o->csv, "w");

    if (f == NULL)
        return fail(o->csv, strerror(errno));
    fputs("t,theta,phi,psi,x,z,wX,wY,wZ,y,N,ratio,energy,bits\n", f);
    for (size_t k = 0; k < m->count; ++k)
        write_row(f, m, o, k);
    const int bad = ferror(f);
    if (fclose(f) != 0 || bad)
        return fail(o->csv, strerror(errno));
    return EXIT_SUCCESS;
}

/* What stands above the picture of --live. */
static void print_live(const motion *m, const options *o, size_t k)
{
    puts(m->scene->story);
    print_either_columns(m, o);
    print_one_row(m, o, k);
}

static int32_t make_coin(coin_params *p, const options *o)
{
    const body *b = o->scene->body;
    const throwing *w = o->thrown;

    if (w && w->thickness > 0)
        return coin_params_cylinder(p, b->mass, b->radius, w->thickness,
                                    b->gravity * cos(w->slope));
    return coin_params_ring(p, b->mass, b->radius, b->inner_radius, b->gravity);
}

static int run(const options *o)
{
    static motion m; /* too large for the stack of some systems */
    int32_t status = make_coin(&m.params, o);

    m.scene = o->scene;
    m.pull = table_of(o).pull[0];
    m.slides = o->slips;
    if (status >= 0)
        status = m.slides ? slide(&m, o) : roll(&m, o);
    if (!o->live || !live_can())
        print_motion(&m, o);
    else if (m.count > 0) {
        live(&m, o, print_live);
        print_verdict(&m);
    }
    if (o->csv && write_csv(&m, o) != EXIT_SUCCESS)
        return EXIT_FAILURE;
    if (status >= 0)
        return o->live ? EXIT_SUCCESS : draw(&m, o->out);
    fflush(stdout);
    fail("the coin stopped there", coin_status_string(status));
    if (status == COIN_ESTEP)
        fprintf(stderr, "a smaller --dt than %g may do\n", o->dt);
    return EXIT_FAILURE;
}

int main(int argc, char **argv)
{
    options o;
    const int verdict = options_parse(&o, argc > 0 ? argv + 1 : argv);

    if (verdict == USAGE_ERROR)
        return 2;
    if (verdict == RUN && o.live && !isatty(STDOUT_FILENO))
        return fail("--live", "standard output is not a terminal");
    const int code = verdict == RUN ? run(&o) : EXIT_SUCCESS;
    if (fflush(stdout) != 0 || ferror(stdout))
        return fail("standard output", strerror(errno));
    return code;
}
