/* SPDX-License-Identifier: MIT */
/* How a coin comes to its end, by the full equations. */
#include "support/check.h"
#include "support/coins.h"
#include "support/losses.h"

#include "steady_near.h"

#include <math.h>

#define HALF_PI 1.5707963267948966

/* --------------------------------------------------------------- exponents */
/* The time at which a coin next has this angle from flat. */
static double time_at(coin_state *s, const coin_params *p, const coin_losses *l,
                      double angle, double rest)
{
    double t = 0, step = rest * 1e-3, reached;
    while (step > 1e-9 * rest) {
        coin_state next = *s;
        coin_settle(&next, p, l, step, 1e-6, &reached);
        if (HALF_PI - next.theta < angle)
            step /= 2;
        else {
            *s = next;
            t += reached;
        }
    }
    return t;
}

/* n of e ~ (t0 - t)^n over a decade of the angle, from the times that its two
 * halves take. */
static double exponent(int i, double m, double from)
{
    const coin_params p = disc();
    const coin_losses l = one_loss(i, m);
    coin_state s = slow_spin(&p, &l, from);
    const double T = coin_time_to_rest(&s, &p, &l);
    const double first = time_at(&s, &p, &l, from / sqrt(10), T);
    const double middle = HALF_PI - s.theta;
    const double second = time_at(&s, &p, &l, middle * middle / from, T);
    return log(middle / from) / log(second / first);
}

static void the_angle_goes_by_the_exponents_of_the_laws(void **unused)
{
    (void)unused;
    const double want[LAWS] = {2.0 / 3, 0.5, 4.0 / 9, 1.0 / 3, 2, 2};
    const double m[LAWS] = {4e-6, 8e-8, 2e-8, 3e-10, 1e-3, 1e-3};
    for (int i = 0; i < LAWS; ++i) {
        const double n = exponent(i, m[i], 0.02);
        check_note("%s", loss_names[i]);
        check_near(n, want[i], 1e-3);
    }
}

/* ---------------------------------------------------------------- nutation */
/* The lean about which it swings, as an angle from flat. */
static double middle_of(coin_state s, const coin_params *p)
{
    coin_priv_body b;
    check_status(coin_priv_check(&s, p, &b), COIN_OK);
    check_status(coin_priv_steady_near(&s, &b), COIN_OK);
    return HALF_PI - s.theta;
}

/* The amplitude of the lean about its course, relative to the angle from flat:
 * half of the spread of a window. */
static double swing(const coin_state *start, const coin_params *p,
                    const coin_losses *l)
{
    coin_state s = *start;
    double most = 0;
    const double e = middle_of(s, p);
    for (int i = 0; i < 60; ++i) {
        coin_settle(&s, p, l, 0.1 * sqrt(e), 1e-9, NULL);
        most = fmax(most, fabs(HALF_PI - s.theta - middle_of(s, p)));
    }
    return most / e;
}

static void a_swing_grows_or_dies_out_by_the_law(void **unused)
{
    (void)unused;
    const double want[LAWS] = {-0.75, 0.25, 0.75, 0.75, -1.25, 1};
    const double m[LAWS] = {1e-5, 1e-6, 1e-6, 1e-7, 1e-3, 1e-3};
    const coin_params p = disc();
    for (int i = 0; i < LAWS; ++i) {
        const coin_losses l = one_loss(i, m[i]);
        coin_state s = slow_spin(&p, &l, 0.05);
        s.wX += 0.002 * sqrt(0.05);
        const double first = swing(&s, &p, &l);
        time_at(&s, &p, &l, 0.02, coin_time_to_rest(&s, &p, &l));
        const double n =
            log(swing(&s, &p, &l) / first) / log(middle_of(s, &p) / 0.05);
        check_note("%s", loss_names[i]);
        check_near(n, want[i], 0.02);
    }
}

/* -------------------------------------------------------------- the same path
 */
/* Where the turn about the vertical changes its sign, as an angle from flat. */
static double turns_back_at(const coin_losses *l, double e0)
{
    const coin_params p = disc();
    const coin_state start = slow_spin(&p, l, e0);
    double early = 0, late = coin_time_to_rest(&start, &p, l);
    coin_state s;
    for (int i = 0; i < 40; ++i) {
        const double middle = (early + late) / 2;
        coin_quasisteady_at(&start, &p, l, middle, &s);
        const double turn = s.wY * cos(s.theta) - s.wZ * sin(s.theta);
        *(turn > 0 ? &early : &late) = middle;
    }
    /* And so by the full equations. */
    s = start;
    check_status(coin_settle(&s, &p, l, early, 1e-8, NULL), COIN_OK);
    check_near(s.wY * cos(s.theta) - s.wZ * sin(s.theta), 0, 2e-4);
    return HALF_PI - s.theta;
}

/* At (5/23)^(2/3) of the angle that it began at, to leading order, and at the
 * same for each contour friction: their path in lean and wZ is one. */
static void the_turn_changes_its_sign_at_one_angle_by_any_law(void **unused)
{
    (void)unused;
    const double m[] = {1e-5, 1e-6, 1e-6, 1e-7};
    double angle[4];
    for (int i = 0; i < 4; ++i) {
        const coin_losses l = one_loss(i, m[i]);
        check_note("%s", loss_names[i]);
        angle[i] = turns_back_at(&l, 0.1);
        check_near(angle[i] / 0.1, 0.36150, 0.002);
        check_near(angle[i], angle[0], 1e-5);
    }
}

/* ------------------------------------------------------------- the last law */
/* From a hundred millionth rad from flat on: by the laws of (75), which are
 * integrated, with the rates of the steady motion. */
static void the_end_goes_by_the_law_of_the_loss_that_acts(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const struct {
        coin_losses l;
        double angle, T;
    } cases[] = {
        {{.dry = 1e-14}, 1e-9, 3.16227766e-14 / 2e-14},
        {{.dry = 1e-12}, 1e-8, 0.5},
        {{.damping = 1e-4, .spin = 1e-3}, 1e-9, 0.474342},
        {{.rolling = 1e-4}, 1e-9, 0.474342},
    };
    for (int i = 0; i < 4; ++i) {
        const double e = cases[i].angle;
        coin_state s = {.theta = HALF_PI - e, .wY = sqrt(4 * e)};
        double T;
        check_note("case %d", i);
        check_status(coin_settle(&s, &p, &cases[i].l, 9, 1e-5, &T), COIN_RESTS);
        check_near(T, cases[i].T, 1e-3 * cases[i].T);
    }
    /* So near that the law takes it to rest without a step. */
    coin_state near = {.theta = HALF_PI - 9e-11, .wY = sqrt(3.6e-10)};
    const coin_losses rolling = {.rolling = 1e-4};
    check_status(coin_settle(&near, &p, &rolling, 9, 1e-9, NULL), COIN_RESTS);
    check(near.theta == 1.5707963267948963);
    /* Pivoting alone lets it roll on. */
    const coin_losses spin = {.spin = 1e-3};
    coin_state s = {.theta = HALF_PI - 9e-11, .wY = 1.9e-5, .wZ = 0.3};
    check_status(coin_settle(&s, &p, &spin, 1e-3, 1e-9, NULL), COIN_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(the_angle_goes_by_the_exponents_of_the_laws),
        TEST(a_swing_grows_or_dies_out_by_the_law),
        TEST(the_turn_changes_its_sign_at_one_angle_by_any_law),
        TEST(the_end_goes_by_the_law_of_the_loss_that_acts),
    };
    return RUN_TESTS(tests);
}
