/* SPDX-License-Identifier: MIT */
#include "observable.h"

#include "check.h"
#include "coins.h"
#include "scene.h"
#include "table.h"

#include <math.h>
#include <stdlib.h>

enum { MEMBERS = 8 };

/* A member is changed by this part of itself.  The effect on the values, scaled
 * down, is that of an error of u.  This is far above rounding, and so small
 * that the values change linearly. */
#define MOVED 0x1p-26

struct parts parts_of(const coin_state *s, const coin_params *p)
{
    const double sth = fabs(sin(s->theta)), cth = cos(s->theta);
    const double m = p->mass * p->radius * p->radius;
    struct parts r = {
        sth,
        cth,
        sth / cth,
        fabs(sin(s->phi)),
        fabs(cos(s->phi)),
        fabs(s->wX),
        fabs(s->wY),
        fabs(s->wZ),
        p->mass,
        p->radius,
        p->gravity,
        p->inertia_X,
        p->inertia_Z,
        m,
        p->inertia_X + m,
        p->inertia_Z + m,
        0,
    };
    r.dwX = (r.K * r.wY * r.wZ + r.IX * r.wY * r.wY * r.tth +
             r.M * r.g * r.a * r.sth) /
            r.J;
    return r;
}

static size_t count(const struct observable *o)
{
    size_t n = 0;
    while (o->columns[n])
        ++n;
    check(n > 0);
    return n;
}

static void read_exact(const struct table *t, size_t row, coin_params *p,
                       coin_state *s)
{
    const coin_params params = {
        table_at(t, row, "mass"),
        table_at(t, row, "radius"),
        table_at(t, row, "gravity"),
        table_at(t, row, "inertia_X"),
        table_at(t, row, "inertia_Z"),
        0,
        {0, 0},
    };
    *p = params;
    *s = state_in_row(t, row);
}

void observable_at_exact_states(const struct observable *o)
{
    struct table t;
    double got[OBSERVABLE_MAX], terms[OBSERVABLE_MAX];
    const size_t n = count(o);
    table_load(&t, "observables.csv");
    for (size_t row = 0; row < t.rows; ++row) {
        coin_params p;
        coin_state s;
        read_exact(&t, row, &p, &s);
        o->values(&s, &p, got);
        o->terms(&s, &p, terms);
        for (size_t i = 0; i < n; ++i) {
            check_note("%s, row %zu of observables.csv", o->columns[i], row);
            check_terms(got[i], table_at(&t, row, o->columns[i]), o->units,
                        terms[i]);
        }
    }
}

/* Adds to bound[] what an error of `units` u in x would change the values by;
 * x is a member of *s or *p. */
static void add_effect(const struct observable *o, const coin_state *s,
                       const coin_params *p, double *x, double units, size_t n,
                       double *bound)
{
    double before[OBSERVABLE_MAX], after[OBSERVABLE_MAX];
    const double kept = *x;
    o->values(s, p, before);
    *x *= 1 + MOVED;
    o->values(s, p, after);
    *x = kept;
    for (size_t i = 0; i < n; ++i)
        bound[i] += fabs(after[i] - before[i]) / MOVED * units * U;
}

static void bounds(const struct observable *o, const struct scene *scene,
                   const coin_state *state, size_t n, double *bound)
{
    coin_state s = *state;
    coin_params p = scene->params;
    double *const members[MEMBERS] = {&s.theta, &s.phi, &s.psi, &s.x,
                                      &s.z,     &s.wX,  &s.wY,  &s.wZ};
    o->terms(&s, &p, bound);
    for (size_t i = 0; i < n; ++i)
        bound[i] *= o->units * U;
    for (size_t i = 0; i < MEMBERS; ++i)
        add_effect(o, &s, &p, members[i], 1, n, bound);
    /* I_X first: I_Z alone may not grow beyond 2 I_X. */
    add_effect(o, &s, &p, &p.inertia_X, scene->inertia_error, n, bound);
    p.inertia_X *= 1 + 2 * MOVED;
    add_effect(o, &s, &p, &p.inertia_Z, scene->inertia_error, n, bound);
}

static size_t along_scene(const struct observable *o, const char *name)
{
    struct scene scene;
    double got[OBSERVABLE_MAX], bound[OBSERVABLE_MAX];
    const size_t n = count(o);
    size_t seen = 0;
    scene_load(&scene, name);
    for (size_t row = 0; row < scene.rows.rows; ++row) {
        const coin_state s = scene_state(&scene, row);
        o->values(&s, &scene.params, got);
        bounds(o, &scene, &s, n, bound);
        for (size_t i = 0; i < n; ++i)
            if (table_has(&scene.rows, o->columns[i])) {
                const double want = scene_at(&scene, row, o->columns[i]);
                check_near(got[i], want, bound[i] - U * fabs(want));
                ++seen;
            }
    }
    return seen;
}

void observable_along_scenes(const struct observable *o)
{
    for (size_t i = 0; i < SCENES; ++i)
        check(along_scene(o, scene_names[i]) > 0);
}
