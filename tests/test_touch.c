/* SPDX-License-Identifier: MIT */
/* The first touch of a flight, against Newton and Euler, and against a scan of
 * the gap that turns e_Z about the axis of the precession by the C library. */
#include "support/check.h"
#include "support/coins.h"
#include "support/thrown.h"

#include <math.h>

TEST(a_touch_is_that_of_newton_and_euler)
{
    static struct table t;
    table_load(&t, "toss/touches.csv");
    for (size_t i = 0; i < t.rows; ++i) {
        const coin_body b = body_in_row(&t, i, "");
        const coin_body want = body_in_row(&t, i, "1");
        const double when = table_at(&t, i, "t_touch");
        const double speed = table_at(&t, i, "u_y");
        coin_priv_flight f;
        coin_priv_coin c = coin_of(&b, 0);
        coin_priv_flight_of(&f, &c, table_at(&t, i, "I_X"),
                            table_at(&t, i, "I_Z"), 0);
        const coin_priv_touch at = coin_priv_first_touch(&f, 40, gap(&b) < U);
        const double most = 8 * U * (1 + when) * (3 + f.rate);
        check_note("row %zu", i);
        check(at.touches && at.looks <= 8);
        check_near(at.t, when, most / fmin(1, fabs(speed)));
        coin_priv_fly(&c, &f, at.t);
        const coin_body got = body_of(&c);
        check_near(coin_priv_rim_of(&c, 0).y, speed, 8 * most * (1 + f.rate));
        check_near(bodies_apart(&got, &want), 0, 8 * most * (1 + f.rate));
        const coin_priv_touch none =
            coin_priv_first_touch(&f, at.t * (1 - 1e-9), gap(&want) < U);
        check(!none.touches);
    }
}

/* How high the lowest point is after t. */
static double gap_after(const coin_priv_flight *f, double t)
{
    const double b = f->angular, turned = b > 0 ? -expm1(-b * t) / b : t;
    const double a = f->rate * turned, s = sin(a), c = cos(a);
    const double along = (1 - c) * f->kZ;
    const double X = s * f->kY + along * f->kX;
    const double Y = along * f->kY - s * f->kX, Z = c + along * f->kZ;
    const double h = f->from.th.s * Y + f->from.th.c * Z;
    const double y = f->from.th.c * Y - f->from.th.s * Z;
    return f->from.y + t * f->from.vy - t * t / 2 -
           (hypot(X, h) + f->from.half * fabs(y));
}

/* Where the centre may be low enough: from the time at which it falls below
 * 1 + h, or all the time. */
static double from(const coin_priv_flight *f)
{
    const double above = f->from.y - (1 + f->from.half), vy = f->from.vy;
    return above > 0 ? vy + sqrt(vy * vy + 2 * above) : 0;
}

/* A flight from any height up to 1e6 radii, spins up to 100; half of them from
 * just above the table, half of a coin with a thickness. */
static coin_priv_flight any_flight(struct random *r)
{
    const coin_params p = random_body(r);
    const double high = pow(10, random_between(r, -6, 6));
    coin_body b = random_throw(r, high, pow(10, random_between(r, -3, 2)));
    const double half =
        random_between(r, 0, 1) < 0.5 ? random_between(r, 0.01, 1) : 0;
    coin_priv_flight f;
    if (random_between(r, 0, 1) < 0.5) {
        b.y = cos(b.s.theta) + pow(10, random_between(r, -12, 0));
        b.vy /= 10;
    }
    b.y += half * fabs(sin(b.s.theta));
    const coin_priv_coin c = coin_of(&b, half);
    const double angular =
        random_between(r, 0, 1) < 0.5 ? pow(10, random_between(r, -3, 1)) : 0;
    coin_priv_flight_of(&f, &c, p.inertia_X, p.inertia_Z, angular);
    return f;
}

/* The rounding of the gap. */
static double noise(const coin_priv_flight *f, double t)
{
    return 16 * U * (1 + f->from.half) *
           (1 + fabs(f->from.y) + t * (fabs(f->from.vy) + t) + f->rate * t);
}

TEST(no_touch_is_missed)
{
    enum { SCANNED = 200 };
    struct random r = random_begin(831);
    const int count = tries_asked(20000);
    long looks = 0;
    int ended = 0;
    for (int i = 0; i < count; ++i) {
        const coin_priv_flight f = any_flight(&r);
        const double vy = f.from.vy;
        const double end = vy + sqrt(vy * vy + 2 * f.from.y);
        coin_priv_touch at = {0, 0, 0};
        at = coin_priv_first_touch(&f, end, 0);
        check_note("seed 831, flight %d", i);
        /* A turn that fades, or a thickness, may need more looks than a search
         * has; it is none up to where the search ends. */
        check(at.touches || f.angular > 0 || f.from.half > 0);
        looks += at.looks;
        const double none = noise(&f, at.t);
        if (at.touches)
            check_near(gap_after(&f, at.t), 0, none);
        ended += !at.touches;
        const double start = fmax(from(&f), at.t - 60 / (1 + f.rate));
        for (int k = 0; k < SCANNED; ++k) {
            const double t = start + (at.t - start) * k / SCANNED;
            check(gap_after(&f, t) > -none);
        }
    }
    check(looks < 12L * count && ended < count / 1000);
}

/* How deep a dip may be that is passed over. */
#define PASSED_OVER 1e-14

/* A flight that leaves the table, however slowly, comes back later. */
TEST(a_start_on_the_table_is_no_touch)
{
    struct random r = random_begin(832);
    for (int i = 0; i < 5000; ++i) {
        const coin_params p = random_body(&r);
        coin_body b = random_throw(&r, 0, 20);
        const double speed = pow(10, random_between(&r, -9, 0));
        b.y = cos(b.s.theta);
        b.vy = speed - b.s.wX * sin(b.s.theta);
        coin_priv_flight f;
        const coin_priv_coin c = coin_of(&b, 0);
        coin_priv_flight_of(&f, &c, p.inertia_X, p.inertia_Z, 0);
        const coin_priv_touch at = coin_priv_first_touch(&f, 40, 1);
        check_note("seed 832, flight %d, speed %g", i, speed);
        const double none = noise(&f, at.t);
        check(!at.touches || at.t > 0);
        for (int k = 1; k < 50; ++k)
            check(gap_after(&f, at.t * k / 50) > -none - PASSED_OVER);
    }
}

/* So it is where a coin comes down flat, to rounding. */
TEST(a_centre_just_below_the_table_may_leave_it)
{
    const coin_params p = disc();
    coin_body b = {.s = {.theta = acos(0x1p-52), .wX = 2e-3}, .y = -U / 8};
    coin_priv_flight f;
    b.vy = 3e-3;
    const coin_priv_coin c = coin_of(&b, 0);
    coin_priv_flight_of(&f, &c, p.inertia_X, p.inertia_Z, 0);
    const coin_priv_touch at = coin_priv_first_touch(&f, 0.02, 1);
    check(at.t >= 0 && at.t <= 0.02);
}

/* A coin that rises comes down with its rim as it turns, though its centre is
 * soon high enough. */
TEST(a_rim_touches_while_the_centre_rises)
{
    const coin_params p = disc();
    const coin_table f = {.mu_static = 0.2, .mu_kinetic = 0.2};
    coin_body b = {.s = {.theta = 1.3, .wX = -10}, .y = 0.3, .vy = 3};
    double t;
    check_status(coin_move(&b, &p, &f, 1, 1e-9, COIN_TOUCHES, &t),
                 COIN_LIFTS | COIN_TOUCHES);
    check_within(t, 0, 0.13);
}
