/* SPDX-License-Identifier: MIT */
/* How a coin comes to its end, by the full equations. */
#include "support/check.h"
#include "support/coins.h"
#include "support/losses.h"

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
    const double T = coin_time_to_rest(&s, &p, &l, 1e-6);
    const double first = time_at(&s, &p, &l, from / sqrt(10), T);
    const double middle = HALF_PI - s.theta;
    const double second = time_at(&s, &p, &l, middle * middle / from, T);
    return log(middle / from) / log(second / first);
}

TEST(the_angle_goes_by_the_exponents_of_the_laws)
{
    const double want[] = {2.0 / 3, 0.5, 4.0 / 9, 1.0 / 3, 2, 2};
    const double m[] = {4e-6, 8e-8, 2e-8, 3e-10, 1e-3, 1e-3};
    for (int i = 0; i < ANGULAR; ++i) {
        const double n = exponent(i, m[i], 0.02);
        check_note("%s", loss_names[i]);
        check_near(n, want[i], 1e-3);
    }
}

/* -------------------------------------------------------------- the same path
 */
static double turn(const coin_state *s)
{
    return s->wY * cos(s->theta) - s->wZ * sin(s->theta);
}

/* Where the turn about the vertical changes its sign, as an angle from flat. */
static double turns_back_at(const coin_losses *l, double e0)
{
    const coin_params p = disc();
    coin_state s = slow_spin(&p, l, e0);
    double step = coin_time_to_rest(&s, &p, l, 1e-6);
    for (int i = 0; i < 20; ++i) {
        coin_state next = s;
        step /= 2;
        check_status(coin_settle(&next, &p, l, step, 1e-8, NULL), COIN_OK);
        if (turn(&next) > 0)
            s = next;
    }
    check_near(turn(&s), 0, 2e-4);
    return HALF_PI - s.theta;
}

/* At (5/23)^(2/3) of the angle that it began at, to leading order, and at the
 * same for each contour friction: their path in lean and wZ is one. */
TEST(the_turn_changes_its_sign_at_one_angle_by_any_law)
{
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

/* -------------------------------------------------------------------- flat */
/* By (75) a coin that rolling or damping slows lies flat earlier by the part
 * sqrt(flat/e0) of its time, and one that dry friction slows by (flat/e0)^(3/2)
 * of it. */
TEST(flat_ends_the_laws_that_never_end)
{
    const coin_params p = disc();
    const double e0 = 0.02, m = 1e-3;
    const int laws[] = {ROLLING, DAMPING};
    for (int i = 0; i < 2; ++i) {
        double when[2];
        for (int k = 0; k < 2; ++k) {
            coin_losses l = one_loss(laws[i], m);
            coin_state s = slow_spin(&p, &l, e0);
            l.flat = k ? 1e-4 : 1e-5;
            check_status(coin_settle(&s, &p, &l, INFINITY, 1e-6, &when[k]),
                         COIN_RESTS);
        }
        const double want = 1.5 / m * (sqrt(1e-4) - sqrt(1e-5));
        check_note("%s", loss_names[laws[i]]);
        check_near((when[0] - when[1]) / want, 1, 0.1);
    }
}

/* Every law but pivoting brings a coin to rest that starts with wX = 0. */
TEST(every_law_brings_a_coin_to_rest)
{
    const coin_params p = disc();
    for (int i = 0; i < LAWS; ++i) {
        const coin_losses l = one_loss(i, i == GAP       ? 1e-4
                                          : i == ANGULAR ? 0.1
                                                         : 2e-3);
        coin_state s;
        double when;
        check_note("%s", loss_names[i]);
        check_status(coin_steady_spin(&s, &p, 1.2), COIN_OK);
        check_status(coin_settle(&s, &p, &l, INFINITY, 1e-6, &when),
                     COIN_RESTS);
        check_near(coin_time_to_rest(&s, &p, &l, 1e-6), 0, 0);
    }
}
