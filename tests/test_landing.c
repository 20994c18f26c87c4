/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/floats.h"
#include "support/random.h"

#include <coinf.h>

#include <math.h>

enum { TRIED = 500 };

/* A body as an engine holds it. */
struct body {
    double q[4], omega[3], v[3];
};

/* One in a pose that coin_state has, and with a motion of its own. */
static struct body any_body(struct random *r, const coin_params *p,
                            coin_state *pose)
{
    struct body b;
    const double w = 3 / natural_time(p);
    *pose = random_state(r, p, 1.5);
    check_status(coin_quaternion(pose, b.q), COIN_OK);
    for (int i = 0; i < 3; ++i) {
        b.omega[i] = w * random_between(r, -1, 1);
        b.v[i] = p->radius * w * random_between(r, -1, 1);
    }
    return b;
}

static void cross(const double u[3], const double v[3], double out[3])
{
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = u[j] * v[k] - u[k] * v[j];
    }
}

static double dot(const double u[3], const double v[3])
{
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

/* The angular momentum about the point that touches, from I_X omega + (I_Z -
 * I_X) (omega e_Z) e_Z and M r x v, all along the table's axes. */
static void momentum(double L[3], const coin_params *p, const double R[9],
                     const double omega[3], const double v[3])
{
    const double spin = dot(omega, R + 6) * (p->inertia_Z - p->inertia_X);
    double rv[3];
    cross(R + 3, v, rv);
    for (int i = 0; i < 3; ++i)
        L[i] = p->inertia_X * omega[i] + spin * R[6 + i] +
               p->mass * p->radius * rv[i];
}

static void the_angular_momentum_about_the_contact_is_kept(void **unused)
{
    (void)unused;
    struct random r = random_begin(171);
    for (int n = 0; n < TRIED; ++n) {
        const coin_params p = random_coin(&r);
        coin_state pose, s;
        const struct body b = any_body(&r, &p, &pose);
        double R[9], omega[3], v[3], before[3], after[3];
        check_status(
            coin_state_from_landing(&s, &p, b.q, b.omega, b.v, pose.x, pose.z),
            COIN_OK);
        check_status(coin_axes(&s, R), COIN_OK);
        check_status(coin_angular_velocity(&s, omega), COIN_OK);
        check_status(coin_velocity(&s, &p, v), COIN_OK);
        momentum(before, &p, R, b.omega, b.v);
        momentum(after, &p, R, omega, v);
        /* Three terms of 16 u, and the arithmetic here. */
        const double size =
            15 * p.mass * p.radius * p.radius / natural_time(&p);
        for (int i = 0; i < 3; ++i)
            check_near(after[i], before[i], 64 * U * size);
        check(s.x == pose.x && s.z == pose.z);
    }
}

static double energy_of(const coin_params *p, const coin_state *s,
                        const struct body *b)
{
    double R[9];
    check_status(coin_axes(s, R), COIN_OK);
    const double wZ = dot(b->omega, R + 6), w2 = dot(b->omega, b->omega);
    return 0.5 * (p->mass * dot(b->v, b->v) + p->inertia_X * (w2 - wZ * wZ) +
                  p->inertia_Z * wZ * wZ) +
           p->mass * p->gravity * p->radius * cos(s->theta);
}

static void no_landing_gains_energy(void **unused)
{
    (void)unused;
    struct random r = random_begin(172);
    for (int n = 0; n < TRIED; ++n) {
        const coin_params p = random_coin(&r);
        coin_state pose, s;
        const struct body b = any_body(&r, &p, &pose);
        check_status(coin_state_from_landing(&s, &p, b.q, b.omega, b.v, 0, 0),
                     COIN_OK);
        check(coin_energy(&s, &p) < energy_of(&p, &s, &b));
    }
}

static void a_coin_that_rolls_rolls_on(void **unused)
{
    (void)unused;
    struct random r = random_begin(173);
    for (int n = 0; n < TRIED; ++n) {
        const coin_params p = random_coin(&r);
        const coin_state from = random_state(&r, &p, 1.5);
        double q[4], omega[3], v[3];
        coin_state want, s;
        check_status(coin_quaternion(&from, q), COIN_OK);
        check_status(coin_angular_velocity(&from, omega), COIN_OK);
        check_status(coin_velocity(&from, &p, v), COIN_OK);
        check_status(
            coin_state_from_motion(&want, &p, q, omega, from.x, from.z),
            COIN_OK);
        check_status(
            coin_state_from_landing(&s, &p, q, omega, v, from.x, from.z),
            COIN_OK);
        /* Rates of up to 2 in natural units; q and so the frame are uncertain
         * by 8 u/cos(theta). */
        const double w = 64 * U / cos(from.theta) / natural_time(&p);
        check_same(&s, &want, 5 * sizeof(double));
        check_near(s.wX, want.wX, w);
        check(s.wY == want.wY);
        check_near(s.wZ, want.wZ, w);
    }
}

/* A disc of mass, radius and gravity 1: J = 5/4 m, K = 3/2 m. */
static void landings_that_can_be_told_by_eye(void **unused)
{
    (void)unused;
    const double h = sqrt(0.5), upright[] = {1, 0, 0, 0}, none[3] = {0};
    const double leaning[] = {cos(0.25), sin(0.25), 0, 0};
    const double turned[] = {h, 0, h, 0};
    const struct {
        const char *what;
        const double *q;
        double v[3], wX, wZ;
    } of[] = {
        {"straight down, upright", upright, {0, -1, 0}, 0, 0},
        {"slides along its plane: 2/3 of the speed",
         upright,
         {-1, 0, 0},
         0,
         2.0 / 3},
        {"slides along its axis: it tips", upright, {0, 0, 1}, 0.8, 0},
        {"along its plane, which is turned", turned, {0, 0, 1}, 0, 2.0 / 3},
        {"straight down, leaning: it tips further",
         leaning,
         {0, -1, 0},
         0.8 * sin(0.5),
         0},
        {"straight up, leaning", leaning, {0, 1, 0}, -0.8 * sin(0.5), 0},
    };
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    for (size_t i = 0; i < sizeof of / sizeof *of; ++i) {
        coin_state s;
        check_note("%s", of[i].what);
        check_status(
            coin_state_from_landing(&s, &p, of[i].q, none, of[i].v, 3, 4),
            COIN_OK);
        check_near(s.wX, of[i].wX, 16 * U);
        check(s.wY == 0);
        check_near(s.wZ, of[i].wZ, 16 * U);
        check(s.x == 3 && s.z == 4);
    }
}

static void a_landing_without_a_state_is_refused(void **unused)
{
    (void)unused;
    const double r = sqrt(0.5);
    const struct {
        const char *why;
        double q[4], omega[3], v[3];
    } bad[] = {
        {"q is 0", {0, 0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
        {"flat", {r, r, 0, 0}, {0, 0, 0}, {0, 0, 0}},
        {"omega has a NaN", {1, 0, 0, 0}, {0, NAN, 0}, {0, 0, 0}},
        {"v has a NaN", {1, 0, 0, 0}, {0, 0, 0}, {0, 0, NAN}},
        {"v is infinite", {1, 0, 0, 0}, {0, 0, 0}, {INFINITY, 0, 0}},
        {"v is infinite along Y", {1, 0, 0, 0}, {0, 0, 0}, {0, INFINITY, 0}},
        {"v is absurd", {1, 0, 0, 0}, {0, 0, 0}, {0, 0, -1e200}},
    };
    const coin_state before = {1, 2, 3, 4, 5, 6, 7, 8};
    coin_state s = before;
    coin_params p, heavy;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    heavy = p;
    heavy.mass = -1;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        check_note("%s", bad[i].why);
        check_status(coin_state_from_landing(&s, &p, bad[i].q, bad[i].omega,
                                             bad[i].v, 0, 0),
                     COIN_ESTATE);
        check_status(coin_state_from_landing(&s, &heavy, bad[i].q, bad[i].omega,
                                             bad[i].v, 0, 0),
                     COIN_EPARAMS);
        check_status(coin_state_from_landing(&s, &heavy, bad[i].q, bad[i].omega,
                                             NULL, 0, 0),
                     COIN_EARG);
        check_same(&s, &before, sizeof s);
    }
    check_status(coin_state_from_landing(NULL, &p, bad[4].q, bad[4].omega,
                                         bad[0].v, 0, 0),
                 COIN_EARG);
    check_status(coin_state_from_landing(&s, &p, bad[4].q, bad[4].omega,
                                         bad[0].v, INFINITY, 0),
                 COIN_ESTATE);
    check_same(&s, &before, sizeof s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(the_angular_momentum_about_the_contact_is_kept),
        TEST(no_landing_gains_energy),
        TEST(a_coin_that_rolls_rolls_on),
        TEST(landings_that_can_be_told_by_eye),
        TEST(a_landing_without_a_state_is_refused),
    };
    return RUN_TESTS(tests);
}
