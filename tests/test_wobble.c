/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/random.h"

#include <math.h>

/* Steady motions of each kind, M = a = g = 1. */
struct kind {
    const char *name;
    double inner, theta, wY, wZ;
    int32_t branch; /* of a circle; else wY and wZ are as they stand */
    double longest; /* unstable ones are followed less far */
};

static const struct kind kinds[] = {
    {"slow circle", 0, 0.4, 0, 1, 1, 30},
    {"fast circle", 0.5, 0.4, 0, 1, -1, 30},
    {"backward circle", 0, -0.7, 0, -0.8, -1, 30},
    {"steep circle of a hoop", 1, 1.2, 0, 2, 1, 30},
    {"unstable circle", 0, 0.15, 0, 0.5, 1, 3},
    {"roll", 0, 0, 0, 1, 0, 30},
    {"unstable roll", 0.9, 0, 0, 0.3, 0, 3},
    {"leaning spin", 0, 0.6, 0, 0, 1, 30},
    {"upright spin", 0, 0, 1.2, 0, 0, 30},
    {"unstable upright spin", 1, 0, -0.5, 0, 0, 3},
};
enum { KINDS = sizeof kinds / sizeof *kinds };

static coin_params ring(double inner)
{
    coin_params p;
    check_status(coin_params_ring(&p, 1, 1, inner, 1), COIN_OK);
    return p;
}

static coin_state motion_of(const struct kind *k, const coin_params *p)
{
    coin_state s = {k->theta, 0, 0, 0, 0, 0, k->wY, k->wZ};
    if (k->branch)
        check_status(coin_steady_circle(&s, p, k->theta, k->wZ, k->branch),
                     COIN_OK);
    return s;
}

/* A start off the steady motion by A, off its leaf too, at some pose. */
static coin_state off_by(const coin_state *steady, double A)
{
    const coin_state s = {
        steady->theta + 0.7 * A, 0.5, 2, 1, -3, -0.5 * A, steady->wY + 0.6 * A,
        steady->wZ + 0.4 * A,
    };
    return s;
}

static coin_state wobble(const coin_state *steady, const coin_params *p,
                         const coin_state *start, double t)
{
    coin_state s;
    check_status(coin_wobble_at(steady, p, start, t, &s), COIN_OK);
    return s;
}

static void refused(const coin_state *steady, const coin_state *start, double t,
                    int32_t why)
{
    const coin_params p = ring(0);
    coin_state out = {1, 2, 3, 4, 5, 6, 7, 8};
    const coin_state before = out;
    check_status(coin_wobble_at(steady, &p, start, t, &out), why);
    check_same(&out, &before, sizeof out);
}

static double largest_difference(const coin_state *a, const coin_state *b)
{
    const double d[8] = {
        a->theta - b->theta, a->phi - b->phi, a->psi - b->psi, a->x - b->x,
        a->z - b->z,         a->wX - b->wX,   a->wY - b->wY,   a->wZ - b->wZ,
    };
    double most = 0;
    for (int i = 0; i < 8; ++i)
        most = fmax(most, fabs(d[i]));
    return most;
}

/* Against the full equations, in natural units. */
static double error_at(const coin_state *steady, const coin_params *p, double A,
                       double t)
{
    const coin_state start = off_by(steady, A);
    const coin_state near = wobble(steady, p, &start, t);
    coin_state full = start;
    check_status(coin_advance(&full, p, t, 1e-13, NULL), COIN_OK);
    return largest_difference(&near, &full);
}

/* A quarter of the distance, a sixteenth of the error, in all members and on
 * both sides of the start: nothing of first order is missing.  The next order
 * changes the ratio by some A times t. */
static void its_error_is_of_second_order(void **unused)
{
    (void)unused;
    for (int i = 0; i < KINDS; ++i) {
        const coin_params p = ring(kinds[i].inner);
        const coin_state steady = motion_of(&kinds[i], &p);
        const double times[] = {-3, 3, kinds[i].longest};
        for (int k = 0; k < 3; ++k) {
            const double error = error_at(&steady, &p, 2e-4, times[k]);
            check_note("%s, t = %g", kinds[i].name, times[k]);
            check_within(error / error_at(&steady, &p, 5e-5, times[k]), 15.5,
                         16.5);
        }
    }
}

/* The lean turns as often as the heading: the path drifts, and its integral
 * has a vanishing exponent. */
static void resonance_with_the_heading_is_no_exception(void **unused)
{
    (void)unused;
    const coin_params p = ring(0);
    double low = 0.05, high = 1, wZ = 0, ratio = 0;
    coin_state s;
    for (int i = 0; i < 60; ++i) {
        double L;
        wZ = (low + high) / 2;
        check_status(coin_steady_circle(&s, &p, 0.4, wZ, 1), COIN_OK);
        check_status(coin_stability(&s, &p, &L), COIN_OK);
        ratio = -L * pow(cos(0.4) / s.wY, 2);
        *(ratio < 1 ? &low : &high) = wZ;
    }
    check_near(ratio, 1, 1e-14);
    const double error = error_at(&s, &p, 2e-4, 30);
    check_within(error / error_at(&s, &p, 5e-5, 30), 15.5, 16.5);
}

static void it_begins_where_the_start_is(void **unused)
{
    (void)unused;
    for (int i = 0; i < KINDS; ++i) {
        const coin_params p = ring(kinds[i].inner);
        const coin_state steady = motion_of(&kinds[i], &p);
        const coin_state start = off_by(&steady, 0.01);
        const coin_state s = wobble(&steady, &p, &start, 0);
        check_note("%s", kinds[i].name);
        check_same(&s, &start, sizeof s);
    }
}

/* The closed form of coin_steady_at(), by other sines: rounding is left, of
 * angles up to 300 and paths up to 30. */
static void a_steady_start_stays_steady(void **unused)
{
    (void)unused;
    for (int i = 0; i < KINDS; ++i) {
        const coin_params p = ring(kinds[i].inner);
        const coin_state steady = motion_of(&kinds[i], &p);
        const double t = kinds[i].longest;
        const coin_state s = wobble(&steady, &p, &steady, t);
        coin_state want;
        check_note("%s", kinds[i].name);
        check_status(coin_steady_at(&steady, &p, t, &want), COIN_OK);
        check_near(largest_difference(&s, &want), 0, 4 * 300 * U);
    }
}

/* A motion counts as steady if it is so to 1e-9.  What is left of (39) makes it
 * wobble by some 1e-10, which the answer has to 1e-12. */
static void a_start_steady_to_1e_9_wobbles_by_what_is_left(void **unused)
{
    (void)unused;
    for (int i = 0; i < 4; ++i) {
        const coin_params p = ring(kinds[i].inner);
        coin_state start = motion_of(&kinds[i], &p);
        start.wZ += 5e-10;
        coin_state want = start;
        const coin_state s = wobble(&start, &p, &start, 30);
        check_status(coin_advance(&want, &p, 30, 1e-13, NULL), COIN_OK);
        check_note("%s", kinds[i].name);
        check_near(largest_difference(&s, &want), 0, 30 * 1e-13);
    }
}

/* Lengths, times and masses in units that are powers of two: the same bits. */
static void units_a_power_of_two_apart_give_the_same_bits(void **unused)
{
    (void)unused;
    for (int i = 0; i < KINDS; ++i) {
        coin_params p = ring(kinds[i].inner), q;
        check_status(coin_params_ring(&q, 8, 4, 4 * kinds[i].inner, 1),
                     COIN_OK);
        const coin_state steady = motion_of(&kinds[i], &p);
        const coin_state start = off_by(&steady, 0.01);
        coin_state slow = steady, begun = start;
        slow.wY /= 2;
        slow.wZ /= 2;
        begun.wX /= 2;
        begun.wY /= 2;
        begun.wZ /= 2;
        begun.x *= 4;
        begun.z *= 4;
        const coin_state a = wobble(&steady, &p, &start, 1.5);
        coin_state b = wobble(&slow, &q, &begun, 3);
        b.wX *= 2;
        b.wY *= 2;
        b.wZ *= 2;
        b.x /= 4;
        b.z /= 4;
        check_note("%s", kinds[i].name);
        check_same(&b, &a, sizeof a);
    }
}

/* ----------------------------------------------------------------- critical */
/* A roll with this lambda^2: (45). */
static coin_state roll_of(const coin_params *p, double lambda2)
{
    const coin_state s = {0, 0, 0, 0,
                          0, 0, 0, sqrt(1.0 / 3 - lambda2 * 5 / 12)};
    double L;
    check_status(coin_stability(&s, p, &L), COIN_OK);
    check_near(L, lambda2, 10 * U);
    return s;
}

/* The start leans by A on the leaf of a roll. */
static coin_state leaning(const coin_state *roll, double A)
{
    coin_state s = *roll;
    s.theta = A;
    s.wY = 2 * roll->wZ * A;
    return s;
}

/* After 500 units the phase is about 1/2, so that all differ. */
static void near_critical_it_grows_or_swings_by_its_lambda(void **unused)
{
    (void)unused;
    const coin_params p = ring(0);
    const struct {
        double L, want;
    } rows[] = {
        {1.1e-6, cosh(sqrt(1.1) / 2)},
        {0.9e-6, cosh(sqrt(0.9) / 2)},
        {0, cos(5e-4)},
        {-0.9e-6, cos(sqrt(0.9) / 2)},
        {-1.1e-6, cos(sqrt(1.1) / 2)},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        const coin_state roll = roll_of(&p, rows[i].L);
        const coin_state start = leaning(&roll, 1e-8);
        const coin_state s = wobble(&roll, &p, &start, 500);
        check_note("lambda^2 = %g", rows[i].L);
        /* L is off by 10 u of 1, 1e-9 of itself; half of that in the phase. */
        check_near(s.theta / 1e-8, rows[i].want, 4e-9);
    }
}

/* The lean of a roll with lambda^2 = 0 stays as it is.  With that of -1e-12 it
 * would be displaced by half of itself at t = 1e6. */
static void a_replaced_period_is_not_used_for_long(void **unused)
{
    (void)unused;
    const coin_params p = ring(0);
    const coin_state roll = roll_of(&p, 0);
    const coin_state start = leaning(&roll, 1e-8);
    wobble(&roll, &p, &start, 0.999e6);
    refused(&roll, &start, 1.001e6, COIN_EDOMAIN);
    refused(&roll, &start, -1e9, COIN_EDOMAIN);
}

/* (14) for a disc with wY = 2 wZ A, wZ^2 = 1/3: all that is left of it is
 * theta'' = -(2/15 + 4/15) A^3. */
static void at_critical_it_lacks_the_cubic_force_alone(void **unused)
{
    (void)unused;
    const coin_params p = ring(0);
    const double A = 1e-3, t = 3;
    const coin_state roll = roll_of(&p, 0);
    const coin_state start = leaning(&roll, A);
    const coin_state near = wobble(&roll, &p, &start, t);
    coin_state full = start;
    check_status(coin_advance(&full, &p, t, 1e-13, NULL), COIN_OK);
    const double cubic = 0.4 * A * A * A * t * t / 2;
    /* 1e-5 of it is of the fifth order. */
    check_within((near.theta - full.theta) / cubic, 0.999, 1.001);
}

/* ------------------------------------------------------------------ refusals
 */
static void what_is_not_finite_is_refused(void **unused)
{
    (void)unused;
    const coin_params p = ring(0);
    const coin_state steady = motion_of(&kinds[0], &p);
    coin_state start = off_by(&steady, 0.01), moving = steady;
    moving.wX = 0.1;
    refused(&steady, &start, NAN, COIN_ESTEP);
    refused(&steady, &start, INFINITY, COIN_ESTEP);
    refused(&moving, &start, 1, COIN_EDOMAIN);
    refused(&moving, &start, INFINITY, COIN_ESTEP);
    start.theta = 2;
    refused(&steady, &start, 1, COIN_ESTATE);
    refused(&moving, &start, NAN, COIN_ESTATE);
}

/* The growth passes pi/2 at t = 25, a double's range at t = 2000, and is that
 * of a double with gravity 1e6; at 1e11 a stable heading passes its own.  At
 * t = 15 the lean has grown to 0.16, where nothing linear is left. */
static void what_would_be_no_state_is_refused(void **unused)
{
    (void)unused;
    const coin_params p = ring(0);
    const coin_state up = motion_of(&kinds[4], &p);
    const coin_state start = off_by(&up, 1e-3);
    refused(&up, &start, 15, COIN_EDOMAIN);
    refused(&up, &start, 25, COIN_ESTEP);
    refused(&up, &start, 2100, COIN_ESTEP);
    refused(&up, &start, 1e308, COIN_ESTEP);
    coin_params heavy;
    coin_state out;
    check_status(coin_params_disc(&heavy, 1, 1, 1e6), COIN_OK);
    const coin_state slow = {0, 0, 0, 0, 0, 0, 0, 1};
    check_status(coin_wobble_at(&slow, &heavy, &slow, 1e308, &out), COIN_ESTEP);
    const coin_state held = motion_of(&kinds[0], &p);
    const coin_state begun = off_by(&held, 1e-3);
    refused(&held, &begun, 1e11, COIN_ESTEP);
}

/* A roll with wY off by d is next to a circle whose lean obeys (60): here e =
 * -(6/5) wZ d/lambda^2, and lambda^2 = 4/5 - (12/5) wZ^2. */
static void a_neighbour_farther_than_a_tenth_is_refused(void **unused)
{
    (void)unused;
    const coin_params p = ring(0);
    const coin_state roll = {0, 0, 0, 0, 0, 0, 0, 1};
    const double d = 0.1 / 1.2 * 1.6;
    coin_state start = roll;
    start.wY = 0.99 * d;
    wobble(&roll, &p, &start, 1);
    start.wY = 1.01 * d;
    refused(&roll, &start, 1, COIN_EDOMAIN);
    start.wY = -1.01 * d;
    refused(&roll, &start, 1, COIN_EDOMAIN);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(its_error_is_of_second_order),
        TEST(resonance_with_the_heading_is_no_exception),
        TEST(it_begins_where_the_start_is),
        TEST(a_steady_start_stays_steady),
        TEST(a_start_steady_to_1e_9_wobbles_by_what_is_left),
        TEST(units_a_power_of_two_apart_give_the_same_bits),
        TEST(near_critical_it_grows_or_swings_by_its_lambda),
        TEST(a_replaced_period_is_not_used_for_long),
        TEST(at_critical_it_lacks_the_cubic_force_alone),
        TEST(what_is_not_finite_is_refused),
        TEST(what_would_be_no_state_is_refused),
        TEST(a_neighbour_farther_than_a_tenth_is_refused),
    };
    return RUN_TESTS(tests);
}
