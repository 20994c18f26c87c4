/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/losses.h"
#include "support/methods.h"
#include "support/random.h"

#include <math.h>

/* ------------------------------------------------------------ exact oracles */
TEST(upright_the_laws_are_closed_forms)
{
    const coin_params p = disc();
    const double t = 7, K = 1.5, IX = 0.25, IZ = 0.5;
    const struct {
        coin_losses l;
        coin_state start, end;
    } cases[] = {
        {{.dry = 0.01, .soft = 1e-8},
         {.wZ = 2},
         {.psi = 2 * t - 0.01 * t * t / (2 * K), .wZ = 2 - 0.01 * t / K}},
        {{.rolling = 0.01, .soft = 1e-8},
         {.wZ = -2},
         {.psi = -2 * t + 0.01 * t * t / (2 * K), .wZ = -2 + 0.01 * t / K}},
        {{.viscous = 0.01},
         {.wZ = 2},
         {.psi = 2 * K / 0.01 * (1 - exp(-0.01 * t / K)),
          .wZ = 2 * exp(-0.01 * t / K)}},
        {{.gap = 0.01},
         {.wZ = 2},
         {.psi = 2 * K / 0.01 * (1 - exp(-0.01 * t / K)),
          .wZ = 2 * exp(-0.01 * t / K)}},
        {{.layer = 0.01},
         {.wZ = 4},
         {.psi = 4 * t / (1 + 0.01 * t / K), .wZ = 0}},
        {{.damping = 0.05},
         {.wZ = 2},
         {.psi = log(1 + 0.1 * t) / 0.05, .wZ = 2 / (1 + 0.1 * t)}},
        {{.angular = 0.01}, /* I_Z of the K of rolling */
         {.wZ = 2},
         {.psi = 2 * K / (0.01 * IZ) * (1 - exp(-0.01 * IZ * t / K)),
          .wZ = 2 * exp(-0.01 * IZ * t / K)}},
        {{.angular = 0.01},
         {.wY = 2},
         {.phi = 2 / 0.01 * (1 - exp(-0.01 * t)), .wY = 2 * exp(-0.01 * t)}},
        {{.spin = 0.01},
         {.wY = 2},
         {.phi = 2 * IX / 0.01 * (1 - exp(-0.01 * t / IX)),
          .wY = 2 * exp(-0.01 * t / IX)}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coin_state s = cases[i].start, want = cases[i].end;
        if (cases[i].l.layer > 0) { /* d(1/sqrt wZ)/dt = layer/(2 K) */
            const double a = 0.01 / (2 * K), r = 0.5 + a * t;
            want.wZ = 1 / (r * r);
            want.psi = (1 / 0.5 - 1 / r) / a;
        }
        want.x = -want.psi;
        check_note("case %zu", i);
        check_status(coin_settle(&s, &p, &cases[i].l, t, 1e-12, NULL), COIN_OK);
        check_within(states_apart(&s, &want, &p), 0, 1e-11);
        check(s.theta == 0 && s.wX == 0);
    }
}

/* Dry friction takes its torque times the angle rolled, however it is rolled.
 * While the contact is held nothing more is lost. */
TEST(dry_friction_allows_a_number_of_turns)
{
    const coin_params p = disc();
    const coin_losses l = {.dry = 0.002, .soft = 0x1p-30};
    coin_state s = spun;
    const double E = coin_energy(&s, &p);
    check_status(settle(&s, &p, &l, 1e-11, NULL), COIN_RESTS);
    check_near(E - coin_energy(&s, &p), 0.002 * s.psi, 1e-9);
    check_within(s.psi, 220, 230);
}

/* Where it lies at last the face turns backward, by the same for each law of
 * contour friction: (5/9) e0^(3/2) to leading order in the lean e0. */
TEST(the_face_turns_backward_at_the_end_by_any_law)
{
    const coin_params p = disc();
    const coin_losses laws[] = {
        {.dry = 2e-4}, {.viscous = 2e-5}, {.layer = 2e-5}, {.gap = 2e-6}};
    for (int i = 0; i < 4; ++i) {
        const double e0 = 0.1;
        coin_state s;
        check_status(coin_steady_spin(&s, &p, 1.5707963267948966 - e0),
                     COIN_OK);
        check_status(settle(&s, &p, &laws[i], 1e-8, NULL), COIN_RESTS);
        check_note("law %d", i);
        check_near(s.wZ / (5.0 / 9 * e0 * sqrt(e0)), 1, 0.05);
    }
}

/* Eq. (75): the time to rest of small losses from a small angle. */
TEST(the_times_to_rest_are_those_of_the_laws)
{
    const coin_params p = disc();
    const double e = 0.02;
    const struct {
        coin_losses l;
        double time;
    } laws[] = {
        {{.dry = 2e-6}, e * sqrt(e) / (2 * 2e-6)},
        {{.viscous = 1e-7}, 3 * e * e / (16 * 1e-7)},
        {{.layer = 1e-7}, e * e * sqrt(sqrt(e)) / (8.48528 * 1e-7)},
        {{.gap = 1e-9}, e * e * e / (8 * 1e-9)},
        {{.rolling = 1e-3}, 1.5 * sqrt(e) / 1e-3},
        {{.damping = 1e-3}, 1.5 * sqrt(e) / 1e-3},
    };
    for (size_t i = 0; i < sizeof laws / sizeof *laws; ++i) {
        coin_state s;
        double when;
        check_status(coin_steady_spin(&s, &p, 1.5707963267948966 - e), COIN_OK);
        check_status(settle(&s, &p, &laws[i].l, 1e-5, &when), COIN_RESTS);
        check_note("law %zu", i);
        check_near(when / laws[i].time, 1, laws[i].l.rolling > 0 ? 0.08 : 0.02);
    }
}

/* A flat coin accelerates by g a/J: what is left of its weight is I_X/J. */
TEST(in_the_last_fall_a_fifth_of_the_weight_is_left)
{
    const coin_params p = disc();
    const coin_losses l = {.dry = 0.002};
    coin_state s = spun;
    coin_force f;
    check_status(settle(&s, &p, &l, 1e-6, NULL), COIN_RESTS);
    check_status(coin_losses_reaction(&s, &p, &l, &f), COIN_OK);
    check_near(f.normal, 0.2, 1e-12);
}

/* The shift by the softening is of second order in it. */
TEST(the_softening_shifts_rest_by_its_square)
{
    const coin_params p = disc();
    double when[4];
    for (int i = 0; i < 4; ++i) {
        const double soft[] = {1, 0.125, 0.015625, 0x1p-20};
        const coin_losses l = {.dry = 0.002, .soft = soft[i]};
        coin_state s = spun;
        check_status(settle(&s, &p, &l, 1e-11, &when[i]), COIN_RESTS);
    }
    check_within((when[0] - when[3]) / (when[1] - when[3]), 40, 90);
    check_within((when[1] - when[3]) / (when[2] - when[3]), 50, 80);
}

/* ------------------------------------------------------------------- at rest
 */
TEST(a_coin_at_rest_stays_there)
{
    const coin_params p = disc();
    const coin_losses l = {.dry = 0.002}, none = {0};
    coin_state s = spun;
    double reached = 7;
    check_status(settle(&s, &p, &l, 1e-6, NULL), COIN_RESTS);
    check_status(coin_state_check(&s, &p), COIN_OK);
    check(s.theta == 1.5707963267948963 && s.wY == 0 && s.wX > 0);
    const coin_state flat = s;
    check_status(coin_settle(&s, &p, &l, 0, 1e-6, &reached), COIN_RESTS);
    check(reached == 0);
    reached = 7;
    check_status(coin_settle(&s, &p, &none, 5, 1e-6, &reached), COIN_RESTS);
    check(reached == 0);
    check_same(&s, &flat, sizeof s);
    check_status(coin_settle(&s, &p, &l, 5, 1e-6, NULL), COIN_RESTS);
    check_same(&s, &flat, sizeof s);
    reached = 7;
    check_status(coin_advance(&s, &p, 5, 1e-6, &reached), COIN_EFLAT);
    check(reached == 0);
    check_status(coin_advance(&s, &p, 5, 1e-6, NULL), COIN_EFLAT);
    check_same(&s, &flat, sizeof s);
    check(coin_losses_power(&s, &p, &l) >= 0);
    coin_state still = flat; /* no rate is left */
    still.wX = still.wZ = 0;
    check_status(coin_settle(&still, &p, &l, 0, 1e-6, NULL), COIN_RESTS);
    reached = 7;
    check_status(coin_advance(&still, &p, 5, 1e-6, &reached), COIN_EFLAT);
    check(reached == 0);
    s.wX = -s.wX; /* it rises */
    check_status(coin_advance(&s, &p, 1e-3, 1e-6, NULL), COIN_OK);
    check(s.theta < flat.theta);
}

/* Nearer than `flat` it lies flat, even if it rises; else it may rise. */
TEST(a_coin_rises_from_beyond_flat_alone)
{
    const coin_params p = disc();
    const coin_state start = {.theta = -1.5707963267, .wX = 0.5};
    const double flats[] = {0, 1e-9, 1e-12};
    for (int i = 0; i < 3; ++i) {
        const coin_losses l = {.damping = 0.01, .flat = flats[i]};
        coin_state s = start;
        check_status(coin_settle(&s, &p, &l, 0.1, 1e-8, NULL),
                     i < 2 ? COIN_RESTS : COIN_OK);
        check_within(cos(s.theta), i < 2 ? 0 : 0.02, i < 2 ? 1e-15 : 0.1);
    }
}

/* Without a stop, and too close for a pass to be told from a fall. */
TEST(a_pass_closer_than_a_double_can_tell_is_a_fall)
{
    coin_params p;
    check_status(coin_params_body(&p, 1, 1, 1, 0.4, 0.5), COIN_OK);
    const coin_losses l = {.damping = 0.1};
    coin_state s = {.theta = 1.56, .wX = 0.1, .wZ = 1e-30};
    double when;
    check_status(coin_settle(&s, &p, &l, 5, 1e-8, &when), COIN_RESTS);
    const double e = 1.5707963267948966 - 1.56, A = 1 / 1.4;
    check_near(when, (sqrt(0.01 + 2 * A * e) - 0.1) / A, 1e-4);
    check(s.wY == 0 && s.wX > 0.1);
}

TEST(a_coin_that_nothing_leans_rests_on_its_edge)
{
    const coin_params p = disc();
    const coin_losses l = {.damping = 0.1, .spin = 0.1};
    const coin_state stands = {.phi = 1, .x = 2};
    coin_state s = stands;
    double moved = 1;
    check_status(coin_settle(&s, &p, &l, 100, 1e-8, &moved), COIN_RESTS);
    check(moved == 0);
    check_same(&s, &stands, sizeof s);
    s.wZ = 0.5e-10;
    check_status(coin_settle(&s, &p, &l, 0, 1e-8, &moved), COIN_RESTS);
    check(moved == 0 && s.wZ == 0.5e-10);
    check_status(coin_settle(&s, &p, &l, 1, 1e-8, &moved), COIN_RESTS);
    check(moved == 0 && s.wZ == 0);
    const coin_losses damps = {.damping = 0.1};
    coin_params q;
    check_status(coin_params_disc(&q, 0.00567, 0.01213, 9.81), COIN_OK);
    for (s.x = 0.1; s.x < 0.2; s.x += 0.01) {
        const coin_state before = s; /* no rounding by units */
        check_status(coin_settle(&s, &q, &damps, 100, 1e-8, NULL), COIN_RESTS);
        check_same(&s, &before, sizeof s);
    }
    s = stands;
    s.wZ = 2e-10;
    const coin_losses viscous = {.viscous = 0.15};
    check_status(coin_settle(&s, &p, &viscous, INFINITY, 1e-8, &moved),
                 COIN_RESTS);
    check_near(moved, 10 * log(2), 1e-7); /* at 1e-10: wZ' = -0.1 wZ */
    check(s.theta == 0 && s.wX == 0 && s.wY == 0 && s.wZ == 0);
    check_near(coin_time_to_rest(&stands, &p, &l, 1e-6), 0, 0);
}

/* The fall of a fast turn is a quarter of an oscillation. */
TEST(a_fast_turn_is_held_too)
{
    const coin_params p = disc();
    for (double turn = 11; turn < 23; turn *= 2) {
        const coin_losses l = {.dry = turn * turn / 500};
        const double e = 0.04;
        coin_state s = {.theta = 1.5707963267948966 - e,
                        .wY = turn * sin(e),
                        .wZ = -turn * cos(e)};
        const double E = coin_energy(&s, &p);
        double when;
        check_note("turn %g", turn);
        check_status(coin_settle(&s, &p, &l, 5, 1e-8, &when), COIN_RESTS);
        check_within(when, 0.3 / turn, 3 / turn);
        check_near(s.psi, 0, 1e-6);
        check_near(coin_energy(&s, &p) / E, 1, 4e-8); /* measured: 1.1e-8 */
        check_near(s.wZ / -turn, 1, 2e-3);
    }
}

/* Each falls as it is held, at once: in the plane, or turning about the
 * vertical, or rising at first. */
TEST(a_stopped_contact_near_flat_is_held)
{
    const coin_params p = disc();
    const coin_losses l = {.dry = 0.1, .spin = 0.2, .flat = 1e-10};
    for (int turns = 0; turns < 2; ++turns)
        for (int k = 0; k < 3; ++k) {
            const int side = (turns + k) % 2 ? 1 : -1;
            const double turn = 0.9 * turns;
            const double e = 0.03, v[] = {0, 0.1, -0.05};
            coin_state s = {.theta = side * (1.5707963267948966 - e),
                            .phi = 1,
                            .wX = side * v[k],
                            .wY = turn * sin(e),
                            .wZ = -side * turn * cos(e)};
            const coin_state start = s;
            const double E = coin_energy(&s, &p);
            double when = 0, sum = 0, reached;
            check_note("side %d, v %g, turn %g", side, v[k], turn);
            check_status(coin_settle(&s, &p, &l, 9, 1e-8, &when), COIN_RESTS);
            /* With the acceleration of the flat coin. */
            const double A = 0.8;
            const double fall = (sqrt(v[k] * v[k] + 2 * A * e) - v[k]) / A;
            check_near(when, fall, 0.02 * fall);
            check(s.wY == 0 && side * s.wX > 0);
            /* Softened friction gives the torque of (73) at a slow roll. */
            const double K = 1.5, IX = 0.25, soft = 1e-3;
            const double top = e + fmin(v[k], 0) * v[k] / (2 * A);
            const double torque = 0.2 * turn * top * top * (K - IX) / K;
            const double creep = soft * torque / 0.1 * when;
            check_near(s.psi, start.psi, creep);
            /* Of the energy only the pivoting takes its part. */
            check_near(E - coin_energy(&s, &p),
                       K / 2 * turn * turn * (1 - exp(-2 * 0.2 * when / K)),
                       1e-4 * turn + 1e-9); /* tol 1e-8 */
            check_near(s.phi - 1, turn * when, 0.1 * turn * when + 1e-15);
            /* The point of contact stays. */
            check_near(s.x, start.x + side * (sin(s.phi) - cos(e) * sin(1)),
                       1e-7 + creep);
            coin_state by = start;
            int32_t status;
            do {
                status = coin_settle(&by, &p, &l, when / 7.5, 1e-8, &reached);
                sum += reached;
                check(reached <= when / 7.5);
            } while (status == COIN_OK);
            check_status(status, COIN_RESTS);
            check_near(sum, when, 1e-8); /* tol 1e-8 */
            check_near(by.wZ, s.wZ, 1e-8);
        }
}

/* It rolls at 1e-9, which counts as stopped, and is left out at once.  What is
 * left is the rounding of the lean times the turn, and that of two terms. */
TEST(a_contact_that_counts_as_stopped_does_not_roll)
{
    const coin_params p = disc();
    const coin_losses l = {.dry = 0.1};
    const double e = 0.01, turn = 0.5;
    coin_state s = {.theta = 1.5707963267948966 - e,
                    .wX = -0.5,
                    .wY = turn * sin(e) + 1e-9,
                    .wZ = -turn * cos(e)};
    check_status(coin_settle(&s, &p, &l, 1e-3, 1e-6, NULL), COIN_OK);
    check(s.psi == 0);
    check_near(cos(s.theta) * s.wZ + sin(s.theta) * s.wY, 0, 16 * U * turn);
}

/* A stopped contact that rises: in one call and in ten. */
TEST(a_rise_is_held_call_by_call)
{
    const coin_params p = disc();
    const coin_losses l = {.dry = 0.1};
    const double e = 0.01, turn = 0.5;
    coin_state s = {.theta = 1.5707963267948966 - e,
                    .wX = -0.5,
                    .wY = turn * sin(e),
                    .wZ = -turn * cos(e)};
    coin_state parts = s;
    double reached;
    check_status(coin_settle(&s, &p, &l, 0.02, 1e-8, NULL), COIN_OK);
    for (int i = 0; i < 10; ++i) {
        check_status(coin_settle(&parts, &p, &l, 0.002, 1e-8, &reached),
                     COIN_OK);
        check(reached == 0.002);
        check(parts.psi == 0);
    }
    check_within(states_apart(&s, &parts, &p), 0, 1e-13);
    check_near(s.theta, 1.5707963267948966 - e - 0.01 + 0.4 * 4e-4, 1e-5);
}

/* A coin that rises from a stopped contact at such a speed that steps are long:
 * the contact begins to roll where its hold ends, not at the end of a step.  A
 * held contact does not roll, and a new call finds it as it is. */
TEST(a_held_coin_that_rises_is_let_go_in_time)
{
    const coin_params p = disc();
    const coin_losses l = {.viscous = 0.3};
    const double c = 2e-3, turn = 3;
    const coin_state start = {.theta = acos(c),
                              .wX = -1,
                              .wY = turn * c / sqrt(1 - c * c),
                              .wZ = -turn};
    coin_state exact = start;
    check_status(coin_settle(&exact, &p, &l, 0.5, 1e-12, NULL), COIN_OK);
    check(fabs(exact.psi) > 1e-3);
    for (double tol = 1e-4; tol > 1e-11; tol *= 0.1) {
        for (int calls = 1; calls <= 64; calls *= 8) {
            coin_state s = start;
            for (int i = 0; i < calls; ++i)
                check_status(coin_settle(&s, &p, &l, 0.5 / calls, tol, NULL),
                             COIN_OK);
            check_note("tol %g, %d calls", tol, calls);
            check_within(path_apart(&s, &exact, &p), 0, 5 * tol);
        }
    }
}

/* Held by too weak a friction a contact does not stay. */
TEST(a_contact_that_cannot_be_held_rolls_on)
{
    const coin_params p = disc();
    const coin_losses l = {.dry = 1e-9};
    const double e = 0.03, turn = 2;
    coin_state s = {.theta = 1.5707963267948966 - e,
                    .wX = -0.1,
                    .wY = turn * sin(e),
                    .wZ = -turn * cos(e)};
    check_status(coin_settle(&s, &p, &l, 1, 1e-8, NULL), COIN_OK);
    check(fabs(s.psi) > 1e-6);
}

TEST(a_symmetric_fall_is_an_ideal_one)
{
    const coin_params p = disc();
    const coin_losses l = {
        .damping = 0.1, .dry = 0.1, .viscous = 0.1, .flat = 1e-12};
    coin_state s = {.theta = 0.3}, ideal = s;
    double when, right;
    check_status(coin_settle(&s, &p, &l, 99, 1e-10, &when), COIN_RESTS);
    check_status(coin_advance(&ideal, &p, 99, 1e-10, &right), COIN_EFLAT);
    check_near(when, right, 1e-9);
    check_near(s.wX, ideal.wX, 1e-9);
}

/* By its small roll this coin passes at 3e-8 rad from flat, nearer than the
 * default of `flat`, and rises at its speed before. */
TEST(without_losses_no_lean_is_flat)
{
    const coin_params p = disc();
    const coin_losses none = {0}, least = {.viscous = 1e-12};
    const coin_state start = {
        .theta = 1.5707963267948966 - 0.04, .wX = 0.5, .wY = 4e-7};
    coin_state s = start, lossy = start;
    check_status(coin_settle(&s, &p, &none, 0.15, 1e-9, NULL), COIN_OK);
    check_near(s.wX, -0.5, 0.01);
    check_status(coin_settle(&lossy, &p, &least, 0.15, 1e-9, NULL), COIN_RESTS);
}
