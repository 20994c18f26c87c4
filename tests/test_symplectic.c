/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/methods.h"
#include "support/random.h"

#include "legendre.h"
#include "params.h"

#include <math.h>

static struct scene scene;

/* ----------------------------------------------------------- convergence */
/* Both methods are symmetric, so that an error has even powers of dt alone:
 * halved steps divide it by 2^order, the next power adding less than 3 % at
 * these steps.  The errors are measured. */
struct convergence {
    const char *name;
    double t;
    uint64_t steps;
    double error;
};

static void check_order(const struct convergence *c, size_t count,
                        int32_t method)
{
    const double order = method == COIN_SYMPLECTIC2 ? 2 : 4;
    for (size_t i = 0; i < count; ++i) {
        scene_load(&scene, c[i].name);
        const size_t row = scene_row(&scene, c[i].t);
        const double error = method_error(&scene, method, row, c[i].steps);
        check_within(error / c[i].error, 0.8, 1.25);
        check_within(measured_order(&scene, method, row, c[i].steps),
                     order - 0.05, order + 0.05);
    }
}

TEST(symplectic2_is_of_order_2)
{
    const struct convergence c[] = {
        {"wobble", 5, 64, 2.0e-4},      {"generic", 5, 128, 7.0e-4},
        {"tumble", 5, 64, 1.8e-5},      {"ring", 5, 128, 9.9e-4},
        {"quarter", 0.25, 128, 1.1e-4}, {"ring_b05", 5, 256, 1.3e-3},
        {"negative", 5, 128, 7.5e-4},   {"si_washer", 0.25, 128, 2.9e-4},
    };
    check_order(c, sizeof c / sizeof *c, COIN_SYMPLECTIC2);
}

TEST(symplectic4_is_of_order_4)
{
    const struct convergence c[] = {
        {"wobble", 5, 64, 1.2e-8},      {"generic", 5, 128, 1.1e-7},
        {"tumble", 5, 64, 4.5e-10},     {"ring", 5, 128, 1.65e-7},
        {"quarter", 0.25, 128, 1.2e-8}, {"ring_b05", 5, 256, 1.07e-7},
        {"negative", 5, 128, 5.0e-8},   {"si_washer", 0.25, 128, 1.7e-8},
    };
    check_order(c, sizeof c / sizeof *c, COIN_SYMPLECTIC4);
}

/* Steady motion is a fixed point of kick and drift: only the path of a circle,
 * of order 4, errs.  A spin has none. */
TEST(steady_motions_stay_steady)
{
    const char *const names[] = {"spin", "circle"};
    for (size_t i = 0; i < 2; ++i)
        for (int32_t method = COIN_SYMPLECTIC2; method < METHODS; ++method) {
            scene_load(&scene, names[i]);
            const size_t row = scene_row(&scene, 5);
            if (i == 0)
                check_within(method_error(&scene, method, row, 32), 0, 3e-14);
            else
                check_within(measured_order(&scene, method, row, 32), 3.95,
                             4.05);
            const coin_state start = scene_state(&scene, 0);
            coin_state s = start;
            check(coin_run(&s, &scene.params, method, 0.03, 10000, NULL) >= 0);
            check_near(s.theta, start.theta, 1e-14);
            check_near(s.wX, 0, 1e-14);
        }
}

/* ------------------------------------------------ the reduced map's area */
/* The two integrals, and the rates that they allow at a lean: wX is free. */
struct integrals {
    double KY, KZ;
};

static struct integrals integrals_of(const coin_state *s,
                                     const coin_priv_constants *b)
{
    const double p = s->wY * cos(s->theta);
    const coin_priv_central c =
        coin_priv_legendre_central(b->k1 * b->k2, sin(s->theta));
    const struct integrals K = {
        c.We * p - b->k1 * c.Po * s->wZ,
        c.Pe * s->wZ - b->k2 * c.Wo * p,
    };
    return K;
}

static coin_state on_level(struct integrals K, const coin_priv_constants *b,
                           double theta, double wX)
{
    const coin_priv_central c =
        coin_priv_legendre_central(b->k1 * b->k2, sin(theta));
    const coin_state s = {
        .theta = theta,
        .wX = wX,
        .wY = (K.KY * c.Pe + b->k1 * K.KZ * c.Po) / cos(theta),
        .wZ = K.KZ * c.We + b->k2 * K.KY * c.Wo,
    };
    return s;
}

enum { MAP_STEPS = 20 };

/* (theta, wX) after MAP_STEPS, from there on the same level. */
struct point {
    double theta, wX;
};

struct map {
    coin_params p;
    coin_priv_constants b;
    struct integrals K;
    int32_t method;
    double dt;
};

static struct point mapped(const struct map *m, double theta, double wX)
{
    coin_state s = on_level(m->K, &m->b, theta, wX);
    check(coin_run(&s, &m->p, m->method, m->dt, MAP_STEPS, NULL) >= 0);
    const struct point end = {s.theta, s.wX};
    return end;
}

/* d(end)/d(start) along (dtheta, dwX), by central differences of order 6. */
static struct point derivative(const struct map *m, const coin_state *at,
                               double dtheta, double dwX)
{
    static const double weights[] = {45.0 / 60, -9.0 / 60, 1.0 / 60};
    const double h = 2e-3;
    struct point d = {0, 0};
    for (int k = 1; k <= 3; ++k) {
        const double x = k * h * dtheta, y = k * h * dwX;
        const struct point ahead = mapped(m, at->theta + x, at->wX + y);
        const struct point behind = mapped(m, at->theta - x, at->wX - y);
        d.theta += weights[k - 1] * (ahead.theta - behind.theta) / h;
        d.wX += weights[k - 1] * (ahead.wX - behind.wX) / h;
    }
    return d;
}

static double determinant(const coin_state *at, const coin_params *p,
                          int32_t method, double dt)
{
    struct map m = {.p = *p, .method = method, .dt = dt};
    m.b = coin_priv_constants_of(p);
    m.K = integrals_of(at, &m.b);
    const struct point by_theta = derivative(&m, at, 1, 0);
    const struct point by_wX = derivative(&m, at, 0, 1);
    return by_theta.theta * by_wX.wX - by_theta.wX * by_wX.theta;
}

TEST(the_map_keeps_area_where_the_integrals_are_fixed)
{
    const coin_state at[] = {
        {.theta = 0.5, .wX = 0.1, .wY = 0.8, .wZ = 1.2},
        {.theta = -0.4, .wX = 0.2, .wY = 0.6, .wZ = -1.5},
        {.theta = 0.1, .wZ = 1},
    };
    for (size_t i = 0; i < sizeof at / sizeof *at; ++i)
        for (int j = 0; j < 3; ++j) {
            coin_params p;
            check_status(coin_params_ring(&p, 1, 1, j / 2.0, 1), COIN_OK);
            check_note("start %zu, inner radius %g", i, j / 2.0);
            for (int32_t k = COIN_SYMPLECTIC2; k <= COIN_SYMPLECTIC4; ++k)
                check_near(determinant(&at[i], &p, k, 0.12), 1, 4e-12);
            check(fabs(determinant(&at[i], &p, COIN_RK4, 0.12) - 1) > 1e-6);
        }
}

/* ------------------------------------------------------------- long runs */
enum { SAMPLES = 10000, APART = 10, TENTH = SAMPLES / 10 };

static coin_state path[SAMPLES];

struct span {
    double mean, lowest, highest;
};

static struct span energy_errors(const coin_state *s, double E)
{
    struct span span = {0, INFINITY, -INFINITY};
    for (int i = 0; i < TENTH; ++i) {
        const double error = coin_energy(&s[i], &scene.params) / E - 1;
        span.mean += error / TENTH;
        span.lowest = fmin(span.lowest, error);
        span.highest = fmax(span.highest, error);
    }
    return span;
}

/* The relative error of E over 1e5 steps of generic: first the largest, then
 * how far its mean moves from the first tenth to the last, in its own
 * amplitude. */
static void energy_over(int32_t method, double *largest, double *moved)
{
    scene_load(&scene, "generic");
    const coin_state start = scene_state(&scene, 0);
    const double E = coin_energy(&start, &scene.params);
    check(coin_sample(&start, &scene.params, method, 0.05, APART, SAMPLES, path,
                      NULL) >= 0);
    const struct span first = energy_errors(path, E);
    const struct span last = energy_errors(path + SAMPLES - TENTH, E);
    *largest = fmax(fmax(-first.lowest, first.highest),
                    fmax(-last.lowest, last.highest));
    *moved = fabs(last.mean - first.mean) / (first.highest - first.lowest);
    check_note("method %d: energy within %.3g, its mean moves by %.3g",
               (int)method, *largest, *moved);
}

TEST(the_energy_oscillates_and_does_not_drift)
{
    double largest, moved;
    energy_over(COIN_SYMPLECTIC2, &largest, &moved);
    check_within(largest, 5e-5, 2e-4);
    check_within(moved, 0, 0.01);
    energy_over(COIN_SYMPLECTIC4, &largest, &moved);
    check_within(largest, 5e-9, 2e-8);
    check_within(moved, 0, 0.01);
    /* By its own measure RK4 runs away. */
    energy_over(COIN_RK4, &largest, &moved);
    check(moved > 5);
}

/* RMS over some starts of the relative error of K_Y and K_Z. */
static double integral_error(int32_t method, double dt, uint64_t steps)
{
    enum { STARTS = 40 };
    struct random r = random_begin(71);
    double sum = 0;
    for (int i = 0; i < STARTS; ++i) {
        coin_state s = scene_state(&scene, 0);
        double K0[2], K[2];
        s.theta += random_between(&r, -0.1, 0.1);
        s.wY += random_between(&r, -0.1, 0.1);
        check_status(coin_integrals(&s, &scene.params, K0), COIN_OK);
        check(coin_run(&s, &scene.params, method, dt, steps, NULL) >= 0);
        check_status(coin_integrals(&s, &scene.params, K), COIN_OK);
        for (int k = 0; k < 2; ++k)
            sum += (K[k] / K0[k] - 1) * (K[k] / K0[k] - 1);
    }
    return sqrt(sum / (2 * STARTS));
}

/* Rounding wanders: about as the root of the number of steps, and not in
 * proportion to it. */
TEST(the_integrals_are_kept_to_rounding)
{
    scene_load(&scene, "generic");
    for (int32_t k = COIN_SYMPLECTIC2; k <= COIN_SYMPLECTIC4; ++k) {
        const double few = integral_error(k, 0.025, 1000);
        const double many = integral_error(k, 0.025, 20000);
        check_note(
            "method %d: K off by %.3g after 1000 steps, %.3g after 20000",
            (int)k, few, many);
        check_within(many, 1e-15, 1e-13);
        check_within(log(many / few) / log(20), 0.25, 0.85);
    }
    /* RK4 loses them. */
    check(integral_error(COIN_RK4, 0.04, 1000) > 1e-8);
}
