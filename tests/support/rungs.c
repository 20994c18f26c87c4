/* SPDX-License-Identifier: MIT */
#include "rungs.h"

#include "check.h"
#include "fine.h"
#include "methods.h"

#include <math.h>
#include <stdlib.h>

const char *const kinds_of_scenes[KINDS_OF_SCENES] = {
    "near a stable steady motion", "near an unstable one", "generic",
    "near a separatrix", "falling almost flat"};

static double random_power(struct random *r, double low, double high)
{
    return exp(random_between(r, log(low), log(high)));
}

static double random_sign(struct random *r)
{
    return random_between(r, -1, 1) < 0 ? -1 : 1;
}

/* A steady motion, stable or not; asks until it is. */
static coin_state random_steady(struct random *r, const coin_params *p,
                                int stable)
{
    const double rate = 1 / natural_time(p);
    for (;;) {
        const double wZ = rate * random_between(r, -1.5, 1.5);
        const double theta = random_between(r, -1, 1) * (stable ? 1.3 : 0.33);
        const int kind = (int)random_between(r, 0, 5);
        coin_state s;
        double L;
        if (kind == 0)
            coin_steady_roll(&s, p, wZ);
        else if (kind == 1)
            coin_steady_upright_spin(&s, p, wZ);
        else
            check_status(coin_steady_circle(&s, p, theta, wZ,
                                            random_sign(r) > 0 ? 1 : -1),
                         COIN_OK);
        check_status(coin_stability(&s, p, &L), COIN_OK);
        if ((L < 0) == stable)
            return s;
    }
}

static void push(struct random *r, const coin_params *p, coin_state *s,
                 double distance)
{
    const double rate = distance / natural_time(p);
    s->theta += distance * random_between(r, -1, 1);
    s->wX += rate * random_between(r, -1, 1);
    s->wY += rate * random_between(r, -1, 1);
    s->wZ += rate * random_between(r, -1, 1);
}

static coin_state random_start(struct random *r, const coin_params *p, int kind)
{
    const double unit = natural_time(p);
    coin_state s = {0, 0, 0, 0, 0, 0, 0, 0};
    if (kind == GENERIC)
        return random_state(r, p, 1);
    if (kind == NEARLY_FLAT) {
        s.theta = random_between(r, -1, 1);
        s.wY = random_power(r, 1e-8, 0.1) / unit;
        s.wZ = s.wY * random_between(r, -1, 1);
        return s;
    }
    s = random_steady(r, p, kind == NEAR_STABLE);
    push(r, p, &s, random_power(r, 1e-10, kind == SEPARATRIX ? 1e-3 : 0.1));
    if (kind == SEPARATRIX)
        check_status(
            coin_advance(&s, p, random_between(r, -10, 10) * unit, 1e-12, NULL),
            COIN_OK);
    return s;
}

/* Half of the circles exactly as coin_steady_circle() gives them.  Rounding of
 * 1e-15 grows to the tolerance in 0.5 to 1.2 times the horizon. */
static void begin_unstable(struct rung_scene *scene, struct random *r)
{
    const coin_params *p = &scene->params;
    const double unit = natural_time(p);
    double L = -1;
    while (!(L > 0)) {
        const double lean = random_power(r, 1e-3, 0.34) * random_sign(r);
        const double wZ = random_power(r, 0.01, 0.6) * random_sign(r) / unit;
        check_status(coin_steady_circle(&scene->start, p, lean, wZ,
                                        random_sign(r) > 0 ? 1 : -1),
                     COIN_OK);
        check_status(coin_stability(&scene->start, p, &L), COIN_OK);
    }
    if (random_sign(r) > 0)
        push(r, p, &scene->start, random_power(r, 1e-17, 1e-6));
    scene->tol = random_power(r, 1e-7, 0.1);
    scene->horizon = random_sign(r) * random_between(r, 0.5, 1.2) *
                     log(scene->tol / 1e-15) / sqrt(L);
}

struct rung_scene random_scene(struct random *r, int kind, double longest)
{
    struct rung_scene scene;
    scene.params = random_coin(r);
    if (kind == UNSTABLE) {
        begin_unstable(&scene, r);
    } else {
        scene.start = random_start(r, &scene.params, kind);
        scene.horizon = random_power(r, 0.1, longest) * random_sign(r) *
                        natural_time(&scene.params);
        scene.tol = random_power(r, 1e-7, 0.1);
    }
    const coin_state *s = &scene.start;
    check_note("%s, horizon %g, tol %g, start %a %a %a %a, seed %llu",
               kind == UNSTABLE ? "on an unstable circle"
                                : kinds_of_scenes[kind],
               scene.horizon, scene.tol, s->theta, s->wX, s->wY, s->wZ,
               (unsigned long long)r->seed);
    return scene;
}

static int32_t answer(int rung, const struct rung_scene *scene,
                      const coin_state *steady, const coin_orbit *orbit,
                      double t, coin_state *out)
{
    if (rung == COIN_MODEL_STEADY)
        return coin_steady_at(steady, &scene->params, t, out);
    if (rung == COIN_MODEL_WOBBLE)
        return coin_wobble_at(steady, &scene->params, &scene->start, t, out);
    return coin_orbit_at(orbit, t, out);
}

struct rungs climb(const struct rung_scene *scene, struct random *r, int looks)
{
    const coin_params *p = &scene->params;
    coin_orbit *orbit = malloc(sizeof *orbit);
    coin_state now = scene->start, steady, said;
    struct rungs found = {
        coin_model_needed(&scene->start, p, scene->horizon, scene->tol),
        {0, 0, 0}};
    const int has_orbit = coin_orbit_init(orbit, &now, p) == COIN_OK;
    const int has_steady = coin_steady_near(&now, p, &steady) == COIN_OK;
    double t = 0;
    for (int k = 0; k <= looks && found.wanted >= 0; ++k) {
        const double step = scene->horizon / looks;
        const double next =
            k == looks ? scene->horizon : step * (k + random_between(r, 0, 1));
        check_status(coin_advance(&now, p, next - t, 1e-13, NULL), COIN_OK);
        t = next;
        for (int rung = 0; rung < COIN_MODEL_STEPS; ++rung) {
            const int has = rung == COIN_MODEL_ORBIT ? has_orbit : has_steady;
            const int32_t status =
                has ? answer(rung, scene, &steady, orbit, t, &said)
                    : COIN_EDOMAIN;
            found.error[rung] =
                fmax(found.error[rung], status == COIN_OK
                                            ? path_apart(&now, &said, p)
                                            : (double)INFINITY);
        }
    }
    free(orbit);
    return found;
}

double named_error(const struct rung_scene *scene, int32_t named, int looks)
{
    check_long_double(); /* before anything is allocated */
    const coin_params *p = &scene->params;
    coin_orbit *orbit = malloc(sizeof *orbit);
    coin_state steady = scene->start;
    double most = 0;
    if (named == COIN_MODEL_ORBIT)
        check_status(coin_orbit_init(orbit, &scene->start, p), COIN_OK);
    else
        check_status(coin_steady_near(&scene->start, p, &steady), COIN_OK);
    struct fine f = fine_begin(&scene->start, p);
    for (int k = 1; k <= looks; ++k) {
        const double t = scene->horizon * k / looks;
        const coin_state is = fine_at(&f, t);
        coin_state said;
        check_status(answer(named, scene, &steady, orbit, t, &said), COIN_OK);
        most = fmax(most, path_apart(&is, &said, p));
    }
    free(orbit);
    return most;
}
