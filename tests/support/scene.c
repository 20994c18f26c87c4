/* SPDX-License-Identifier: MIT */
#include "scene.h"

#include "check.h"
#include "coins.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const scene_names[SCENES] = {
    "wobble", "generic", "spin",     "circle",   "tumble", "nearflat",
    "ring",   "quarter", "ring_b05", "negative", "flat3",  "si_washer",
};

static double header_number(const struct table *t, const char *key)
{
    const char *params = strstr(t->header, "# params");
    check(params != NULL);
    const char *at = strstr(params, key);
    check(at != NULL);
    return strtod(at + strlen(key), NULL);
}

static int exact_product(double a, double b)
{
    return fma(a, b, -(a * b)) == 0;
}

/* I_X = M (a^2 + b^2)/4 has four roundings at most, of which the division by
 * 4 is exact. */
static double inertia_error(double M, double a, double b)
{
    const double sum = a * a + b * b;
    const int exact = exact_product(a, a) && exact_product(b, b) &&
                      sum - a * a == b * b && exact_product(M, sum);
    return exact ? 0 : 3;
}

void scene_load(struct scene *scene, const char *name)
{
    char file[64];
    snprintf(file, sizeof file, "%s.csv", name);
    scene->name = name;
    table_load(&scene->rows, file);
    const double M = header_number(&scene->rows, " M=");
    const double a = header_number(&scene->rows, " a=");
    const double b = header_number(&scene->rows, " b=");
    const double g = header_number(&scene->rows, " g=");
    check_status(coin_params_ring(&scene->params, M, a, b, g), COIN_OK);
    scene->inertia_error = inertia_error(M, a, b);
}

double scene_at(const struct scene *scene, size_t row, const char *column)
{
    check_note("scene %s, row %zu", scene->name, row);
    return table_at(&scene->rows, row, column);
}

coin_state scene_state(const struct scene *scene, size_t row)
{
    check_note("scene %s, row %zu", scene->name, row);
    return state_in_row(&scene->rows, row);
}

coin_state scene_run(const struct scene *scene, size_t row, uint64_t steps)
{
    coin_state s = scene_state(scene, 0);
    const double dt = scene_at(scene, row, "t") / (double)steps;
    check(coin_run(&s, &scene->params, COIN_RK4, dt, steps, NULL) >= 0);
    return s;
}

double scene_error(const struct scene *scene, size_t row, const coin_state *s)
{
    const coin_state want = scene_state(scene, row);
    const double a = scene->params.radius;
    const double off[] = {
        s->theta - want.theta, s->phi - want.phi,   s->psi - want.psi,
        (s->x - want.x) / a,   (s->z - want.z) / a,
    };
    double worst = 0;
    for (size_t i = 0; i < 5; ++i)
        worst = fmax(worst, fabs(off[i]));
    return worst;
}
