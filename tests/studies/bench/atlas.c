/* SPDX-License-Identifier: MIT */
#include "atlas.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* What a run may err by and still be called right.  docs/limits.md says why. */
#define PLACE 0.1   /* of angles and path, up to UNTIL [rad, radii] */
#define ENERGY 0.01 /* relative, up to the family's end */

/* The tolerance of coin_advance() that makes the references. */
#define FINE 1e-13

#define HALF_PI 1.5707963267948966

/* Natural units of time in PIECES pieces; and how many scenes a family has. */
enum { UNTIL = 20, PIECES = 2, SCENES = 32 };

/* A line of scenes, and the steps to be tried on each. */
typedef struct family {
    const char *name;
    double first, last; /* x of its scenes */
    int ratio;          /* whether x goes by ratios */
    int per_decade;     /* of steps */
    double least, end;  /* the least step; until when [natural units] */
    coin_state (*start)(coin_params *p, double x);
} family;

static coin_state roll(coin_params *p, double wZ)
{
    coin_params_disc(p, 1, 1, 1);
    return (coin_state){.theta = 1e-3, .wZ = wZ};
}

static coin_state ring(coin_params *p, double theta)
{
    coin_params_ring(p, 1, 1, 1, 1);
    return (coin_state){.theta = theta, .wX = 0.1, .wY = 0.8, .wZ = 1.2};
}

static coin_state quarter(coin_params *p, double speed)
{
    coin_params_disc(p, 5.67e-3, 12.13e-3, 9.80665);
    return (coin_state){.theta = 0.3, .wY = 5, .wZ = speed / p->radius};
}

/* d: how near to flat it comes, by tests/reference/passes.csv. */
static coin_state pass(coin_params *p, double d)
{
    const double s = d / 1.235;
    coin_params_disc(p, 1, 1, 1);
    return (coin_state){.theta = 0.3, .wY = s, .wZ = s};
}

static const family families[] = {
    {"roll", 0.04, 1.28, 0, 12, 1e-2, 200, roll},
    {"ring", 0, 1.55, 0, 12, 1e-2, 200, ring},
    {"quarter", 0.02, 2, 1, 12, 1e-2, 200, quarter},
    {"pass", 2.47e-2, 1.235e-13, 1, 9, 1e-4, 20, pass},
};

enum { FAMILIES = sizeof families / sizeof *families };

static double place(const family *f, int i)
{
    const double part = (double)i / (SCENES - 1);
    return f->ratio ? f->first * pow(f->last / f->first, part)
                    : f->first + (f->last - f->first) * part;
}

/* The k-th step, or tolerance; 0: that was the last. */
static double setting_of(const family *f, const solver *v, int k)
{
    if (v->slopes == 0)
        return k <= 20 ? pow(10, -2 - k / 2.0) : 0;
    const double h = pow(10, 0.5 - (double)k / f->per_decade);
    return h > 0.99 * f->least ? h : 0;
}

/* The rows are where coin_advance() takes the coin in one call each: none may
 * begin where the coin lies nearly flat. */
static scene scene_at(const family *f, double x)
{
    scene c = {.name = f->name, .rows = PIECES + 1};
    c.row[0].s = f->start(&c.p, x);
    c.unit = sqrt(c.p.radius / c.p.gravity);
    for (int i = 1; i < c.rows; ++i) {
        struct scene_row *r = &c.row[i];
        r->s = c.row[0].s;
        r->t = c.unit * UNTIL * i / PIECES;
        if (coin_advance(&r->s, &c.p, r->t, FINE, NULL) < 0) {
            fprintf(stderr, "atlas: no reference for %s %g\n", f->name, x);
            exit(1);
        }
    }
    return c;
}

/* On either side of the table. */
static double energy(const coin_params *p, const coin_state *s)
{
    const double m = p->mass * p->radius * p->radius;
    return (m * (s->wX * s->wX + s->wZ * s->wZ) +
            p->inertia_X * (s->wX * s->wX + s->wY * s->wY) +
            p->inertia_Z * s->wZ * s->wZ) /
               2 +
           p->mass * p->gravity * p->radius * cos(s->theta); /* (23) */
}

/* What has become of a run. */
typedef struct fate {
    int refused, warned;
    int gone;     /* through the table, or not a number */
    double error; /* the largest, while there is a truth to compare with */
    double gain;  /* of energy, relative, where that was farthest off */
    coin_state s;
} fate;

static void look(fate *f, const scene *c, const solver *v,
                 const coin_state *truth)
{
    const coin_state s = f->s = v->state();
    const double gain = energy(&c->p, &s) / energy(&c->p, &c->row[0].s) - 1;
    f->gone = !(fabs(s.theta) < HALF_PI) || isnan(gain + s.phi + s.psi) ||
              isnan(s.x + s.z);
    f->gain = fabs(gain) > fabs(f->gain) ? gain : f->gain;
    if (truth)
        f->error = fmax(f->error, scene_error(c, &s, truth, v->wraps));
}

static fate run(const scene *c, const solver *v, double setting, double end)
{
    const double piece = (double)UNTIL / PIECES;
    const double steps = fmax(1, round(piece / setting));
    fate f = {0};
    v->begin(v, c, setting);
    for (int i = 1; i * piece <= end && !f.refused && !f.gone; ++i) {
        const int status =
            v->go(piece * c->unit, v->slopes > 0 ? (unsigned long)steps : 1);
        f.refused = status < 0;
        f.warned |= status > 0;
        look(&f, c, v, !f.refused && i < c->rows ? &c->row[i].s : NULL);
    }
    return f;
}

/* Right, Place wrong, energy Lost, energy Gained, Silent or X: refused; in
 * small letters if there was a warning. */
static char letter(const fate *f)
{
    const char of = f->refused             ? 'X'
                    : f->gone              ? 'S'
                    : f->gain < -ENERGY    ? 'L'
                    : f->gain > ENERGY     ? 'G'
                    : !(f->error <= PLACE) ? 'P'
                                           : 'R';
    return f->warned && !f->refused ? (char)(of - 'A' + 'a') : of;
}

static void map(const family *f, const solver *v)
{
    for (int i = 0; i < SCENES; ++i) {
        const scene c = scene_at(f, place(f, i));
        printf("%s,%s,%.4g,", f->name, v->name, place(f, i));
        for (int k = 0; setting_of(f, v, k) > 0; ++k) {
            const fate r = run(&c, v, setting_of(f, v, k), f->end);
            putchar(letter(&r));
        }
        puts("");
    }
    fflush(stdout);
}

static void tell(const family *f, const solver *v, char **argv, double end)
{
    const scene c = scene_at(f, atof(argv[1]));
    const clock_t begin = clock();
    const fate r = run(&c, v, atof(argv[3]), end);
    const double seconds = (double)(clock() - begin) / CLOCKS_PER_SEC;
    printf("%c: %s; theta %.6g, energy off by %.2g, place by %.2g; %.2g s\n",
           letter(&r),
           r.refused  ? "refused"
           : r.warned ? "warned"
                      : "no error, no warning",
           r.s.theta, r.gain, r.error, seconds);
}

int atlas(const solver *list, int count, int argc, char **argv)
{
    for (const family *f = families; f < families + FAMILIES; ++f) {
        if (argc == 0 || strcmp(argv[0], f->name) == 0)
            for (int i = 0; i < count; ++i) {
                if (argc < 4)
                    map(f, &list[i]);
                else if (strcmp(argv[2], list[i].name) == 0)
                    tell(f, &list[i], argv, argc > 4 ? atof(argv[4]) : f->end);
            }
    }
    return 0;
}
