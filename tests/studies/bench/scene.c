/* SPDX-License-Identifier: MIT */
#include "scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double member(const char *line, const char *name)
{
    const char *at = strstr(line, name);
    return at ? atof(at + strlen(name)) : NAN;
}

static struct scene_row row_of(const char *line)
{
    double v[9];
    char *end = (char *)(size_t)line;
    for (int i = 0; i < 9; ++i, ++end)
        v[i] = strtod(end, &end);
    const struct scene_row r = {
        v[0],
        atof(strrchr(line, ',') + 1),
        {v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8]},
    };
    return r;
}

void scene_load(scene *c, const char *name, double until)
{
    char path[512], line[4096];
    snprintf(path, sizeof path, "%s/%s.csv", BENCH_DATA, name);
    FILE *f = fopen(path, "r");
    if (!f) {
        perror(path);
        exit(1);
    }
    c->name = name;
    c->rows = 0;
    while (fgets(line, sizeof line, f)) {
        if (strncmp(line, "# params", 8) == 0)
            coin_params_ring(&c->p, member(line, " M="), member(line, " a="),
                             member(line, " b="), member(line, " g="));
        if (strchr("0123456789", line[0]) && c->rows < 16 &&
            atof(line) <= until)
            c->row[c->rows++] = row_of(line);
    }
    fclose(f);
    c->unit = sqrt(c->p.radius / c->p.gravity);
}

static double turn(double d, int wraps)
{
    return wraps ? remainder(d, 6.283185307179586) : d;
}

double scene_error(const scene *c, const coin_state *s, const coin_state *truth,
                   int wraps)
{
    const double a = c->p.radius;
    const double d[5] = {
        s->theta - truth->theta,
        turn(s->phi - truth->phi, wraps),
        turn(s->psi - truth->psi, wraps),
        (s->x - truth->x) / a,
        (s->z - truth->z) / a,
    };
    double e = 0;
    for (int i = 0; i < 5; ++i)
        e = fabs(d[i]) <= e ? e : fabs(d[i]);
    return isnan(d[0] + d[1] + d[2] + d[3] + d[4]) ? NAN : e;
}

void scene_to_natural(const scene *c, double y[8])
{
    const coin_state *s = &c->row[0].s;
    const double a = c->p.radius, w = c->unit;
    const double v[8] = {
        s->theta, s->phi,    s->psi,    s->x / a,
        s->z / a, s->wX * w, s->wY * w, s->wZ * w,
    };
    memcpy(y, v, sizeof v);
}

coin_state scene_from_natural(const scene *c, const double y[8])
{
    const double a = c->p.radius, w = c->unit;
    const coin_state s = {
        y[0], y[1], y[2], y[3] * a, y[4] * a, y[5] / w, y[6] / w, y[7] / w,
    };
    return s;
}
