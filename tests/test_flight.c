/* SPDX-License-Identifier: MIT */
/* A coin in the air, against Newton and Euler in the table's frame. */
#include "support/check.h"
#include "support/thrown.h"

#include <math.h>

/* The error of a flight, over 1 + the angle that it turns by. */
#define LEAST_DIGITS 4e-15

static double angle(const coin_priv_flight *f, double t)
{
    return 1 + (f->rate + fabs(f->sigma)) * t;
}

TEST(a_flight_is_that_of_newton_and_euler)
{
    static struct table t;
    table_load(&t, "toss/flights.csv");
    for (size_t i = 0; i < t.rows; ++i) {
        const coin_body b = body_in_row(&t, i, "");
        const coin_body want = body_in_row(&t, i, "1");
        const double after = table_at(&t, i, "t");
        coin_priv_flight f;
        coin_priv_coin c = coin_of(&b, 0);
        coin_priv_flight_of(&f, &c, table_at(&t, i, "I_X"),
                            table_at(&t, i, "I_Z"), 0);
        coin_priv_fly(&c, &f, after);
        const coin_body got = body_of(&c);
        check_note("row %zu", i);
        check_near(bodies_apart(&got, &want), 0,
                   LEAST_DIGITS * angle(&f, after));
    }
}

/* The attitude that a flight ends with is that of its angles. */
#define SAME (4 * U)

static coin_body flown(const coin_body *b, const coin_params *p, double t)
{
    coin_priv_flight f;
    coin_priv_coin c = coin_of(b, 0);
    coin_priv_flight_of(&f, &c, p->inertia_X, p->inertia_Z, 0);
    coin_priv_fly(&c, &f, t);
    const coin_body to = body_of(&c);
    const coin_priv_coin now = coin_of(&to, 0);
    check_near(c.th.s, now.th.s, SAME);
    check_near(c.th.c, now.th.c, SAME);
    check_near(c.ph.s, now.ph.s, SAME);
    check_near(c.ph.c, now.ph.c, SAME);
    return to;
}

/* Poses as rotations: angles are ill conditioned where the face is
 * horizontal. */
static double turned_apart(const coin_body *a, const coin_body *b)
{
    double q[4], r[4], plus = 0, minus = 0;
    coin_quaternion(&a->s, q);
    coin_quaternion(&b->s, r);
    for (int i = 0; i < 4; ++i) {
        plus = fmax(plus, fabs(q[i] + r[i]));
        minus = fmax(minus, fabs(q[i] - r[i]));
    }
    return fmin(plus, minus);
}

static double omegas_apart(const coin_body *a, const coin_body *b)
{
    double u[3], v[3], most = 0;
    coin_angular_velocity(&a->s, u);
    coin_angular_velocity(&b->s, v);
    for (int i = 0; i < 3; ++i)
        most = fmax(most, fabs(u[i] - v[i]));
    return most;
}

/* Where the table is no matter. */
static double energy(const coin_body *b, const coin_params *p)
{
    const coin_state *s = &b->s;
    return (b->vx * b->vx + b->vy * b->vy + b->vz * b->vz +
            p->inertia_X * (s->wX * s->wX + s->wY * s->wY) +
            p->inertia_Z * s->wZ * s->wZ) /
               2 +
           b->y;
}

TEST(a_flight_in_parts_is_the_whole)
{
    struct random r = random_begin(821);
    for (int i = 0; i < 2000; ++i) {
        const coin_params p = random_body(&r);
        const coin_body b = random_throw(&r, 50, 60);
        const double t = random_between(&r, 0, 3);
        const coin_body whole = flown(&b, &p, t);
        coin_body parts = b;
        for (int k = 0; k < 10; ++k)
            parts = flown(&parts, &p, t / 10);
        check_note("seed 821, throw %d", i);
        const double turns = 1 + 120 * t;
        check_near(turned_apart(&whole, &parts), 0, 1e-14 * turns);
        check_near(omegas_apart(&whole, &parts), 0, 1e-12 * turns);
        check_near(parts.y, whole.y, 1e-13 * (1 + fabs(whole.y)));
        check_near(energy(&whole, &p), energy(&b, &p), 1e-14 * (1e4 + turns));
        check_within(whole.s.phi, -3.1415926535897932, 3.1415926535897932);
        check_within(whole.s.psi, -3.1415926535897940, 3.1415926535897940);
    }
}

/* The pass changes the face, and theta turns back from pi/2. */
TEST(a_face_passes_the_horizontal)
{
    const coin_params p = thrown_params(0.25, 0.5);
    for (int i = 0; i < 200; ++i) {
        const double aside = i % 2 ? pow(10, -i / 10.0) : 0;
        coin_body b = {.s = {.theta = 1.2, .phi = 0.3, .psi = 0.2, .wX = 2},
                       .y = 5};
        b.s.wY = aside;
        const double t = (1.5707963267948966 - 1.2) / 2;
        const coin_body at = flown(&b, &p, t), past = flown(&b, &p, 2 * t);
        const coin_body twice = flown(&at, &p, t);
        check_note("wY %g", aside);
        check_near(turned_apart(&twice, &past), 0, 1e-14);
        check_near(omegas_apart(&twice, &past), 0, 1e-13);
        check_status(coin_state_check(&at.s, &p), COIN_OK);
        check_near(past.s.theta, 1.2, 1e-13 + aside * aside);
        check(past.s.wX < 0);
    }
}

/* ----------------------------------------------------------- slowed flights */
TEST(what_is_left_of_a_turn_is_an_exponential)
{
    for (double x = 1e-20; x < 1e19; x *= 1.07) {
        const coin_priv_decay at = coin_priv_decay_of(x);
        check_note("x %g", x);
        check_near(at.left, (double)expl(-(long double)x), 8 * U);
        check_near(at.part / (double)(-expm1l(-(long double)x) / x), 1, 32 * U);
    }
    const coin_priv_decay none = coin_priv_decay_of(0);
    check(none.left == 1 && none.part == 1);
}

/* A vector turned about a unit vector. */
static void turn_about(const double k[3], double by, double v[3])
{
    const double s = sin(by), c = cos(by);
    const double along = k[0] * v[0] + k[1] * v[1] + k[2] * v[2];
    const double across[3] = {k[1] * v[2] - k[2] * v[1],
                              k[2] * v[0] - k[0] * v[2],
                              k[0] * v[1] - k[1] * v[0]};
    for (int i = 0; i < 3; ++i)
        v[i] = c * v[i] + s * across[i] + (1 - c) * along * k[i];
}

/* The angular momentum in the table's frame. */
static void momentum_of(const coin_body *b, const coin_params *p, double L[3])
{
    double R[9];
    coin_angular_velocity(&b->s, L);
    coin_axes(&b->s, R);
    for (int i = 0; i < 3; ++i)
        L[i] = p->inertia_X * L[i] +
               (p->inertia_Z - p->inertia_X) * b->s.wZ * R[6 + i];
}

/* The torque -b L keeps the direction of L, about which the axis turns at
 * |L|/I_X: by the integral of exp(-b t) in all. */
TEST(a_slowed_flight_turns_about_its_momentum)
{
    const int count = tries_asked(2000);
    struct random r = random_begin(826);
    for (int i = 0; i < count; ++i) {
        const coin_params p = random_body(&r);
        const coin_table f = {.losses.angular =
                                  pow(10, random_between(&r, -3, 1))};
        const double rate = f.losses.angular, t = random_between(&r, 0, 3);
        const double left = exp(-rate * t), turned = -expm1(-rate * t) / rate;
        coin_body b = random_throw(&r, 50, 20), to = b;
        b.y = to.y += 100;
        double L[3], k[3], n[9], m[9], M[3], moved;
        momentum_of(&b, &p, L);
        const double size = sqrt(L[0] * L[0] + L[1] * L[1] + L[2] * L[2]);
        for (int j = 0; j < 3; ++j)
            k[j] = L[j] / size;
        coin_axes(&b.s, n);
        check_note("seed 826, throw %d", i);
        check_status(coin_move(&to, &p, &f, t, 1e-9, 0, &moved), COIN_LIFTS);
        momentum_of(&to, &p, M);
        coin_axes(&to.s, m);
        turn_about(k, size / p.inertia_X * turned, n + 6);
        const double angle = 1 + size / p.inertia_X * turned;
        for (int j = 0; j < 3; ++j) {
            check_near(M[j], L[j] * left, 1e-14 * angle * size);
            check_near(m[6 + j], n[6 + j], 1e-14 * angle);
        }
        check_near(to.s.wZ, b.s.wZ * left, 8 * U * fabs(b.s.wZ));
        check_near(to.y, b.y + t * (b.vy - t / 2), 1e-13 * b.y);
    }
}

TEST(angular_damping_slows_the_turn_about_the_axis)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.losses.angular = 0.5};
    const coin_body start = {.s = {.theta = 0.3, .wZ = 1.5}, .y = 100};
    coin_body b = start;
    check_status(coin_move(&b, &p, &f, 2, 1e-9, 0, NULL), COIN_LIFTS);
    check_near(b.s.psi, 1.5 * (1 - exp(-1)) / 0.5, 1e-14);
}
