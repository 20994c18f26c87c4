/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/far.h"
#include "support/losses.h"
#include "support/methods.h"
#include "support/random.h"
#include "support/slides.h"

#include <math.h>

/* ----------------------------------------------------------- without losses */
TEST(without_losses_it_is_coin_advance)
{
    const coin_losses none = {.soft = 0.5, .flat = 1e-3};
    struct random r = random_begin(153);
    const int count = tries_asked(20);
    int near = 0; /* unstable motions amplify the errors of both */
    for (int i = 0; i < count; ++i) {
        const coin_params p = random_coin(&r);
        coin_state a = random_state(&r, &p, 1.57), b = a;
        double reached, right;
        const double t = 9 * natural_time(&p);
        check_status(coin_settle(&a, &p, &none, t, 1e-7, &reached), COIN_OK);
        check_status(coin_advance(&b, &p, t, 1e-7, &right), COIN_OK);
        near += path_apart(&a, &b, &p) <= 2e-7 * (1 + 9);
        check(reached == right);
    }
    check_share(near, count, 0.99);
    const coin_params p = disc();
    coin_state a = {.theta = 0.3}, b = a;
    double reached, right;
    check_status(coin_settle(&a, &p, &none, 9, 1e-7, &reached), COIN_RESTS);
    check_status(coin_advance(&b, &p, 9, 1e-7, &right), COIN_EFLAT);
    check_near(a.wX, b.wX, 1e-6);
    check_near(reached, right, 1e-6);
}

/* What a game does: all of them a frame further, until the last one rests. */
TEST(many_coins_in_a_loop_settle_as_each_alone)
{
    enum { COINS = 24, FRAMES = 240 };
    const coin_params p = ring(0.5);
    coin_losses l[COINS];
    coin_state start[COINS], s[COINS];
    int at_rest[COINS] = {0}, resting = 0;
    struct random r = random_begin(157);
    for (int i = 0; i < COINS; ++i) {
        l[i] = random_losses(&r, &p, 0.5);
        l[i].dry += 0.05;
        start[i] = s[i] = random_state(&r, &p, 1.5);
    }
    for (int frame = 0; frame < FRAMES; ++frame)
        for (int i = 0; i < COINS; ++i)
            if (!at_rest[i] &&
                coin_settle(&s[i], &p, &l[i], 0.5, 1e-6, NULL) == COIN_RESTS) {
                at_rest[i] = frame + 1;
                ++resting;
            }
    check_within(resting, COINS - 2, COINS); /* some may stand upright */
    for (int i = 0; i < COINS; ++i) {
        coin_state alone = start[i];
        int32_t status = COIN_OK;
        int frames = 0;
        for (; status == COIN_OK && frames < FRAMES; ++frames)
            status = coin_settle(&alone, &p, &l[i], 0.5, 1e-6, NULL);
        check_note("coin %d", i);
        check(frames == (at_rest[i] ? at_rest[i] : FRAMES));
        check_same(&alone, &s[i], sizeof alone);
    }
}

TEST(a_time_of_0_changes_nothing)
{
    const coin_params p = disc();
    const coin_losses l = {.dry = 0.1};
    const coin_state before = {0.5, -0.0, 2e9, 1e9, -0.0, 0.1, -0.0, 1.2};
    coin_state s = before;
    double reached = 7;
    check_status(coin_settle(&s, &p, &l, 0, 1e-6, &reached), COIN_OK);
    check_same(&s, &before, sizeof s);
    check(reached == 0);
}

/* ---------------------------------------------------------------- symmetries
 */
TEST(in_units_a_power_of_two_apart_every_bit_is_the_same)
{
    struct random r = random_begin(154);
    for (int i = 0; i < 20; ++i) {
        const double L = ldexp(1, (int)random_between(&r, -12, 12));
        const double T = ldexp(1, 2 * (int)random_between(&r, -8, 8));
        coin_params p, q;
        check_status(coin_params_ring(&p, 1, 1, 0.5, 1), COIN_OK);
        check_status(coin_params_ring(&q, 4, L, L / 2, L / (T * T)), COIN_OK);
        const coin_losses l = random_losses(&r, &p, 0.5);
        const coin_losses m = losses_in(&l, 4, L, T);
        coin_state s = random_state(&r, &p, 1.57);
        coin_state t = state_in(&s, L, T);
        double a, b;
        const int32_t status = coin_settle(&s, &p, &l, 5, 1e-8, &a);
        check_status(coin_settle(&t, &q, &m, 5 * T, 1e-8, &b), status);
        s = state_in(&s, L, T);
        check_same(&t, &s, sizeof s);
        check(b == a * T);
    }
}

TEST(mirrored_every_bit_is_the_same)
{
    struct random r = random_begin(155);
    for (int i = 0; i < 20; ++i) {
        const coin_params p = ring(0.5);
        const coin_losses l = random_losses(&r, &p, 0.5);
        coin_state s = random_state(&r, &p, 1.57);
        coin_state m = {-s.theta, s.phi, -s.psi, -s.x,
                        -s.z,     -s.wX, s.wY,   -s.wZ};
        const int32_t status = coin_settle(&s, &p, &l, 5, 1e-8, NULL);
        check_status(coin_settle(&m, &p, &l, 5, 1e-8, NULL), status);
        check(m.theta == -s.theta && m.phi == s.phi && m.psi == -s.psi);
        check(m.x == -s.x && m.z == -s.z && m.wX == -s.wX);
        check(m.wY == s.wY && m.wZ == -s.wZ);
    }
}

/* ------------------------------------------------------------------ statuses
 */
/* So near to flat that no step is left to make. */
TEST(a_coin_that_lies_at_once_lies_flat)
{
    const coin_params p = disc();
    const coin_losses l = {.damping = 1};
    for (int i = 0; i < 4; ++i) { /* it falls, or rises */
        const int side = i & 1 ? -1 : 1;
        coin_state s = {.theta = side * 1.5707963267948819,
                        .wX = i & 2 ? -2e-9 : 2e-9,
                        .wZ = 1.5};
        double reached;
        check_status(coin_settle(&s, &p, &l, 1e-6, 1e-3, &reached), COIN_RESTS);
        check(reached == 0);
        check(side * s.theta > 1.570796326794896 && side * s.wX > 0);
        check(s.wY == 0);
    }
}

TEST(a_heading_out_of_range_ends_the_call)
{
    const coin_params p = disc();
    const coin_losses l = {.spin = 1e-9};
    coin_state s = {.phi = 0x1p31 - 100, .wY = 10};
    double reached = 7;
    check_status(coin_settle(&s, &p, &l, 20, 1e-6, &reached), COIN_ERANGE);
    check_status(coin_state_check(&s, &p), COIN_OK);
    check_within(reached, 9.8, 10);
    check_near(s.phi, 0x1p31 - 100 + 10 * reached, 1e-3);
}

TEST(a_call_takes_2_20_steps_and_the_next_goes_on)
{
    check_million();
    const coin_params p = disc();
    const coin_losses l = {.spin = 1e-12};
    const double wY = 1e4, way = 1e3;
    coin_state s = {.wY = wY};
    double reached;
    check_status(coin_settle(&s, &p, &l, way, 1e-2, &reached), COIN_MORE);
    check_within(reached, 10, way / 2);
    check_near(s.phi, wY * reached, 1e-2 * reached);
    const double before = reached;
    check_status(coin_settle(&s, &p, &l, 1, 1e-2, &reached), COIN_OK);
    check_near(s.phi, wY * (before + 1), 1e-2 * before);
}

TEST(a_place_out_of_range_is_not_reached)
{
    coin_params p;
    double dt, reached = 7;
    coin_state s = far_coin(&p, 1, &dt);
    const coin_losses l = {.damping = 1e-12};
    check_status(coin_settle(&s, &p, &l, 100 * dt, 1e-6, &reached),
                 COIN_ERANGE);
    check_within(reached, 6 * dt, 14 * dt);
    check_status(coin_state_check(&s, &p), COIN_OK);
}

TEST(the_usual_errors_touch_nothing)
{
    const coin_params good = disc();
    coin_params bad = good;
    bad.radius = -1;
    const coin_losses fine = {.dry = 0.1}, wrong = {.dry = -1};
    const coin_state start = spun, flat = {.theta = 2, .wY = 1};
    const struct {
        coin_state s;
        const coin_params *p;
        const coin_losses *l;
        double t, tol;
        int32_t want;
    } cases[] = {
        {flat, &bad, &wrong, NAN, 0, COIN_EARG},
        {flat, &bad, &wrong, NAN, 0.99e-12, COIN_EARG},
        {flat, &bad, &wrong, NAN, 1.01e-2, COIN_EARG},
        {flat, &bad, &wrong, NAN, NAN, COIN_EARG},
        {flat, NULL, &wrong, NAN, 1e-6, COIN_EARG},
        {flat, &bad, NULL, NAN, 1e-6, COIN_EARG},
        {flat, &bad, &fine, NAN, 1e-6, COIN_EPARAMS},
        {flat, &good, &wrong, NAN, 1e-6, COIN_EPARAMS},
        {flat, &good, &fine, NAN, 1e-6, COIN_ESTATE},
        {start, &good, &fine, NAN, 1e-6, COIN_ESTEP},
        {start, &good, &fine, -1e-300, 1e-6, COIN_ESTEP},
        {start, &good, &fine, 1.01e15, 1e-6, COIN_ESTEP},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coin_state s = cases[i].s;
        double reached = 7;
        check_note("case %zu", i);
        check_status(coin_settle(&s, cases[i].p, cases[i].l, cases[i].t,
                                 cases[i].tol, &reached),
                     cases[i].want);
        check_same(&s, &cases[i].s, sizeof s);
        check(reached == 7);
    }
    check_status(coin_settle(NULL, &good, &fine, 1, 1e-6, NULL), COIN_EARG);
}

/* The time left is held by two doubles, so that a call may be far too long. */
TEST(how_long_the_call_is_does_not_change_when_it_ends)
{
    const coin_params p = disc();
    const coin_losses l = {.dry = 0.1};
    const coin_table f = {.mu_static = 0.5, .mu_kinetic = 0.45};
    double first[4];
    for (double t = 30; t < 2e15; t = t < 1e9 ? 1e9 : t * 1e6) {
        coin_state falls = {.theta = 0.3}, rests;
        coin_body d, passes;
        double when[4];
        check_status(coin_steady_spin(&rests, &p, 1.2), COIN_OK);
        check_status(coin_body_from_state(&d, &falls, &p), COIN_OK);
        passes = d;
        check_status(coin_move(&passes, &p, &f, t, 1e-10, COIN_SLIPS, &when[0]),
                     COIN_SLIPS);
        check_status(coin_advance(&falls, &p, t, 1e-10, &when[1]), COIN_EFLAT);
        check_status(coin_settle(&rests, &p, &l, t, 1e-10, &when[2]),
                     COIN_RESTS);
        check_status(coin_move(&d, &p, &f, t, 1e-10, 0, &when[3]), COIN_RESTS);
        for (int i = 0; i < 4; ++i) {
            first[i] = t == 30 ? when[i] : first[i];
            check_note("t %g, call %d", t, i);
            check_near(when[i], first[i], 1e-12);
        }
    }
}

/* However strong it is, pivoting friction only ends the turn of the fall. Where
 * the contact is held, L = D d(phi)/dt decays at b/D, and D is K (1 - c^2 k).
 */
TEST(strong_pivoting_friction_ends_the_turn_of_a_fall)
{
    const coin_params p = disc();
    const double c = 0.045, turn = 0.1;
    coin_state free = {.theta = acos(c)};
    double falls;
    const coin_losses dry = {.dry = 1, .soft = 1e-9};
    check_status(coin_settle(&free, &p, &dry, 10, 1e-9, &falls), COIN_RESTS);
    for (double b = 30; b < 300; b *= 2) {
        const coin_losses l = {.dry = 1, .spin = b, .soft = 1e-9};
        coin_state s = {
            .theta = acos(c), .wY = c * turn, .wZ = -sqrt(1 - c * c) * turn};
        double when;
        check_status(coin_settle(&s, &p, &l, 10, 1e-9, &when), COIN_RESTS);
        check_note("b = %g", b);
        check_near(s.phi, turn * 1.5 / b, 2 * c * c * turn * 1.5 / b);
        check_near(s.wX, free.wX, 1e-4);
        check_near(when, falls, 1e-4);
    }
}

/* A coin whose wZ is as good as 0 falls flat, and so comes to rest. */
TEST(what_falls_flat_without_losses_stays_flat)
{
    const coin_params p = disc();
    const coin_losses none = {0};
    coin_state s = {.theta = 0.3, .wZ = 1e-31};
    double when;
    check_status(coin_settle(&s, &p, &none, 20, 1e-9, &when), COIN_RESTS);
    check_within(when, 2.6, 2.7);
    check(s.wY == 0);
    check_status(coin_settle(&s, &p, &none, 20, 1e-9, &when), COIN_RESTS);
    check(when == 0);
    /* The last step leads from just above flat to just below it, upward. */
    const coin_state fast[] = {
        {.theta = -0x1.1969e34ade0bap+0,
         .wX = -0x1.4b7870972f4ccp-2,
         .wY = 0x1.c52d5dd8ddfc8p-99,
         .wZ = -0x1.168ef911354cbp-99},
        {.theta = 0x1.fb4f73456b2cfp-2,
         .wY = 0x1.2bd567f298d62p-98,
         .wZ = -0x1.197fec202285ep-99},
    };
    for (int i = 0; i < 2; ++i) {
        s = fast[i];
        const double tol = i ? 2.80131e-3 : 3.28256e-4;
        check_status(coin_settle(&s, &p, &none, 20, tol, NULL), COIN_RESTS);
        check(s.wX * s.theta > 0);
        check_status(coin_settle(&s, &p, &none, 20, tol, &when), COIN_RESTS);
        check(when == 0);
    }
}

/* Losses of a coin that turns about the vertical on a contact that stands: they
 * do not act at the start, and are far too strong for the first step. */
TEST(strong_losses_of_a_contact_that_stands)
{
    const coin_params p = disc();
    const coin_table endless = {.mu_static = INFINITY, .mu_kinetic = 0.5};
    const coin_state start = {.theta = 0.3, .wY = cos(0.3), .wZ = -sin(0.3)};
    for (double size = 1e2; size <= 1e3; size *= 3) {
        const coin_losses layer = {.layer = size};
        coin_state s = start, sharp = start;
        coin_body d;
        double reached;
        check_note("%g", size);
        check_status(coin_settle(&sharp, &p, &layer, 1, 1e-9, NULL), COIN_OK);
        check_status(coin_settle(&s, &p, &layer, 1, 1e-3, &reached), COIN_OK);
        check(reached == 1);
        check_near(s.theta, sharp.theta, 1e-3);
        check_near(s.phi, sharp.phi, 1e-3);
        check_status(coin_body_from_state(&d, &start, &p), COIN_OK);
        check_status(slide(&d, &p, &endless, &layer, 1, 1e-3, &reached),
                     COIN_OK);
        check(reached == 1);
        check_near(d.s.theta, sharp.theta, 1e-3);
    }
}

/* The contact is held, and the fall or the rise turns it on. */
TEST(a_heading_out_of_range_ends_a_held_fall)
{
    const coin_params p = disc();
    const coin_losses dry = {.dry = 2e-3}, strong = {.dry = 1};
    coin_state s, start;
    double reached, rest;
    check_status(coin_steady_circle(&start, &p, 1.4, -0.3, 1), COIN_OK);
    s = start;
    check_status(coin_settle(&s, &p, &dry, 1000, 1e-9, &rest), COIN_RESTS);
    start.phi = 0x1p31 - s.phi + 1e-3;
    check(s.phi > 16); /* far from its range at the start */
    s = start;
    check_status(coin_settle(&s, &p, &dry, 1000, 1e-9, &reached), COIN_ERANGE);
    check_within(reached, rest - 0.1, rest);
    check_near(s.phi, 0x1p31, 0.1);
    start = (coin_state){.theta = 1.5657963267948966, .wX = -0.01};
    start.wY = cos(start.theta);
    start.wZ = -sin(start.theta);
    s = start;
    check_status(coin_settle(&s, &p, &strong, 1e-3, 1e-9, NULL), COIN_OK);
    check(s.phi > 9e-4 && s.psi == 0);
    start.phi = 0x1p31;
    s = start;
    check_status(coin_settle(&s, &p, &strong, 1e-3, 1e-9, &reached),
                 COIN_ERANGE);
    check(reached < 1e-5);
}
