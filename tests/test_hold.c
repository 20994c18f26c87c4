/* SPDX-License-Identifier: MIT */
/* The losses hold a contact that has stopped as long as they have the torque
 * for it. */
#include "hold.h"
#include "run.h"
#include "slide.h"

#include "support/check.h"
#include "support/coins.h"
#include "support/random.h"

#include <coinf.h>

#include <math.h>

/* The torque on the roll that keeps d(psi)/dt at 0, by the rates of a coin with
 * pivoting friction alone: a torque Q changes u = cos theta d(psi)/dt by
 * Q (s^2/I_X + c^2/K)/c. */
static double torque_needed(const coin_state *s, const coin_params *p,
                            double spin)
{
    coin_state d;
    const coin_losses pivoting = {.spin = spin};
    check_status(coin_losses_rates(s, p, &pivoting, &d), COIN_OK);
    const double c = cos(s->theta), sth = sin(s->theta);
    const double K = p->inertia_Z + p->mass * p->radius * p->radius;
    const double du = c * d.wZ + sth * d.wY + s->wX * (c * s->wY - sth * s->wZ);
    return fabs(du) * c / (sth * sth / p->inertia_X + c * c / K);
}

/* Dry friction that gives a hundredth more than the torque needed holds the
 * contact; a hundredth less does not. */
static void check_held(const coin_state *s, const coin_params *p, double spin)
{
    coin_priv_run run;
    coin_priv_losses l;
    const double eps = 1e-12;
    run.b = coin_priv_body_of(p);
    coin_priv_run_unlimited(&run, s);
    const coin_priv_variables *y = &run.g.y;
    coin_losses dry = {.dry = 1, .spin = spin};
    check_status(coin_priv_losses_of(&l, &dry, &run.b), COIN_OK);
    const double slow2 = coin_priv_stopped_speed2(&run.b, y, eps);
    const double torque = coin_priv_holding_torque(&l, slow2, y->cth);
    const double need = torque_needed(s, p, spin);
    for (int more = 0; more < 2; ++more) {
        dry.dry = (more ? 1.01 : 0.99) * need / torque;
        check_status(coin_priv_losses_of(&l, &dry, &run.b), COIN_OK);
        check(coin_priv_is_held(&l, &run.b, y, eps) == more);
    }
}

/* In a fall so fast that gravity hardly adds to it, the torque needed now is
 * the largest. */
static void losses_hold_the_torque_that_they_have(void **unused)
{
    (void)unused;
    struct random r = random_begin(188);
    for (int i = 0; i < 200; ++i) {
        coin_params p;
        const double IX = random_between(&r, 0.1, 0.5);
        const double from_flat = random_between(&r, 0.01, 0.04);
        const double turn = random_between(&r, -5, 5);
        const double fall = random_between(&r, 40, 60);
        const double side = i % 2 ? 1 : -1;
        check_status(coin_params_body(&p, 1, 1, 1, IX,
                                      IX * random_between(&r, 0.5, 1.5)),
                     COIN_OK);
        const coin_state s = {.theta = side * (1.5707963267948966 - from_flat),
                              .wX = side * fall,
                              .wY = turn * sin(from_flat),
                              .wZ = -side * turn * cos(from_flat)};
        check_note("case %d", i);
        check_held(&s, &p, 0);
    }
}

/* A flat coin that turns slowly down.  What a planar body needs without
 * pivoting friction is of a higher order of its angle from flat. */
static void losses_hold_what_pivoting_friction_would_turn(void **unused)
{
    (void)unused;
    struct random r = random_begin(189);
    for (int i = 0; i < 200; ++i) {
        coin_params p;
        const double IX = random_between(&r, 0.1, 0.5);
        const double from_flat = random_between(&r, 1e-6, 1e-5);
        const double turn = random_between(&r, -5, 5);
        const double side = i % 2 ? 1 : -1;
        check_status(coin_params_body(&p, 1, 1, 1, IX, 2 * IX), COIN_OK);
        const coin_state s = {.theta = side * (1.5707963267948966 - from_flat),
                              .wY = turn * sin(from_flat),
                              .wZ = -side * turn * cos(from_flat)};
        check_note("case %d", i);
        check_held(&s, &p, random_between(&r, 0.01, 1));
    }
}

/* Viscous friction stops a small roll, which a fall makes grow, if its torque
 * is twice what would keep the roll as it is. */
static void losses_stop_what_a_fall_makes_grow(void **unused)
{
    (void)unused;
    struct random r = random_begin(190);
    for (int i = 0; i < 200; ++i) {
        coin_params p;
        coin_priv_run run;
        coin_priv_losses l;
        const double IX = random_between(&r, 0.1, 0.5), eps = 1e-8;
        const double from_flat = random_between(&r, 0.01, 0.04);
        const double side = i % 2 ? 1 : -1;
        check_status(coin_params_body(&p, 1, 1, 1, IX, 2 * IX), COIN_OK);
        coin_state s = {.theta = side * (1.5707963267948966 - from_flat),
                        .wX = side * random_between(&r, 400, 600)};
        const double c = sin(from_flat), u = eps * fabs(s.wX);
        run.b = coin_priv_body_of(&p);
        coin_priv_run_unlimited(&run, &s);
        coin_state rolls = s;
        rolls.wY = u * sin(s.theta);
        rolls.wZ = u * c;
        s.wY = rolls.wY / 2;
        s.wZ = rolls.wZ / 2;
        coin_priv_run_unlimited(&run, &s);
        /* (73) leaves out a factor sin theta. */
        const double keeps = torque_needed(&rolls, &p, 0) / cos(from_flat);
        for (int more = 0; more < 2; ++more) {
            const double torque = (more ? 1.0002 : 0.9998) * 2 * keeps;
            const coin_losses viscous = {.viscous = torque * c / u};
            check_status(coin_priv_losses_of(&l, &viscous, &run.b), COIN_OK);
            check_note("case %d", i);
            check(coin_priv_is_held(&l, &run.b, &run.g.y, eps) == more);
        }
    }
}

/* A coin that hardly spins passes near flat and rises, whatever tol is, unless
 * its losses are strong enough to stop its contact in time. */
static void weak_losses_let_a_falling_coin_pass(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_state start = {.theta = 1.535, .wX = 1, .wY = 5e-8};
    coin_state ideal = start;
    check_status(coin_advance(&ideal, &p, 0.2, 1e-12, NULL), COIN_OK);
    check_within(fabs(ideal.phi), 7, 7.1);
    for (double tol = 1e-12; tol < 1e-3; tol *= 1e4)
        for (int law = 0; law < 4; ++law) {
            coin_losses weak = {0}, strong = {0};
            (&weak.dry)[law] = 1e-40;
            (&strong.dry)[law] = 1e-5;
            coin_state s = start;
            check_note("tol %g, law %d", tol, law);
            check_status(coin_settle(&s, &p, &weak, 0.2, tol, NULL), COIN_OK);
            check_near(s.phi, ideal.phi, 2 * tol + 1e-10);
            check_near(s.theta, ideal.theta, 2 * tol + 1e-10);
            s = start;
            check_status(coin_settle(&s, &p, &strong, 0.2, tol, NULL),
                         COIN_RESTS);
            check_near(s.phi, 0, 1e-4);
        }
}

/* However near to flat: its steps are in t. */
static void a_held_slip_is_stepped_by_its_rates_alone(void **unused)
{
    (void)unused;
    static coin_priv_sliding g;
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    g.contact.b = coin_priv_body_of(&p);
    g.contact.psi_held = 1;
    for (double from_flat = 1e-2; from_flat > 1e-8; from_flat /= 10) {
        const coin_state s = {
            .theta = 1.5707963267948966 - from_flat, .wX = 0.3, .wZ = -2};
        g.w.run.b = g.contact.b;
        coin_priv_run_unlimited(&g.w.run, &s);
        check_note("%g rad from flat", from_flat);
        check_near(coin_priv_slip_rate(&g), sqrt(1 + 0.3 * 0.3 + 2 * 2), 1e-12);
    }
}

/* A turn that decays in a thousandth of the fall is left to the steps. */
static void too_strong_pivoting_friction_holds_nothing(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    coin_priv_run run;
    coin_priv_losses l;
    run.b = coin_priv_body_of(&p);
    const coin_state s = {.theta = 1.5707963267948966 - 0.04};
    coin_priv_run_unlimited(&run, &s);
    for (double b = 1; b < 1e6; b *= 10) {
        const coin_losses dry = {.dry = 10, .spin = b};
        check_status(coin_priv_losses_of(&l, &dry, &run.b), COIN_OK);
        check_note("b = %g", b);
        check(coin_priv_is_held(&l, &run.b, &run.g.y, 1e-8) == (b < 5e3));
    }
}

/* Rolling and damping alone never stop a contact; another loss beside them
 * takes a part of the energy. */
static void no_law_of_the_end_holds_for_other_losses(void **unused)
{
    (void)unused;
    coin_params p = disc();
    coin_priv_run run;
    coin_priv_losses l;
    run.b = coin_priv_body_of(&p);
    const double c = 1e-8;
    const coin_state s = {.theta = 1.5707963267948966 - c, .wY = sqrt(4 * c)};
    coin_priv_run_unlimited(&run, &s);
    const double P = coin_losses_power(&s, &p, &(coin_losses){.rolling = 1e-3});
    for (int law = 0; law < 7; ++law) {
        coin_losses with = {.rolling = 1e-3};
        const int is_other = law > 0 && law < 5; /* and not spin */
        (&with.damping)[law] = 1e-3;
        check_status(coin_priv_losses_of(&l, &with, &run.b), COIN_OK);
        const double own = coin_priv_endless_power(&l, &run.g.y);
        check_note("law %d", law);
        check(is_other ? own == 0 : own >= P * c * (1 - 1e-6));
    }
}

/* A body of I_X far above I_Z + M a^2 that turns about the vertical is thrown
 * up: its contact is not held, though its losses could. */
static void what_a_turn_lifts_does_not_fall(void **unused)
{
    (void)unused;
    coin_params p;
    const coin_losses l = {.dry = 10, .soft = 1e-9};
    check_status(coin_params_body(&p, 1, 1, 1, 1e3, 1), COIN_OK);
    const double c = 0.0499, turn = 0.03, t = 1e-5;
    coin_state s = {
        .theta = acos(c), .wY = c * turn, .wZ = -sqrt(1 - c * c) * turn};
    const double E = coin_energy(&s, &p);
    double reached;
    check_status(coin_settle(&s, &p, &l, t, 1e-6, &reached), COIN_OK);
    check(reached == t && coin_energy(&s, &p) <= E * (1 + 1e-9));
}

/* wX was multiplied by a factor below 1 in each frame until it was the smallest
 * number: the rise would take less time than any number holds. */
static void the_slowest_rise_has_an_end(void **unused)
{
    (void)unused;
    coin_params p;
    coinf_params pf;
    check_status(coin_params_disc(&p, 0.00567, 0.01213, 9.80665), COIN_OK);
    check_status(coinf_params_disc(&pf, 0.00567f, 0.01213f, 9.80665f), COIN_OK);
    const coin_losses l = {.dry = 1e-7};
    const coinf_losses lf = {.dry = 1e-7f};
    const coin_state start = {.theta = 1.55, .wX = -0x1p-1074};
    coin_state s = start;
    coin_slide d = {.s = start};
    const coin_friction f = {0.5, 0.4};
    coinf_state sf = {.theta = 1.55f, .wX = -0x1p-149f};
    double reached;
    float reached_f;
    const double c = cos(start.theta); /* by (72) it gains about g/(1.25 a) */
    const double when = sqrt(2 * c * 1.25 * p.radius / p.gravity);
    check_status(coin_settle(&s, &p, &l, 1, 1e-6, &reached), COIN_RESTS);
    check_near(reached, when, 0.01 * when);
    check_status(coinf_settle(&sf, &pf, &lf, 1, 1e-4f, &reached_f), COIN_RESTS);
    check_near((double)reached_f, when, 0.01 * when);
    check_status(coin_slide_advance(&d, &p, &f, &l, 1, 1e-6, &reached),
                 COIN_RESTS);
    check_near(reached, when, 0.01 * when);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(losses_hold_the_torque_that_they_have),
        TEST(losses_hold_what_pivoting_friction_would_turn),
        TEST(losses_stop_what_a_fall_makes_grow),
        TEST(weak_losses_let_a_falling_coin_pass),
        TEST(a_held_slip_is_stepped_by_its_rates_alone),
        TEST(too_strong_pivoting_friction_holds_nothing),
        TEST(no_law_of_the_end_holds_for_other_losses),
        TEST(what_a_turn_lifts_does_not_fall),
        TEST(the_slowest_rise_has_an_end),
    };
    return RUN_TESTS(tests);
}
