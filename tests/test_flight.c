/* SPDX-License-Identifier: MIT */
/* A coin in the air, against Newton and Euler in the table's frame. */
#include "support/check.h"
#include "support/thrown.h"

#include <air.h>

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
        coin_body b = body_in_row(&t, i, "");
        const coin_body want = body_in_row(&t, i, "1");
        const double after = table_at(&t, i, "t");
        coin_priv_flight f;
        coin_priv_attitude at = coin_priv_attitude_of(&b.s);
        coin_priv_flight_of(&f, &b, &at, table_at(&t, i, "I_X"),
                            table_at(&t, i, "I_Z"));
        coin_priv_fly(&b, &at, &f, after);
        check_note("row %zu", i);
        check_near(bodies_apart(&b, &want), 0, LEAST_DIGITS * angle(&f, after));
    }
}

/* The attitude that a flight ends with is that of its angles. */
#define SAME (4 * U)

static coin_body flown(const coin_body *b, const coin_params *p, double t)
{
    coin_body to = *b;
    coin_priv_flight f;
    coin_priv_attitude at = coin_priv_attitude_of(&b->s);
    coin_priv_flight_of(&f, b, &at, p->inertia_X, p->inertia_Z);
    coin_priv_fly(&to, &at, &f, t);
    const coin_priv_attitude now = coin_priv_attitude_of(&to.s);
    check_near(at.th.s, now.th.s, SAME);
    check_near(at.th.c, now.th.c, SAME);
    check_near(at.ph.s, now.ph.s, SAME);
    check_near(at.ph.c, now.ph.c, SAME);
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
