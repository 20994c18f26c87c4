/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/random.h"
#include "support/table.h"

#include <math.h>

#define HALF_PI 1.5707963267948966

/* A row of turns.csv: a question, and its answer. */
struct turn {
    coin_params p;
    double lean, speed, radius;
    double theta, wY, wZ;
    double wY_lean, wZ_lean; /* d(ln wY), d(ln wZ) over d(theta) */
};

static struct turn turn_at(const struct table *t, size_t row)
{
    const struct turn c = {
        {table_at(t, row, "mass"),
         table_at(t, row, "radius"),
         table_at(t, row, "gravity"),
         table_at(t, row, "inertia_X"),
         table_at(t, row, "inertia_Z"),
         0,
         {0, 0}},
        table_at(t, row, "lean"),
        table_at(t, row, "speed"),
        table_at(t, row, "circle"),
        table_at(t, row, "theta"),
        table_at(t, row, "wY"),
        table_at(t, row, "wZ"),
        table_at(t, row, "wY_lean"),
        table_at(t, row, "wZ_lean"),
    };
    check_note("row %zu of turns.csv", row);
    return c;
}

/* The pose is 0, and the speed and radius of the centre are those asked for. */
static void check_circle(const coin_state *s, const coin_params *p,
                         double speed, double radius)
{
    double center, contact;
    check(s->phi == 0 && s->psi == 0 && s->x == 0 && s->z == 0 && s->wX == 0);
    check(s->wY > 0 && s->wY * s->wZ * s->theta >= 0);
    check_status(coin_steady_radii(s, p, &center, &contact), COIN_OK);
    check_near(center, radius, 16 * U * radius);
    const double off = 16 * U + U / cos(s->theta);
    check_near(fabs(s->wZ) * p->radius, speed, off * speed);
}

/* --------------------------------------------------------------- reference */
TEST(a_turn_is_the_reference_s)
{
    struct table t;
    int turns = 0;
    table_load(&t, "turns.csv");
    for (size_t row = 0; row < t.rows; ++row) {
        const struct turn c = turn_at(&t, row);
        if (c.lean == 0)
            continue;
        coin_state s;
        check_status(coin_steady_turn(&s, &c.p, c.lean, c.radius), COIN_OK);
        check(s.theta == c.lean);
        check_near(s.wY, c.wY, 8 * U * c.wY);
        check_near(s.wZ, c.wZ, 8 * U * fabs(c.wZ));
        check_circle(&s, &c.p, fabs(c.wZ) * c.p.radius, c.radius);
        ++turns;
    }
    check(turns > 50);
}

/* The speed to 16 u + u/cos theta: the lean and wY as that determines them. */
TEST(a_ride_is_the_reference_s)
{
    struct table t;
    int rides = 0;
    table_load(&t, "turns.csv");
    for (size_t row = 0; row < t.rows; ++row) {
        const struct turn c = turn_at(&t, row);
        if (c.lean != 0)
            continue;
        coin_state s;
        check_status(coin_steady_ride(&s, &c.p, c.speed, c.radius), COIN_OK);
        const double off = 16 * U + U / cos(c.theta);
        check_near(s.theta, c.theta, off / fabs(c.wZ_lean));
        check_near(s.wY, c.wY,
                   (8 * U + off * fabs(c.wY_lean / c.wZ_lean)) * c.wY);
        check_circle(&s, &c.p, c.speed, c.radius);
        ++rides;
    }
    check(rides > 50);
}

/* A coin of 12 mm rolls at 45 degrees round a circle of 40 mm, g = 9.8: by the
 * radius of the centre, and by that of the contact. */
TEST(a_quarter_at_45_degrees_takes_half_a_second)
{
    coin_params p;
    coin_state s;
    const double lean = HALF_PI / 2, a = 0.012;
    const struct {
        double radius, period;
    } cases[] = {{0.04, 0.500250},
                 {0.04 - 0.012 * 0.70710678118654752, 0.446068}};
    check_status(coin_params_disc(&p, 0.00567, a, 9.8), COIN_OK);
    for (int i = 0; i < 2; ++i) {
        const double R = cases[i].radius, T = cases[i].period;
        check_status(coin_steady_turn(&s, &p, lean, R), COIN_OK);
        check_near(4 * HALF_PI * cos(lean) / s.wY, T, 0.6e-6);
        coin_state run = s;
        check_status(coin_advance(&run, &p, T, 1e-12, NULL), COIN_OK);
        check_near(run.phi, 4 * HALF_PI, 1e-5);
        check_near(hypot(run.x, run.z), 0, 1e-5 * R);
    }
}

/* ------------------------------------------------------------------ limits */
TEST(a_turn_of_radius_0_is_the_spin)
{
    struct random r = random_begin(93);
    for (int i = 0; i < 100; ++i) {
        const coin_params p = random_coin(&r);
        const double lean = random_between(&r, -1.57, 1.57);
        coin_state spin, s, near;
        check_status(coin_steady_spin(&spin, &p, lean), COIN_OK);
        check_status(coin_steady_turn(&s, &p, lean, 0), COIN_OK);
        check_same(&s, &spin, sizeof s);
        check_status(coin_steady_turn(&near, &p, lean, 1e-20 * p.radius),
                     COIN_OK);
        check_near(near.wY, spin.wY,
                   1e-17 * spin.wY / fabs(lean) + 8 * U * spin.wY);
    }
}

/* Lean and roll mirrored, everything is. */
TEST(the_other_lean_is_the_mirror_image)
{
    struct random r = random_begin(94);
    for (int i = 0; i < 200; ++i) {
        const coin_params p = random_coin(&r);
        const double lean = random_between(&r, 1e-3, 1.57);
        const double radius = p.radius * random_between(&r, 0.01, 30);
        coin_state s, mirrored;
        check_status(coin_steady_turn(&s, &p, lean, radius), COIN_OK);
        check_status(coin_steady_turn(&mirrored, &p, -lean, radius), COIN_OK);
        check(mirrored.theta == -s.theta && mirrored.wZ == -s.wZ &&
              mirrored.wY == s.wY);
    }
}

/* wY^2 (K R/a + I_X s) = M g a s c, in numbers that do not cancel: down to a
 * lean of 1e-200, and to 1e-11 from flat. */
TEST(no_lean_is_too_small_or_too_flat)
{
    const coin_params p = disc();
    for (int e = 1; e <= 200; ++e) {
        const double lean = pow(10, -e);
        coin_state s;
        check_note("1e-%d from upright", e);
        check_status(coin_steady_turn(&s, &p, lean, 2), COIN_OK);
        /* wY^2 = lean/3; the next terms are of order lean. */
        check_near(s.wY, sqrt(lean / 3), (8 * U + lean) * s.wY);
        check_near(s.wZ, 2 * s.wY, (8 * U + lean * lean) * s.wZ);
    }
    for (int e = 1; e <= 11; ++e) {
        const double lean = HALF_PI - pow(10, -e);
        const double flat = HALF_PI - lean + 6.123233995736766e-17;
        coin_state s;
        check_note("1e-%d from flat", e);
        check_status(coin_steady_turn(&s, &p, lean, 2), COIN_OK);
        check_near(s.wY, sqrt(flat / 3.25), (8 * U + flat * flat) * s.wY);
    }
}

/* Slow on a large circle, the lean of a bicycle times K/m; fast, it lies down.
 */
TEST(a_ride_leans_by_its_speed)
{
    const coin_params p = disc();
    double last = 0;
    for (double v = 1e-8; v < 300; v *= 3) {
        coin_state s;
        check_status(coin_steady_ride(&s, &p, v, 100), COIN_OK);
        check(s.theta > last);
        const double A = 1.5 * v * v / 100, B = 0.25 * v * v / 1e4;
        const double off = 16 * U + 4 * U * tan(s.theta);
        check_within(tan(s.theta), A * (1 - off), (A + B) * (1 + off));
        last = s.theta;
    }
    check_within(last, 1.56, HALF_PI);
    coin_state flattest; /* tan theta = A + B to 1e-14 there */
    check_status(coin_steady_ride(&flattest, &p, 2390.4, 1), COIN_OK);
    check_near(HALF_PI - flattest.theta, 1e-7, 1e-11);
}

/* Where B is 1, T - s = A: T^3/2 for a small circle, to T^2. */
TEST(a_ride_at_the_rate_of_a_spin_has_its_lean)
{
    const coin_params p = disc();
    for (double R = 1e-9; R > 1e-90; R /= 1024) {
        const double T = cbrt(12 * R);
        coin_state s;
        check_note("radius %g", R);
        check_status(coin_steady_ride(&s, &p, 2 * R, R), COIN_OK);
        check_near(s.theta, T, (T * T + 16 * U) * T);
    }
}

/* ------------------------------------------------------------- round trips */
struct asked {
    double lean, speed, radius;
};

static struct asked random_circle(struct random *r, const coin_params *p)
{
    const double w = 1 / natural_time(p);
    const double R = pow(10, random_between(r, -3, 3));
    const double v = fmin(R, sqrt(R)) * pow(10, random_between(r, -3, 1));
    const struct asked c = {random_between(r, 0.01, 1.56), p->radius * w * v,
                            p->radius * R};
    return c;
}

/* Radius and speed read back, and each asked by what the other answers. */
TEST(speeds_and_leans_ask_for_the_same_circles)
{
    struct random r = random_begin(95);
    for (int i = 0; i < 2000; ++i) {
        const coin_params p = random_coin(&r);
        const struct asked c = random_circle(&r, &p);
        coin_state turn, ride, again;
        check_note("lean %g, speed %g, radius %g", c.lean, c.speed, c.radius);
        check_status(coin_steady_turn(&turn, &p, c.lean, c.radius), COIN_OK);
        const double speed = p.radius * turn.wZ;
        check_circle(&turn, &p, speed, c.radius);
        check_status(coin_steady_ride(&again, &p, speed, c.radius), COIN_OK);
        check_circle(&again, &p, speed, c.radius);
        check_status(coin_steady_ride(&ride, &p, c.speed, c.radius), COIN_OK);
        check_circle(&ride, &p, c.speed, c.radius);
    }
}

/* It is the branch of coin_steady_circle() with wY wZ theta > 0. */
TEST(the_circle_is_that_of_the_slow_branch)
{
    struct random r = random_begin(96);
    for (int i = 0; i < 500; ++i) {
        const coin_params p = random_coin(&r);
        const struct asked c = random_circle(&r, &p);
        coin_state s;
        check_status(coin_steady_turn(&s, &p, c.lean, c.radius), COIN_OK);
        const coin_state same = circle(&p, c.lean, s.wZ, 1);
        check_near(same.wY, s.wY, 32 * U * s.wY);
    }
}

/* ---------------------------------------------------------------- refusals */
TEST(a_bad_turn_is_refused_in_order)
{
    const coin_params good = disc();
    coin_params bad = good;
    bad.mass = -1;
    const struct {
        const coin_params *p;
        double theta, radius;
        int32_t want;
    } cases[] = {
        {NULL, 0.3, 1, COIN_EARG},
        {&bad, 0.3, -1, COIN_EARG},
        {&bad, 0.3, NAN, COIN_EARG},
        {&good, 0.3, -1e-300, COIN_EARG},
        {&bad, NAN, 1, COIN_EPARAMS},
        {&good, NAN, 1, COIN_ESTATE},
        {&good, 1.5707963267948966, 1, COIN_ESTATE},
        {&good, -2, 1, COIN_ESTATE},
        {&good, 1.57079, 1e9, COIN_ESTATE}, /* wZ = 1e7 */
        {&good, 0, 1, COIN_EDOMAIN},
        {&good, -0.0, 0, COIN_EDOMAIN},
        {&good, 0.3, 1.001e9, COIN_EDOMAIN},
        {&good, 0.3, INFINITY, COIN_EDOMAIN},
    };
    const coin_state before = {1, 2, 3, 4, 5, 6, 7, 8};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coin_state s = before;
        check_note("case %zu", i);
        check_status(
            coin_steady_turn(&s, cases[i].p, cases[i].theta, cases[i].radius),
            cases[i].want);
        check_same(&s, &before, sizeof s);
    }
    check_status(coin_steady_turn(NULL, &good, 0.3, 1), COIN_EARG);
}

TEST(a_bad_ride_is_refused_in_order)
{
    const coin_params good = disc();
    coin_params bad = good;
    bad.mass = -1;
    const struct {
        const coin_params *p;
        double speed, radius;
        int32_t want;
    } cases[] = {
        {NULL, 1, 1, COIN_EARG},
        {&bad, 0, 1, COIN_EARG},
        {&bad, 1, 0, COIN_EARG},
        {&good, -1, 1, COIN_EARG},
        {&good, NAN, 1, COIN_EARG},
        {&good, 1, -1, COIN_EARG},
        {&good, 1, NAN, COIN_EARG},
        {&bad, 1, 1, COIN_EPARAMS},
        {&good, 1e200, 1, COIN_ESTATE},
        {&good, INFINITY, 1, COIN_ESTATE},
        {&good, 1, INFINITY, COIN_EDOMAIN},
        {&good, 2390.5, 1, COIN_EDOMAIN}, /* tan theta = 1.00004e7 */
        {&good, 1, 1e-4, COIN_EDOMAIN},   /* 2.5e7 */
        {&good, 1e-200, 1, COIN_EDOMAIN}, /* 0 */
    };
    const coin_state before = {1, 2, 3, 4, 5, 6, 7, 8};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coin_state s = before;
        check_note("case %zu", i);
        check_status(
            coin_steady_ride(&s, cases[i].p, cases[i].speed, cases[i].radius),
            cases[i].want);
        check_same(&s, &before, sizeof s);
    }
    check_status(coin_steady_ride(NULL, &good, 1, 1), COIN_EARG);
}

/* Up to a slope of 1e7 also where it is made by the turning: v/R = 6000 round a
 * circle of 1e-3 radii. */
TEST(a_ride_may_be_as_steep_round_a_small_circle)
{
    const coin_params p = disc();
    const double R = 1e-3, v = 6000 * R;
    const double A = 1.5 * v * v / R, B = 0.25 * 6000 * 6000;
    coin_state s;
    check_status(coin_steady_ride(&s, &p, v, R), COIN_OK);
    /* tan theta = A + B to 1e-13; the lean is 1/tan theta from flat, to u. */
    check_near((HALF_PI - s.theta) * (A + B), 1, 4 * U * (A + B));
    check_status(coin_steady_ride(&s, &p, 6400 * R, R), COIN_EDOMAIN);
}
