/* SPDX-License-Identifier: MIT */
#include "study.h"
#include "check.h"
#include "coins.h"
#include "random.h"

#include <math.h>

const char *const study_families[STUDY_FAMILIES] = {
    "generic", "near flat", "unstable", "steady", "fast",
};

const char *const study_methods[STUDY_METHODS] = {
    "rk4", "rk8", "symplectic2", "symplectic4", "coin_advance",
};

static double spread(struct random *r, double low, double high)
{
    return pow(10, random_between(r, low, high));
}

static int one_of(struct random *r, int count)
{
    return (int)random_between(r, 0, count);
}

static double either(struct random *r)
{
    return one_of(r, 2) ? 1 : -1;
}

/* Discs, hoops, rings and any other body, in units of five kinds. */
static coin_params draw_body(struct random *r)
{
    const double units[5][3] = {
        {1, 1, 1},
        {0.00567, 0.01213, 9.80665},
        {1e-14, 1e-9, 9.81},
        {1e14, 1e9, 1e-3},
        {spread(r, -12, 12), spread(r, -6, 6), spread(r, -6, 6)},
    };
    const double *of = units[one_of(r, 5)], m = of[0] * of[1] * of[1];
    const double b = random_between(r, 0, 1), IX = m * spread(r, -2, 1);
    const double IZ = 2 * IX * random_between(r, 0.01, 1);
    coin_params p;
    switch (one_of(r, 4)) {
    case 0:
        check_status(coin_params_disc(&p, of[0], of[1], of[2]), COIN_OK);
        break;
    case 1:
        check_status(coin_params_ring(&p, of[0], of[1], of[1], of[2]), COIN_OK);
        break;
    case 2:
        check_status(coin_params_ring(&p, of[0], of[1], b * of[1], of[2]),
                     COIN_OK);
        break;
    default:
        check_status(coin_params_body(&p, of[0], of[1], of[2], IX, IZ),
                     COIN_OK);
    }
    return p;
}

static coin_state turning(struct random *r, double theta, double low,
                          double high)
{
    const double rate = spread(r, low, high);
    const coin_state s = {
        .theta = random_between(r, -theta, theta),
        .wX = rate * random_between(r, -1, 1),
        .wY = rate * random_between(r, -1, 1),
        .wZ = rate * random_between(r, -1, 1),
    };
    return s;
}

/* A coin dropped with little spin, from the start or from a time shortly before
 * it is at the table; one of eight has no spin and falls flat. */
static coin_state dropped(struct random *r, const coin_params *unit)
{
    const double spin = one_of(r, 8) ? spread(r, -13, -1.7) : 0;
    const double before = spread(r, -6, 0.3);
    const coin_state start = {.theta = 0.3 * either(r),
                              .wY = spin * either(r),
                              .wZ = spin * either(r)};
    coin_state s = start, fallen = start;
    double impact = 0;
    fallen.wY = fallen.wZ = 0;
    check_status(coin_advance(&fallen, unit, 1000, 1e-13, &impact), COIN_EFLAT);
    if (one_of(r, 4))
        check_status(coin_advance(&s, unit, impact - before, 1e-13, NULL),
                     COIN_OK);
    return s;
}

static void nudge(struct random *r, coin_state *s)
{
    const double size = spread(r, -12, -1);
    s->theta += size * random_between(r, -1, 1);
    s->wX += size * random_between(r, -1, 1);
}

static coin_state unstable(struct random *r, const coin_params *unit)
{
    const double part = either(r) * random_between(r, 0, 1.3);
    coin_state s;
    if (one_of(r, 2))
        coin_steady_roll(&s, unit, part * coin_critical_roll(unit));
    else
        coin_steady_upright_spin(&s, unit, part * coin_critical_spin(unit));
    nudge(r, &s);
    return s;
}

static coin_state steady(struct random *r, const coin_params *unit)
{
    const double theta = either(r) * random_between(r, 0.01, 1.4);
    const double wZ = random_between(r, -5, 5);
    coin_state s;
    if (one_of(r, 3))
        check_status(coin_steady_circle(&s, unit, theta, wZ, (int)either(r)),
                     COIN_OK);
    else
        check_status(coin_steady_spin(&s, unit, theta), COIN_OK);
    nudge(r, &s);
    return s;
}

static coin_state draw_state(struct random *r, const coin_params *unit,
                             enum study_family family)
{
    switch (family) {
    case STUDY_GENERIC:
        return turning(r, 1.4, -1, 0.5);
    case STUDY_NEARFLAT:
        return dropped(r, unit);
    case STUDY_UNSTABLE:
        return unstable(r, unit);
    case STUDY_STEADY:
        return steady(r, unit);
    default:
        return turning(r, 1.5, 0.5, 3);
    }
}

struct study_run study_draw(uint64_t seed, uint64_t which, double most_steps,
                            double most_turn)
{
    struct random r = random_begin(seed);
    r.state += which * 0xd1342543de82ef95; /* any odd which */
    struct study_run run = {.p = draw_body(&r)};
    const double m = run.p.mass * run.p.radius * run.p.radius;
    const double T = natural_time(&run.p), a = run.p.radius;
    coin_params unit;
    check_status(coin_params_body(&unit, 1, 1, 1, run.p.inertia_X / m,
                                  run.p.inertia_Z / m),
                 COIN_OK);
    run.family = (enum study_family)one_of(&r, STUDY_FAMILIES);
    run.method = (enum study_method)one_of(&r, STUDY_METHODS);
    run.s = draw_state(&r, &unit, run.family);
    run.s.wX /= T;
    run.s.wY /= T;
    run.s.wZ /= T;
    run.s.phi = random_between(&r, -3, 3);
    run.s.psi = random_between(&r, -3, 3);
    run.s.x = a * random_between(&r, -3, 3);
    run.s.z = a * random_between(&r, -3, 3);
    const double dt = spread(&r, -6, 1),
                 steps = pow(most_steps, random_between(&r, 0, 1));
    const double fit = most_turn / (dt * T * fastest_rate(&run.s, &run.p));
    run.dt = dt * T * either(&r);
    run.steps = (uint64_t)fmax(1, fmin(steps, fit));
    run.tol = spread(&r, -12, -2);
    return run;
}
