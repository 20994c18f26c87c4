/* SPDX-License-Identifier: MIT */
/* One step of DOP853 and the polynomial within it, and what ends a slip and
 * holds a contact. */
#include "support/check.h"
#include "support/coins.h"
#include "support/random.h"

#include "move.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A disc that leans and rolls, after a step of h. */
static void make_step(coin_priv_moving *g, double h)
{
    const double no_slip[2] = {0, 0};
    const coin_params p = disc();
    const coin_losses none = {0};
    const coin_state s = {.theta = 0.5, .wX = 0.3, .wY = 1, .wZ = 2};
    coin_priv_constants b;
    check_status(coin_priv_check_params(&b, &p), COIN_OK);
    check_status(coin_priv_law_of(&g->law, &none, &b), COIN_OK);
    coin_priv_set_state(&g->c, &s, 0);
    coin_priv_begin_call(g, 1, 1e-9, 0);
    coin_priv_begin(g, 0, no_slip);
    coin_priv_dop853 *const w = &g->step;
    w->of.rates = coin_priv_rates;
    w->of.mode = 0;
    w->of.limit = 1e6;
    check(coin_priv_rates(w->slope[0], w->y, &w->of) == 1);
    check(coin_priv_try_step(w, h) < 1e-6);
}

/* The largest error of the polynomial at 0.4 of a step of h. */
static double error_within(double h)
{
    static coin_priv_moving all, part;
    double y[COIN_PRIV_WIDE], error = 0;
    make_step(&all, h);
    make_step(&part, 0.4 * h);
    coin_priv_within(y, &all.step, 0.4);
    for (int i = 0; i < COIN_PRIV_READ; ++i)
        error = fmax(error, fabs(y[i] - part.step.end[i]));
    return error;
}

/* A vector may hold more variables than there are. */
TEST(slopes_fill_what_vectors_read)
{
    static const int modes[] = {0, COIN_PRIV_SLIPS, COIN_PRIV_HELD};
    static coin_priv_moving g;
    make_step(&g, 0.1);
    for (size_t i = 0; i < sizeof modes / sizeof *modes; ++i) {
        double d[COIN_PRIV_WIDE];
        for (int k = 0; k < COIN_PRIV_WIDE; ++k)
            d[k] = NAN;
        g.step.y[COIN_PRIV_UX] = modes[i] & COIN_PRIV_SLIPS ? 0.1 : 0;
        g.step.of.mode = modes[i];
        check(coin_priv_rates(d, g.step.y, &g.step.of) == 1);
        for (int k = 0; k < COIN_PRIV_WIDE; ++k)
            check(isfinite(d[k]));
    }
}

/* A cubic has order 4. */
TEST(a_polynomial_has_order_8)
{
    const double order = log2(error_within(0.25) / error_within(0.125));
    check_within(order, 7.5, 9);
}

/* The slopes that only the polynomial needs may not exist: a coin that passes
 * near flat leads one of them below the table. */
TEST(a_polynomial_without_its_stages_is_the_cubic_of_the_ends)
{
    static coin_priv_moving g;
    const double x = 0.3, h = 0.25;
    double y[COIN_PRIV_WIDE];
    make_step(&g, h);
    coin_priv_dop853 *const w = &g.step;
    coin_priv_within(y, w, x);
    w->has_dense = 0;
    w->of.limit = 0; /* no further stage is sound */
    coin_priv_within(y, w, x);
    for (int i = 0; i < COIN_PRIV_READ; ++i) {
        const double from = w->y[i], to = w->end[i];
        const double d0 = h * w->slope[0][i], d1 = h * w->slope[12][i];
        const double cubic = (1 + 2 * x) * (1 - x) * (1 - x) * from +
                             x * (1 - x) * (1 - x) * d0 +
                             x * x * (3 - 2 * x) * to - x * x * (1 - x) * d1;
        check_near(y[i], cubic, 1e-15);
    }
}

/* By t, in which a fall comes to flat at a finite speed. */
TEST(a_step_is_refused_that_leads_below_the_table)
{
    static coin_priv_moving g;
    make_step(&g, 0.1);
    coin_priv_dop853 *const w = &g.step;
    for (int below = 0; below < 2; ++below) {
        const double y[COIN_PRIV_WIDE] = {1, 0, 0, sqrt(1 - 1e-4), 1e-2, 0,
                                          0, 0, 1};
        memcpy(w->y, y, sizeof y);
        w->of.by_t = 1;
        check(coin_priv_rates(w->slope[0], w->y, &w->of) == 1);
        const double error = coin_priv_try_step(w, below ? 0.02 : 0.005);
        check((error < (double)INFINITY) == !below);
    }
}

/* The stride is far too long for the tolerance. */
TEST(a_call_whose_last_trial_is_refused_stays_where_it_was)
{
    static coin_priv_moving g;
    make_step(&g, 0.1);
    g.tol = 1e-12;
    g.stride = COIN_PRIV_MOST_STRIDE;
    g.tries = 1;
    check_status(coin_priv_go(&g), COIN_OK);
    check(g.found == COIN_MORE && g.tries == 0 && !g.changed);
}

/* Spin brakes the turn about the vertical, c wY - s wZ, and angular damping
 * all. */
TEST(steps_are_planned_by_no_less_than_the_rate_of_the_losses)
{
    const double c = 0.6, s = 0.8, turn = 0.7;
    const coin_losses laws[] = {{.spin = 2}, {.angular = 2}};
    const double y[COIN_PRIV_WIDE] = {0, turn * c, -turn * s, s, c};
    const coin_params p = disc();
    coin_priv_constants b;
    coin_priv_law law;
    check_status(coin_priv_check_params(&b, &p), COIN_OK);
    for (int i = 0; i < 2; ++i) {
        check_status(coin_priv_law_of(&law, &laws[i], &b), COIN_OK);
        const coin_priv_slowing d = coin_priv_slowing_of(&law, y, 0);
        const double decay = (s * d.wZ - c * d.wY) / turn;
        const double rate = coin_priv_loss_rate(y, &law, 0);
        check_within(rate, decay * (1 - 8 * U), 3 * decay);
    }
}

/* I_X > I_Z + M a^2: a rod, not a coin.  A turn then presses it upright. */
TEST(a_contact_that_its_turn_lifts_is_not_held)
{
    const coin_losses dry = {.dry = 1};
    const double c = 0.01, s = sqrt(1 - c * c);
    for (int fast = 0; fast < 2; ++fast) {
        coin_params p;
        coin_priv_constants b;
        coin_priv_law law;
        const double turn = fast ? 0.01 : 0.001;
        const double y[COIN_PRIV_WIDE] = {0, turn * c, -turn * s, s, c};
        check_status(coin_params_body(&p, 1, 1, 1, 100, 1), COIN_OK);
        check_status(coin_priv_check_params(&b, &p), COIN_OK);
        check_status(coin_priv_law_of(&law, &dry, &b), COIN_OK);
        check(coin_priv_is_held(y, &law, 0, 1e-6) == !fast);
    }
}

/* The coin turns about the vertical through its contact, or its centre if it
 * slips without friction: the moment of `angular` is all that changes its
 * angular momentum D turn there, D = I_X c^2 + K s^2. */
TEST(angular_damping_brakes_the_turn_of_a_held_contact)
{
    const coin_losses l = {.angular = 1};
    const coin_params p = disc();
    const coin_priv_direction none = {0, 0};
    const double c = 0.04, s = sqrt(1 - c * c), turn = 0.7, wX = -0.5;
    const double y[COIN_PRIV_WIDE] = {wX, turn * c, -turn * s, s, c};
    coin_priv_constants b;
    coin_priv_law law;
    check_status(coin_priv_check_params(&b, &p), COIN_OK);
    check_status(coin_priv_law_of(&law, &l, &b), COIN_OK);
    for (int slips = 0; slips < 2; ++slips) {
        const double IX = law.IX, K = law.K[slips];
        double d[COIN_PRIV_WIDE];
        (void)coin_priv_slopes(d, y, &law, COIN_PRIV_HELD | slips, none);
        const double D = IX * c * c + K * s * s;
        const double dD = 2 * s * c * wX * (K - IX);
        const double dturn = c * d[COIN_PRIV_WY] - s * d[COIN_PRIV_WZ];
        check_near(dD * turn + D * dturn, -(IX * c * c + law.IZ * s * s) * turn,
                   32 * U);
    }
}

/* A quarter for 1/60 s. */
TEST(a_frame_that_rolls_is_one_step)
{
    const double w0 = sqrt(9.81 / 0.01213);
    const coin_params p = disc();
    const coin_losses none = {0};
    const coin_state s = {
        .theta = 0.3, .wX = 0.01, .wY = 5 / w0, .wZ = 40 / w0};
    static coin_priv_moving g;
    coin_priv_constants b;
    check_status(coin_priv_check_params(&b, &p), COIN_OK);
    check_status(coin_priv_law_of(&g.law, &none, &b), COIN_OK);
    const double no_slip[2] = {0, 0};
    coin_priv_set_state(&g.c, &s, 0);
    coin_priv_begin_call(&g, w0 / 60, 1e-6, 100);
    coin_priv_begin(&g, 0, no_slip);
    check_status(coin_priv_go(&g), COIN_OK);
    check(g.tries == 99);
    check(coin_priv_time_left(&g) == 0);
}

TEST(a_slip_does_not_end_where_a_rate_leaves_its_range)
{
    static coin_priv_moving g;
    for (int beyond = 0; beyond < 2; ++beyond) {
        make_step(&g, 0.1);
        g.law.mu_kinetic = 0.3;
        g.mode = COIN_PRIV_SLIPS;
        for (int i = 0; i < COIN_PRIV_READ; ++i)
            g.step.y[i] = i == COIN_PRIV_C || i == COIN_PRIV_CPH;
        g.step.y[COIN_PRIV_WY] = beyond ? 1.1e6 : 0;
        g.step.y[COIN_PRIV_UX] = 1e-12;
        g.step.of.mode = g.mode;
        g.step.of.limit = INFINITY;
        check(coin_priv_rates(g.step.slope[0], g.step.y, &g.step.of) == 1);
        check(coin_priv_end_slip(&g) == !beyond);
        check((g.step.y[COIN_PRIV_UX] == 0) == !beyond);
    }
}

static int refuses_ends(double *d, const double *y, const coin_priv_problem *of)
{
    return d ? coin_priv_rates(d, y, of) : 0;
}

TEST(a_step_is_refused_whose_end_means_nothing)
{
    static coin_priv_moving g;
    make_step(&g, 0.1);
    g.step.of.rates = refuses_ends;
    check(coin_priv_try_step(&g.step, 0.1) > DBL_MAX);
}

/* The polynomial of a step may fall through the table. */
TEST(below_the_table_losses_are_numbers)
{
    const coin_losses layer = {.layer = 1};
    const coin_params p = disc();
    coin_priv_constants b;
    coin_priv_law law;
    check_status(coin_priv_check_params(&b, &p), COIN_OK);
    check_status(coin_priv_law_of(&law, &layer, &b), COIN_OK);
    for (int side = -1; side <= 1; side += 2)
        check(isfinite(coin_priv_grip(&law, side * 0.1, -0.1)));
}

/* d/dtau of the roll speed c wZ + s wY of a coin that slips as y says. */
static double roll_slope(const double *y, const coin_priv_law *l)
{
    const double u = sqrt(y[COIN_PRIV_UX] * y[COIN_PRIV_UX] +
                          y[COIN_PRIV_UH] * y[COIN_PRIV_UH]);
    const coin_priv_direction n = {y[COIN_PRIV_UX] / u, y[COIN_PRIV_UH] / u};
    double d[COIN_PRIV_WIDE];
    (void)coin_priv_slopes(d, y, l, COIN_PRIV_SLIPS, n);
    return d[COIN_PRIV_C] * y[COIN_PRIV_WZ] + y[COIN_PRIV_C] * d[COIN_PRIV_WZ] +
           d[COIN_PRIV_S] * y[COIN_PRIV_WY] + y[COIN_PRIV_S] * d[COIN_PRIV_WY];
}

/* Where the losses hold the contact of a coin that slips, a roll as slow as
 * they may leave out becomes slower; where the friction of the slip is too
 * large for them, it does not. */
TEST(losses_hold_a_slip_against_its_friction)
{
    struct random r = random_begin(19);
    const int count = tries_asked(2000);
    int held = 0, pushed = 0;
    for (int i = 0; i < count; ++i) {
        const double half = i % 2 ? random_between(&r, 0.02, 1) : 0;
        const coin_table f = {
            .mu_static = 0.4,
            .mu_kinetic = 0.3,
            .losses = {.dry = pow(10, random_between(&r, -4, 0)),
                       .soft = pow(10, random_between(&r, -9, -3))}};
        coin_params p = disc();
        coin_priv_constants b;
        coin_priv_law l;
        double y[COIN_PRIV_WIDE] = {0};
        p.thickness = 2 * half;
        check_status(coin_priv_check_thick(&b, &p), COIN_OK);
        check_status(coin_priv_table_law(&l, &f, &b, half), COIN_OK);
        const double c = pow(10, random_between(&r, -3, -0.3));
        const double side = random_between(&r, -1, 1) < 0 ? -1 : 1;
        const double s = side * sqrt(1 - c * c),
                     way = random_between(&r, -3, 3);
        const double turn = i % 3 ? 0 : random_between(&r, -0.1, 0.1);
        l.eta = side * half;
        y[COIN_PRIV_WX] = random_between(&r, -1, 1);
        y[COIN_PRIV_S] = s;
        y[COIN_PRIV_C] = c;
        y[COIN_PRIV_UX] = cos(way);
        y[COIN_PRIV_UH] = sin(way);
        y[COIN_PRIV_CPH] = 1;
        check_note("seed 19, slip %d", i);
        for (int sign = -1; sign <= 1; sign += 2) {
            double roll = 1e-6;
            do {
                roll *= 0.9;
                y[COIN_PRIV_WY] = turn * c + sign * roll * s;
                y[COIN_PRIV_WZ] = -turn * s + sign * roll * c;
            } while (roll > 1e-20 &&
                     !coin_priv_is_held(y, &l, COIN_PRIV_SLIPS, 1e-6));
            const double slope = sign * roll_slope(y, &l);
            held += roll > 1e-20;
            if (roll > 1e-20)
                check(slope < 0);
            else
                pushed += slope > 0;
        }
    }
    check_within(held, count / 20, 2 * count);
    check_within(pushed, count / 20, 2 * count);
}
