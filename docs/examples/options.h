/* SPDX-License-Identifier: MIT */
/* options.h: the command line of rolling_quarter. */
#ifndef EXAMPLE_OPTIONS_H
#define EXAMPLE_OPTIONS_H

#include "scenes.h"

#include <coin.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Some seconds of work; beyond it a slip of the keyboard is more likely. */
#define MAX_STEPS 1e8

enum { RUN, DONE, USAGE_ERROR }; /* what options_parse() says */

/* A coin that is thrown: what it moves by beyond rolling, along its plane and
 * upward; how high it starts; dry and pivoting friction, in natural units; its
 * thickness; by how many radians the table slopes down along x. */
typedef struct throwing {
    scene scene;
    double faster, up, high, dry, spin, thickness, slope;
} throwing;

typedef struct options {
    const scene *scene;
    int32_t method;
    double dt, duration; /* 0: as the scene has it */
    double mu;
    const char *out, *csv; /* csv may be null */
    int live, slips;
    const struct throwing *thrown; /* or null */
    uint64_t steps;
} options;

static int complain(const char *format, ...)
{
    va_list args;

    fputs("rolling_quarter: ", stderr);
    va_start(args, format);
    vfprintf(stderr, format, args);
    va_end(args);
    fputs("\n", stderr);
    return USAGE_ERROR;
}

/* -------------------------------------------------------------- options -- */

static const throwing THROWN[] = {
    {{"throw",
      &QUARTER,
      {0.1, 0, 0, 0, 0, 0, 2, 200},
      1e-3,
      0.6,
      "A US quarter, thrown with a backward spin, slips and comes back"},
     3.1,
     0,
     0,
     0,
     0,
     0,
     0},
    {{"toss",
      &QUARTER,
      {1.2, 0, 0, 0, 0, 60, 4, 0},
      1e-3,
      2,
      "A US quarter is tossed: heads or tails?"},
     0.15,
     0.9,
     0.06,
     5e-3,
     1e-3,
     0,
     0},
    {{"edge",
      &QUARTER,
      {0.07, 0, 0, 0, 0, 0, 0, 0},
      2e-3,
      16,
      "A US quarter rocks on its edge, and stands"},
     0,
     0,
     0,
     0,
     0,
     1.75e-3,
     0},
    {{"slope",
      &QUARTER,
      {0, 0, 0, 0, 0, 0, 0, 60},
      1e-3,
      1.6,
      "A US quarter rolls up a slope of 10 degrees, and down again"},
     0,
     0,
     0,
     0,
     0,
     1.75e-3,
     0.17453292519943295},
};

enum { THROWN_COUNT = sizeof THROWN / sizeof THROWN[0] };

static int set_scene(options *o, const char *text)
{
    for (size_t k = 0; k < SCENE_COUNT; ++k)
        if (strcmp(text, SCENES[k].name) == 0) {
            o->scene = &SCENES[k];
            o->thrown = NULL;
            return RUN;
        }
    for (size_t k = 0; k < THROWN_COUNT; ++k)
        if (strcmp(text, THROWN[k].scene.name) == 0) {
            o->thrown = &THROWN[k];
            o->scene = &THROWN[k].scene;
            return RUN;
        }
    complain("no scene '%s'; the scenes are:", text);
    for (size_t k = 0; k < SCENE_COUNT; ++k)
        fprintf(stderr, "  %s\n", SCENES[k].name);
    for (size_t k = 0; k < THROWN_COUNT; ++k)
        fprintf(stderr, "  %s\n", THROWN[k].scene.name);
    return USAGE_ERROR;
}

static int set_method(options *o, const char *text)
{
    const char *name;

    for (int32_t m = 0; (name = coin_method_name(m)) != NULL; ++m)
        if (strcmp(text, name) == 0) {
            o->method = m;
            return RUN;
        }
    complain("no method '%s'; the methods are:", text);
    for (int32_t m = 0; (name = coin_method_name(m)) != NULL; ++m)
        fprintf(stderr, "  %s\n", name);
    return USAGE_ERROR;
}

/* Reads a number, all of the text and nothing else; NaN if there is none. */
static double number(const char *text)
{
    char *end;
    const double x = strtod(text, &end);

    return end != text && *end == '\0' ? x : (double)NAN;
}

static int set_positive(double *x, const char *option, const char *text)
{
    *x = number(text);
    if (*x > 0 && isfinite(*x))
        return RUN;
    return complain("%s must be a finite number > 0, not '%s'", option, text);
}

static int set_dt(options *o, const char *text)
{
    return set_positive(&o->dt, "--dt", text);
}

static int set_duration(options *o, const char *text)
{
    return set_positive(&o->duration, "--duration", text);
}

static int set_mu(options *o, const char *text)
{
    o->mu = number(text);
    if (o->mu >= 0)
        return RUN;
    return complain("--mu must be a number >= 0, or inf, not '%s'", text);
}

static int set_out(options *o, const char *text)
{
    o->out = text;
    return RUN;
}

static int set_csv(options *o, const char *text)
{
    o->csv = text;
    return RUN;
}

static const struct {
    const char *name, *value, *help;
    int (*set)(options *o, const char *text);
} OPTIONS[] = {
    {"--scene", "NAME", "what rolls: see --list (quarter)", set_scene},
    {"--method", "NAME", "the method of integration: see --list (rk4)",
     set_method},
    {"--dt", "TIME", "the step, in the scene's unit (suits the scene)", set_dt},
    {"--duration", "TIME", "how long, in the same unit (suits the scene)",
     set_duration},
    {"--mu", "NUMBER", "coefficient of friction of coin on table (0.3)",
     set_mu},
    {"--out", "FOLDER", "where the drawings go (build)", set_out},
    {"--csv", "FILE", "where the moments go, as a table in all digits",
     set_csv},
};

enum { OPTION_COUNT = sizeof OPTIONS / sizeof OPTIONS[0] };

/* ----------------------------------------------------------------- help -- */

static int print_help(void)
{
    puts("usage: rolling_quarter [OPTION VALUE]...\n"
         "Rolls a coin over a table without slipping, prints its motion and "
         "draws it.\n");
    for (size_t k = 0; k < OPTION_COUNT; ++k)
        printf("  %-10s %-7s %s\n", OPTIONS[k].name, OPTIONS[k].value,
               OPTIONS[k].help);
    puts("  --slip             let it slip and fly where mu does not hold it\n"
         "  --live             play it in the terminal instead\n"
         "  --list             the scenes and the methods\n"
         "  --help             this text");
    return DONE;
}

static int print_list(void)
{
    const char *name;

    puts("scenes:");
    for (size_t k = 0; k < SCENE_COUNT; ++k)
        printf("  %-10s %s\n", SCENES[k].name, SCENES[k].story);
    for (size_t k = 0; k < THROWN_COUNT; ++k)
        printf("  %-10s %s\n", THROWN[k].scene.name, THROWN[k].scene.story);
    puts("methods:");
    for (int32_t m = 0; (name = coin_method_name(m)) != NULL; ++m)
        printf("  %s\n", name);
    return DONE;
}

/* -------------------------------------------------------------- parsing -- */

static int set_option(options *o, const char *name, const char *value)
{
    for (size_t k = 0; k < OPTION_COUNT; ++k)
        if (strcmp(name, OPTIONS[k].name) == 0)
            return value != NULL ? OPTIONS[k].set(o, value)
                                 : complain("%s needs a value", name);
    return complain("no option '%s'; try --help", name);
}

/* Fills in what the scene decides, and counts the steps. */
static int complete(options *o)
{
    if (o->dt == 0)
        o->dt = o->scene->dt;
    if (o->duration == 0)
        o->duration = o->scene->duration;
    if (o->thrown)
        o->slips = 1;

    const double steps = floor(o->duration / o->dt + 0.5);
    if (steps < 1)
        return complain("a duration of %g is shorter than a step of %g",
                        o->duration, o->dt);
    if (!(steps <= MAX_STEPS))
        return complain("a duration of %g in steps of %g is more than %g "
                        "steps",
                        o->duration, o->dt, MAX_STEPS);
    o->steps = (uint64_t)steps;
    return RUN;
}

/* Reads the command line: RUN, DONE if it only asked for help, USAGE_ERROR if
 * it was wrong, which stderr then explains. */
static int options_parse(options *o, char **arguments)
{
    const options defaults = {SCENES, COIN_RK4, 0, 0,    0.3, "build",
                              NULL,   0,        0, NULL, 0};

    *o = defaults;
    for (char **a = arguments; *a != NULL; ++a) {
        if (strcmp(*a, "--help") == 0 || strcmp(*a, "-h") == 0)
            return print_help();
        if (strcmp(*a, "--list") == 0)
            return print_list();
        if (strcmp(*a, "--live") == 0) {
            o->live = 1;
            continue;
        }
        if (strcmp(*a, "--slip") == 0) {
            o->slips = 1;
            continue;
        }
        const int verdict = set_option(o, a[0], a[1]);
        if (verdict != RUN)
            return verdict;
        ++a;
    }
    return complete(o);
}

#endif
