/* SPDX-License-Identifier: MIT */
/* Coins that slip and lose energy; and slips that begin without acceleration.
 */
#include "support/check.h"
#include "support/coins.h"
#include "support/losses.h"
#include "support/slides.h"

#include <math.h>

/* Some of all terms but damping, and dry or viscous among them. */
static coin_losses some_losses(struct random *r)
{
    coin_losses l = {0};
    double *const members[] = {&l.layer, &l.gap, &l.rolling, &l.spin};
    *(random_between(r, 0, 1) < 0.5 ? &l.dry : &l.viscous) =
        random_between(r, 1e-3, 1e-2);
    for (int i = 0; i < 4; ++i)
        *members[i] =
            random_between(r, 0, 1) < 0.3 ? random_between(r, 0, 1e-3) : 0;
    return l;
}

/* Held to the table by infinite friction it is the coin of coin_settle(). */
TEST(a_coin_that_cannot_slip_rests_when_coin_settle_says)
{
    const coin_table endless = {.mu_static = INFINITY, .mu_kinetic = 0.3};
    const int count = tries_asked(12);
    struct random r = random_begin(191);
    int rested = 0;
    for (int i = 0; i < count; ++i) {
        const coin_params p = i % 2 ? disc() : ring(0.7);
        const coin_losses l = some_losses(&r);
        coin_state s = {.theta = random_between(&r, 1.1, 1.3), .wX = 0.02};
        coin_state start;
        coin_steady_spin(&start, &p, s.theta);
        start.wX = s.wX;
        coin_body d;
        double when, by_settle;
        coin_body_from_state(&d, &start, &p);
        s = start;
        coin_table lossy = endless;
        lossy.losses = l;
        const int32_t stop = COIN_SLIPS | COIN_LIFTS; /* it lies and slides */
        coin_move(&d, &p, &lossy, 1e4, 1e-7, stop, &when);
        if (!(fabs(d.s.theta) > 1.57079632679489))
            continue;
        ++rested;
        check_status(coin_settle(&s, &p, &l, 1e4, 1e-7, &by_settle),
                     COIN_RESTS);
        check_near(when, by_settle, 1e-5 * by_settle);
        check(d.s.wX == 0 && d.s.wY == 0);
        check(fabs(d.s.theta) > 1.57079632679489);
    }
    check(rested > count * 0.6);
}

/* In one call and in many, at two tolerances. */
TEST(the_time_of_rest_is_that_of_any_tolerance_and_calls)
{
    const int count = tries_asked(40);
    struct random r = random_begin(192);
    int rested = 0, parted = 0;
    for (int i = 0; i < count; ++i) {
        const coin_params p = i % 2 ? disc() : ring(0.7);
        const coin_losses l = some_losses(&r);
        const double mu = random_between(&r, 0.2, 0.6);
        const coin_table f = {.mu_static = mu, .mu_kinetic = 0.9 * mu};
        coin_body d = random_launch(&r, &p), many = d, fine = d;
        double when, finer, t = 0, part;
        const int32_t status = slide(&d, &p, &f, &l, 200, 1e-8, &when);
        check_status(slide(&fine, &p, &f, &l, 200, 1e-10, &finer), status);
        if (status != COIN_RESTS)
            continue;
        ++rested;
        int32_t by_parts = COIN_OK;
        while (by_parts == COIN_OK || by_parts == COIN_SLIPS) {
            by_parts = slide(&many, &p, &f, &l, 0.5, 1e-8, &part);
            t += part;
        }
        check_status(by_parts, COIN_RESTS);
        parted += !(fabs(t - when) <= 1e-4 && fabs(finer - when) <= 1e-4);
    }
    check_share(rested, count, 0.55);
    check(parted <= rested / 10); /* which nearly stood, or nearly rested */
}

/* A coin near flat that rises while its contact is held, in a short call and in
 * calls that go on until it falls. */
TEST(a_held_coin_rises_as_coin_settle_says)
{
    const coin_params p = disc();
    const coin_table endless = {.mu_static = INFINITY, .mu_kinetic = 0.3};
    const coin_losses l = {.dry = 0.1};
    const double times[] = {1e-6, 1e-4, 1e-2};
    for (int i = 0; i < 3; ++i) {
        coin_state s = {.theta = 1.57, .wX = -0.01};
        coin_body d;
        double reached, by_settle;
        coin_body_from_state(&d, &s, &p);
        check_status(slide(&d, &p, &endless, &l, times[i], 1e-9, &reached),
                     COIN_OK);
        check_status(coin_settle(&s, &p, &l, times[i], 1e-9, &by_settle),
                     COIN_OK);
        check(reached == times[i] && by_settle == times[i]);
        check_near(d.s.theta, s.theta, 1e-12);
        check_near(d.s.wX, s.wX, 1e-9);
    }
}

/* Where the contact turns round, steps are short: one must not stand for the
 * rest of the time. */
TEST(a_short_call_takes_all_its_time)
{
    const coin_params p = disc();
    const coin_table endless = {.mu_static = INFINITY, .mu_kinetic = 0.3};
    const coin_losses l = {.dry = 1e-6, .soft = 1e-9};
    for (double t = 1e-7; t < 1e-4; t *= 10) {
        coin_state ideal = {
            .theta = 0.5, .wX = 0.3, .wY = 0.3, .wZ = -0.3 * tan(0.5)};
        coin_body d;
        check_status(coin_body_from_state(&d, &ideal, &p), COIN_OK);
        check_status(slide(&d, &p, &endless, &l, t, 1e-12, NULL), COIN_OK);
        check_status(coin_advance(&ideal, &p, t, 1e-12, NULL), COIN_OK);
        check_note("t %g", t);
        check_near(d.s.theta, ideal.theta, 1e-14);
    }
}

/* By losses in and by friction: the sum is what the energy falls by. */
TEST(losses_and_friction_take_what_the_energy_falls_by)
{
    const coin_params p = disc();
    const coin_table f = {.mu_static = 0.55, .mu_kinetic = 0.5};
    const coin_losses all[] = {{.dry = 0.01},     {.viscous = 0.01},
                               {.layer = 0.01},   {.gap = 0.003},
                               {.rolling = 0.01}, {.spin = 0.02}};
    for (int i = 0; i < 6; ++i) {
        const coin_body start = {
            .s = {.theta = 0.3, .wY = 0.5, .wZ = -0.5}, .vx = 1, .vz = 0.4};
        coin_body d = start;
        double lost = 0;
        const double h = 0.001;
        for (int k = 0; k < 600; ++k) { /* by the midpoint of short steps */
            coin_force force;
            slide(&d, &p, &f, &all[i], h / 2, 1e-12, NULL);
            slide_reaction(&d, &p, &f, &all[i], &force);
            lost += h * (force.friction * slip_speed(&d, &p) +
                         coin_losses_power(&d.s, &p, &all[i]));
            slide(&d, &p, &f, &all[i], h / 2, 1e-12, NULL);
        }
        check_note("term %d", i);
        check_near(slide_energy(&start, &p) - slide_energy(&d, &p), lost, 1e-7);
    }
}

/* Dry friction turns round with the contact, and a step does not go there. */
TEST(units_change_nothing_of_losses)
{
    const double T = 0x1p20; /* of time and length; M = 1 */
    const coin_table f = {.mu_static = 0.55, .mu_kinetic = 0.5};
    const coin_losses l = {.dry = 0.01, .soft = 0.01};
    const coin_losses big_l = {.dry = 0.01, .soft = 0.01 / T};
    const coin_params p = disc();
    coin_params big;
    check_status(coin_params_disc(&big, 1, T, 1 / T), COIN_OK);
    coin_body d = {.s = {.theta = 0.4, .wX = 0.1, .wZ = 0.1},
                   .vx = 0.5,
                   .vz = 0.2},
              e = d;
    e.s.wX /= T;
    e.s.wZ /= T;
    const int32_t status = slide(&d, &p, &f, &l, 1.5, 1e-8, NULL);
    check_status(slide(&e, &big, &f, &big_l, 1.5 * T, 1e-8, NULL), status);
    check(status >= 0);
    check(e.s.theta == d.s.theta && e.s.wX * T == d.s.wX);
    check(e.vx == d.vx && e.vz == d.vz);
}

/* The onset of such a slip is not resolved by a step that begins with it. */
TEST(equal_coefficients_give_the_limit_of_nearly_equal_ones)
{
    const coin_params p = disc();
    const coin_state s = {.theta = 1e-3, .wZ = 0.3};
    double apart[3];
    for (int i = 0; i < 3; ++i) {
        const double gap = i == 0 ? 1e-3 : i == 1 ? 1e-4 : 0;
        coin_body d, equal;
        const coin_table f = {.mu_static = 0.5, .mu_kinetic = 0.5},
                         g = {.mu_static = 0.5 * (1 + gap), .mu_kinetic = 0.5};
        coin_body_from_state(&d, &s, &p);
        equal = d;
        check_status(slide(&equal, &p, &f, NULL, 11, 1e-10, NULL), COIN_SLIPS);
        check_status(slide(&d, &p, &g, NULL, 11, gap > 0 ? 1e-10 : 1e-7, NULL),
                     COIN_SLIPS);
        apart[i] = slides_apart(&d, &equal, &p);
    }
    check_within(apart[0] / apart[1], 5, 200); /* at least as the gap */
    check(apart[2] < 1e-5);
}

/* phi leaves its range in a part of a step, where a slip is about to begin. */
TEST(a_pose_that_leaves_its_range_ends_the_onset)
{
    const coin_params p = disc();
    const coin_table f = {.mu_static = 0.5, .mu_kinetic = 0.5};
    coin_state s = {.theta = 1e-3, .wZ = 0.3};
    coin_body d;
    double reached = 7;
    coin_body_from_state(&d, &s, &p);
    check_status(coin_move(&d, &p, &f, 20, 1e-10, COIN_SLIPS, NULL),
                 COIN_SLIPS);
    s = d.s;
    s.phi = s.wY > 0 ? 0x1p31 : -0x1p31;
    coin_body_from_state(&d, &s, &p);
    check_status(coin_move(&d, &p, &f, 1, 1e-2, 0, &reached), COIN_ERANGE);
    check_within(reached, 0, 0.1);
    check_status(coin_state_check(&d.s, &p), COIN_OK);
}

/* Dry friction holds the contact of a disc that falls from rest.  It slips next
 * to the table, and then slides on its face for 1.1e-4.  Until then it falls
 * like a rod about its contact, for T, the integral of J d(wX)/sin(theta) with
 * J = 5/4 and wX^2 = 2 (0.1 - cos(theta))/J. */
TEST(a_coin_that_slips_as_it_falls_flat_rests_when_its_fall_ends)
{
    const coin_params p = disc();
    const coin_table f = {
        .mu_static = 0.78, .mu_kinetic = 0.7, .losses = {.dry = 0.01}};
    const coin_state s = {.theta = acos(0.1)};
    const double T = 0.501341, tol = 1e-4;
    coin_body b;
    double reached;
    check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
    check_status(coin_move(&b, &p, &f, 1, tol, 0, &reached), COIN_RESTS);
    check_within(reached, T - tol, T + 1.1e-4 + tol);
}

/* Upright, but it tips about its contact, turns in its place or slides. */
TEST(an_upright_coin_that_moves_does_not_rest)
{
    const coin_params p = disc();
    const coin_table f = {.mu_static = 0.4, .mu_kinetic = 0.3};
    const coin_body moving[] = {
        {.s = {.wX = 0.5}, .y = 1},
        {.s = {.wY = 0.5}, .y = 1},
        {.s = {.wZ = 0.5}, .y = 1},
        {.y = 1, .vx = 0.5},
    };
    const int32_t mode[] = {COIN_SLIPS, COIN_OK, COIN_SLIPS, COIN_SLIPS};
    for (int i = 0; i < 4; ++i) {
        coin_body b = moving[i];
        check_note("body %d", i);
        check_status(coin_move(&b, &p, &f, 0, 1e-6, 0, NULL), mode[i]);
    }
}
