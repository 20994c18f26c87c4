/* SPDX-License-Identifier: MIT */
#include "methods.h"

#include "check.h"
#include "random.h"

#include <math.h>

size_t scene_row(const struct scene *scene, double t)
{
    size_t row = 0;
    while (row + 1 < scene->rows.rows && table_at(&scene->rows, row, "t") < t)
        ++row;
    check_note("scene %s, t = %g", scene->name, t);
    check(isinf(t) || table_at(&scene->rows, row, "t") == t);
    return row;
}

double method_error(const struct scene *scene, int32_t method, size_t row,
                    uint64_t steps)
{
    coin_state s = scene_state(scene, 0);
    const double dt = scene_at(scene, row, "t") / (double)steps;
    const int32_t status =
        coin_run(&s, &scene->params, method, dt, steps, NULL);
    return status < 0 ? (double)INFINITY : scene_error(scene, row, &s);
}

double advance_error(const struct scene *scene, size_t row, double tol)
{
    coin_state s = scene_state(scene, 0);
    const double t = scene_at(scene, row, "t");
    const int32_t status = coin_advance(&s, &scene->params, t, tol, NULL);
    return status < 0 ? (double)INFINITY : scene_error(scene, row, &s);
}

double measured_order(const struct scene *scene, int32_t method, size_t row,
                      uint64_t steps)
{
    const double one = method_error(scene, method, row, steps);
    const double half = method_error(scene, method, row, 2 * steps);
    check_note("scene %s, method %d: error %.3g by %d steps, %.3g by twice",
               scene->name, (int)method, one, (int)steps, half);
    return log2(one / half);
}

/* NaN is the largest. */
static double largest(const double *off, size_t count)
{
    double worst = 0;
    for (size_t i = 0; i < count; ++i)
        if (!(fabs(off[i]) <= worst))
            worst = fabs(off[i]);
    return worst;
}

double path_apart(const coin_state *a, const coin_state *b,
                  const coin_params *p)
{
    const double off[] = {
        a->theta - b->theta,       a->phi - b->phi,           a->psi - b->psi,
        (a->x - b->x) / p->radius, (a->z - b->z) / p->radius,
    };
    return largest(off, sizeof off / sizeof *off);
}

double states_apart(const coin_state *a, const coin_state *b,
                    const coin_params *p)
{
    const double T = natural_time(p);
    const double off[] = {
        path_apart(a, b, p),
        (a->wX - b->wX) * T,
        (a->wY - b->wY) * T,
        (a->wZ - b->wZ) * T,
    };
    return largest(off, sizeof off / sizeof *off);
}
