/* SPDX-License-Identifier: MIT */
/* One step of a coin with losses. */
#include "lossy.h"
#include "sundman.h"

#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"

#include <math.h>

static coin_priv_lossy lossy(const coin_state *s, const coin_losses *l)
{
    const coin_params p = disc();
    coin_priv_lossy w;
    w.run.b = coin_priv_body_of(&p);
    check_status(coin_priv_losses_of(&w.l, l, &w.run.b), COIN_OK);
    coin_priv_run_unlimited(&w.run, s);
    coin_priv_lossy_bound(&w, 1e-9); /* sets w.du, which a step needs */
    return w;
}

/* The largest difference of the rates after a step and after two halves. */
static double halved(const coin_priv_lossy *w, double tau, double *error)
{
    coin_priv_lossy two = *w;
    coin_priv_trial one, half;
    coin_priv_lossy_try(&one, w, tau, 1e-9);
    *error = one.error;
    for (int i = 0; i < 2; ++i) {
        coin_priv_lossy_try(&half, &two, tau / 2, 1e-9);
        check(coin_priv_sundman_accept(&two.run, &half.next, &half.adds));
        coin_priv_lossy_bound(&two, 1e-9);
    }
    const coin_priv_variables *a = &one.next, *b = &two.run.g.y;
    return fmax(fmax(fabs(a->wX - b->wX), fabs(a->wY - b->wY)),
                fmax(fabs(a->wZ - b->wZ), fabs(a->cph - b->cph)));
}

static const coin_state start = {.theta = 0.7, .wX = 0.3, .wY = 0.8, .wZ = 1.2};
static const coin_losses all = {0.02, 0.01, 0.01, 0.01, 0.01, 0.01, 0.02, 0};

static void the_step_is_of_order_8_and_its_estimate_is_larger(void **unused)
{
    (void)unused;
    const coin_priv_lossy w = lossy(&start, &all);
    double by_long, by_short;
    const double off = halved(&w, 0.4, &by_long);
    const double less = halved(&w, 0.2, &by_short);
    check_within(log2(off / less), 8.2, 9.8);
    check_within(log2(by_long / by_short), 7, 9);
    check_within(by_long / off, 3, 3e3);
    check_within(by_short / less, 3, 3e3);
}

static void a_step_through_the_table_has_an_infinite_error(void **unused)
{
    (void)unused;
    const coin_state falls = {.theta = 1.4, .wX = 2};
    const coin_priv_lossy w = lossy(&falls, &all);
    coin_priv_trial t;
    coin_priv_lossy_try(&t, &w, 0.1, 1e-9);
    check(t.error < 1e-6);
    coin_priv_lossy_try(&t, &w, 1e3, 1e-9);
    check(isinf(t.error));
}

/* A coin that rolls straight on, upright: wZ alone changes. */
static const coin_state straight = {.wZ = 1};

static void the_error_of_a_straight_roll_is_seen(void **unused)
{
    (void)unused;
    const coin_losses viscous = {.viscous = 1};
    const coin_priv_lossy w = lossy(&straight, &viscous);
    double error;
    const double off = halved(&w, 0.5, &error);
    check_within(error / off, 3, 3e3);
}

static void the_error_of_a_step_that_overflows_is_infinite(void **unused)
{
    (void)unused;
    const coin_losses viscous = {.viscous = 1};
    const coin_priv_lossy w = lossy(&straight, &viscous);
    coin_priv_trial t;
    coin_priv_lossy_try(&t, &w, 1e25, 1e-9);
    check(isfinite(t.next.wZ));
    check(isinf(t.error));
}

/* The contact turns round where its rate of roll u is 0.  The longest step is
 * half of the time in which u comes to 0. */
static void the_bound_halves_the_way_to_where_the_contact_turns(void **unused)
{
    (void)unused;
    const coin_losses dry = {.dry = 1e-9};
    coin_priv_lossy w = lossy(&start, &dry);
    const double h = 1e-5, c = cos(0.7), s = sin(0.7);
    const double u = c * 1.2 + s * 0.8;
    coin_priv_trial t;
    coin_priv_lossy_try(&t, &w, h, 1e-9);
    const coin_priv_variables *y = &t.next;
    const double du = (y->cth * y->wZ + y->sth * y->wY - u) / h;
    check_near(coin_priv_lossy_bound(&w, 1e-9) * fabs(du) / u, 0.5, 1e-3);
}

/* At u = 0 the longest step with dry friction is proportional to the width of
 * the softening, whatever error is allowed.  With layer or damping it is
 * proportional to a power of that error.  With viscous friction there is no
 * bound. */
static void where_the_contact_turns_the_bound_is_the_width(void **unused)
{
    (void)unused;
    const coin_state turn = {
        .theta = 0.7, .wX = 0.3, .wY = 0.8, .wZ = -0.8 * 0.84228838046307941};
    const coin_losses laws[] = {{.dry = 1e-9},
                                {.dry = 1e-9, .soft = 0x1p-12},
                                {.layer = 0.01},
                                {.damping = 0.01},
                                {.viscous = 0.01}};
    double bound[5];
    for (int i = 0; i < 5; ++i) {
        coin_priv_lossy w = lossy(&turn, &laws[i]);
        bound[i] = coin_priv_lossy_bound(&w, 1e-9);
        const double less = coin_priv_lossy_bound(&w, 1e-12);
        check_note("law %d", i);
        if (i < 2)
            check(less == bound[i]);
        else if (i < 4) /* 1000^(7/16) and 1000^(1/2) */
            check_near(bound[i] / less, i == 2 ? 20.535 : 31.623, 1e-2);
        else
            check(isinf(bound[i]));
    }
    check_near(bound[0] / bound[1], 4, 1e-6);
}

/* In parts of u, or of the width where that is more; as the root where u does
 * not change at first. */
static void the_part_of_the_way_to_the_turn_is_that_of_u(void **unused)
{
    (void)unused;
    const coin_state turn = {
        .theta = 0.7, .wX = 0.3, .wY = 0.8, .wZ = -0.8 * 0.84228838046307941};
    const coin_losses laws[] = {
        {.dry = 1e-9}, {.layer = 0.01}, {.damping = 0.01}, {.viscous = 0.01}};
    for (int i = 0; i < 4; ++i) {
        coin_priv_lossy w = lossy(&start, &laws[i]);
        const double u = cos(0.7) * 1.2 + sin(0.7) * 0.8;
        const double to[] = {0.41, 1.59, 0, -1};
        check_note("law %d", i);
        for (int k = 0; k < 4; ++k) {
            const double part = i == 3 ? 0 : fabs(1 - to[k]);
            const double tau = k % 2 ? -0.1 : 0.1;
            w.du = (to[k] - 1) * u / tau;
            check_near(coin_priv_part_of_way(&w, to[k] * u, tau, 1e-9), part,
                       1e-3);
            w.du = 0;
            check_near(coin_priv_part_of_way(&w, to[k] * u, tau, 1e-9),
                       sqrt(part), 1e-3);
        }
        w = lossy(&turn, &laws[i]);
        w.du = 0;
        check(coin_priv_part_of_way(&w, 0, 0.1, 1e-9) == 0);
        if (i == 3)
            continue;
        /* From u = 0 the bound is half of the width. */
        w.du = 1;
        const double h = coin_priv_turn_bound(&w, 1e-9);
        check_near(coin_priv_part_of_way(&w, h, h, 1e-9), 0.5, 1e-9);
    }
}

static void friction_shortens_the_step(void **unused)
{
    (void)unused;
    const coin_losses none = {.dry = 1e-12}, one[] = {{.dry = 1},
                                                      {.viscous = 1},
                                                      {.damping = 1},
                                                      {.spin = 1}};
    const coin_priv_lossy w = lossy(&start, &none);
    const double least = coin_priv_lossy_rate(&w);
    const double c = cos(0.7), s = sin(0.7), u = c * 1.2 + s * 0.8;
    const double lever = 4 * s * s + c * c / 1.5;
    const double more[] = {lever / hypot(u, c / 1024), lever / c, u, 4 * c};
    for (int i = 0; i < 4; ++i) {
        const coin_priv_lossy with = lossy(&start, &one[i]);
        check_note("law %d", i);
        check_near(coin_priv_lossy_rate(&with) - least, 0.3 * more[i], 1e-9);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(the_step_is_of_order_8_and_its_estimate_is_larger),
        TEST(a_step_through_the_table_has_an_infinite_error),
        TEST(the_error_of_a_straight_roll_is_seen),
        TEST(the_error_of_a_step_that_overflows_is_infinite),
        TEST(the_bound_halves_the_way_to_where_the_contact_turns),
        TEST(where_the_contact_turns_the_bound_is_the_width),
        TEST(the_part_of_the_way_to_the_turn_is_that_of_u),
        TEST(friction_shortens_the_step),
    };
    return RUN_TESTS(tests);
}
