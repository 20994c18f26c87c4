/* SPDX-License-Identifier: MIT */
/* Calls of coins that slip: statuses, symmetries. */
#include "support/check.h"
#include "support/coins.h"
#include "support/losses.h"
#include "support/methods.h"
#include "support/slides.h"

#include <errno.h>
#include <fenv.h>
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const coin_table rough = {.mu_static = 0.55, .mu_kinetic = 0.5};

/* Thrown with a side slip: it slips, rolls, slips and rolls. */
static const coin_body thrown = {
    .s = {.theta = 0.3, .wY = 0.5, .wZ = -0.5}, .vx = 1, .vz = 0.4};

/* ---------------------------------------------------------------- rolling */
/* By how much the motion enlarges a small change of its rates; 1 if it does
 * not. */
static double amplification(const coin_state *start, const coin_params *p,
                            double t)
{
    const double nudge = 1e-7;
    coin_state s = *start, other = *start;
    other.wX += nudge / natural_time(p);
    other.wY += nudge / natural_time(p);
    check_status(coin_advance(&s, p, t, 1e-12, NULL), COIN_OK);
    check_status(coin_advance(&other, p, t, 1e-12, NULL), COIN_OK);
    return fmax(1, states_apart(&s, &other, p) / nudge);
}

TEST(what_never_needs_more_friction_moves_as_coin_advance)
{
    const coin_table endless = {.mu_static = INFINITY, .mu_kinetic = 0.3};
    const double times[] = {0.01, 0.3, 5};
    const int count = tries_asked(120);
    struct random r = random_begin(173);
    int rolled = 0;
    for (int i = 0; i < count; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state start = random_state(&r, &p, 1.2);
        const double t = times[i % 3] * natural_time(&p);
        coin_body d, rolls;
        coin_state s = start;
        double reached, by_advance;
        check_status(coin_body_from_state(&d, &start, &p), COIN_OK);
        check_status(coin_advance(&s, &p, t, 1e-9, &by_advance), COIN_OK);
        if (coin_move(&d, &p, &endless, 0, 1e-9, 0, NULL) != COIN_OK ||
            coin_move(&d, &p, &endless, t, 1e-9, COIN_SLIPS | COIN_LIFTS,
                      &reached) != COIN_OK)
            continue; /* where rolling needs a pull it slips */
        /* Each adds less than tol (1 + t). */
        check(
            slides_apart(&d, &(coin_body){.s = s, .vx = d.vx, .vz = d.vz}, &p) <
            2e-9 * (1 + times[i % 3]) * amplification(&start, &p, t));
        check(reached == by_advance);
        check_status(coin_body_from_state(&rolls, &d.s, &p), COIN_OK);
        check(slides_apart(&d, &rolls, &p) < 1e-12);
        ++rolled;
    }
    check_share(rolled, count, 0.36);
}

TEST(a_coin_that_rolls_is_described_as_by_the_other_functions)
{
    const coin_table endless = {.mu_static = INFINITY, .mu_kinetic = 0.3};
    const coin_losses l = {.dry = 0.01,
                           .viscous = 0.02,
                           .layer = 0.01,
                           .gap = 0.01,
                           .rolling = 0.02,
                           .spin = 0.01};
    struct random r = random_begin(174);
    for (int i = 0; i < 300; ++i) {
        const coin_params p = i % 2 ? disc() : ring(random_between(&r, 0, 1));
        const coin_state s = random_state(&r, &p, 1.3);
        coin_body d;
        coin_force by, want;
        double u[2];
        check_status(coin_body_from_state(&d, &s, &p), COIN_OK);
        check_status(slide_velocity(&d, &p, u), COIN_OK);
        check_near(hypot(u[0], u[1]), 0, 32 * U);
        check_near(slide_energy(&d, &p), coin_energy(&s, &p), 128 * U);
        const double terms = 16 / cos(s.theta);
        for (int lossy = 0; lossy < 2; ++lossy) {
            check_status(
                slide_reaction(&d, &p, &endless, lossy ? &l : NULL, &by),
                COIN_OK);
            check_status(lossy ? coin_losses_reaction(&s, &p, &l, &want)
                               : coin_reaction(&s, &p, &want),
                         COIN_OK);
            if (want.normal < 0) /* it lifts off, or slips */
                continue;
            for (int k = 0; k < 3; ++k)
                check_near(by.R[k], want.R[k], 32 * U * terms);
            check_near(by.friction, want.friction, 64 * U * terms);
            check(by.normal == by.R[1]);
        }
    }
}

/* By Newton and Euler in the table's frame: the force at the contact makes the
 * height of the material point of contact accelerate as a rim that rolls on. */
TEST(the_force_of_a_slip_is_that_of_newton_and_euler)
{
    struct random r = random_begin(175);
    for (int i = 0; i < 200; ++i) {
        const coin_params p = ring(random_between(&r, 0, 1));
        const double mu = random_between(&r, 0, 0.9);
        const coin_table f = {.mu_static = 1, .mu_kinetic = mu};
        coin_body d = random_launch(&r, &p);
        d.vx += 1;
        coin_force force;
        double u[2], R[9];
        check_status(slide_reaction(&d, &p, &f, NULL, &force), COIN_OK);
        check_status(slide_velocity(&d, &p, u), COIN_OK);
        if (force.normal == 0)
            continue; /* it lifts off */
        const double size = hypot(u[0], u[1]);
        /* Against the slip, and mu N large. */
        check_near(force.R[0], -mu * force.normal * u[0] / size, 1e-12);
        check_near(force.R[2], -mu * force.normal * u[1] / size, 1e-12);
        /* y = cos(theta): y'' = -wX' sin - wX^2 cos = N - 1, where wX' is by
         * Euler's equation of a body whose axis is e_Z. */
        check_status(coin_axes(&d.s, R), COIN_OK);
        const double sth = sin(d.s.theta), cth = cos(d.s.theta);
        double torque = 0; /* along e_X, of the force at -e_Y */
        const double at[3] = {-R[3], -R[4], -R[5]};
        const double m[3] = {at[1] * force.R[2] - at[2] * force.R[1],
                             at[2] * force.R[0] - at[0] * force.R[2],
                             at[0] * force.R[1] - at[1] * force.R[0]};
        for (int k = 0; k < 3; ++k)
            torque += m[k] * R[k];
        const double frame_Z = d.s.wY * tan(d.s.theta);
        const double dwX = (torque + p.inertia_X * d.s.wY * -frame_Z -
                            p.inertia_Z * d.s.wZ * d.s.wY) /
                           p.inertia_X;
        check_near(-dwX * sth - d.s.wX * d.s.wX * cth, force.normal - 1,
                   1e-12 / cth);
    }
}

/* ---------------------------------------------------------------- statuses */
TEST(t_0_changes_nothing_and_says_whether_it_slips)
{
    const coin_params p = disc();
    const coin_state wild = {.theta = 0.7, .wX = 1, .wY = 1, .wZ = 0.5};
    const coin_state still = {.theta = 0.1, .wZ = 1};
    coin_body d = thrown;
    double reached = 7;
    check_status(slide(&d, &p, &rough, NULL, 0, 1e-9, &reached), COIN_SLIPS);
    check(reached == 0);
    check_same(&d, &thrown, sizeof d);
    coin_body_from_state(&d, &still, &p);
    check_status(slide(&d, &p, &rough, NULL, 0, 1e-9, &reached), COIN_OK);
    const coin_table ice = {.mu_static = 0.01, .mu_kinetic = 0};
    coin_body_from_state(&d, &wild, &p);
    check_status(slide(&d, &p, &ice, NULL, 0, 1e-9, &reached), COIN_SLIPS);
}

TEST(a_coin_that_would_lift_off_is_kept_where_it_does)
{
    const coin_params p = disc();
    coin_body d, again;
    const coin_state up = {.theta = 0.2, .wX = 3};
    double reached = 7;
    coin_body_from_state(&d, &up, &p);
    again = d;
    check_status(slide(&d, &p, &rough, NULL, 1, 1e-9, &reached), COIN_LIFTS);
    check(reached == 0);
    check_same(&d, &again, sizeof d);
    const coin_body none[] = {
        {.s = {.theta = 0.2, .wX = 3}, .vx = 1, .vz = 0}, /* slips */
        {.s = {.theta = 0, .wX = 1.0625},
         .vx = 0,
         .vz = 1.0625}, /* rolls; F = 0 */
    };
    for (int i = 0; i < 2; ++i) {
        d = none[i];
        check_status(slide(&d, &p, &rough, NULL, 1, 1e-9, &reached),
                     COIN_LIFTS);
        check(reached == 0);
        check_same(&d, &none[i], sizeof d);
    }
    /* One that lifts off on its way. */
    struct random r = random_begin(176);
    int lifted = 0;
    for (int i = 0; i < 200; ++i) {
        coin_force force;
        d = random_launch(&r, &p);
        if (slide(&d, &p, &rough, NULL, 9, 1e-10, &reached) != COIN_LIFTS ||
            reached == 0)
            continue;
        ++lifted;
        check(reached < 9);
        check_status(slide_reaction(&d, &p, &rough, NULL, &force), COIN_OK);
        check_within(force.normal, -1e-9, 1e-6);
    }
    check(lifted > 20);
}

/* Its friction is 0, and so is the most that there is. */
TEST(a_coin_that_needs_no_friction_rolls_on_ice)
{
    const coin_params p = disc();
    const coin_table ice = {.mu_static = 0, .mu_kinetic = 0};
    const coin_state needs_none[] = {{.wZ = 1}, {.wY = 2}};
    for (int i = 0; i < 2; ++i)
        for (double t = 0; t < 20; t += 5) {
            coin_body d;
            coin_body_from_state(&d, &needs_none[i], &p);
            check_status(slide(&d, &p, &ice, NULL, t, 1e-9, NULL), COIN_OK);
            check(d.s.theta == 0 && d.s.wY == needs_none[i].wY);
        }
}

/* Falling without turning: flat in finite time, whatever the friction, to
 * either side. */
TEST(a_coin_that_falls_over_rests_also_without_losses)
{
    const coin_params p = disc();
    const double mus[] = {0, 0.3, INFINITY};
    double when[6];
    for (int i = 0; i < 6; ++i) {
        const double mu = mus[i % 3], side = i < 3 ? 1 : -1;
        const coin_table f = {.mu_static = mu, .mu_kinetic = mu < 1 ? mu : 0.3};
        const coin_state s = {.theta = side * 1.2};
        coin_body d;
        coin_body_from_state(&d, &s, &p);
        check_status(slide(&d, &p, &f, NULL, 9, 1e-10, &when[i]), COIN_RESTS);
        check(side * d.s.theta > 1.57079632679489);
        check(d.s.wX == 0 && d.s.wY == 0 && d.vz == 0);
        const coin_body flat = d;
        double reached = 7;
        check_status(slide(&d, &p, &f, NULL, 9, 1e-10, &reached), COIN_RESTS);
        check(reached == 0);
        check_same(&d, &flat, sizeof d);
    }
    coin_state s = {.theta = 1.2};
    double by_advance;
    check_status(coin_advance(&s, &p, 9, 1e-10, &by_advance), COIN_EFLAT);
    /* It lies flat 1e-6 rad before, at a speed of 0.75. */
    check_near(when[2], by_advance, 2e-6);
    check(when[0] < when[2]);
    for (int i = 0; i < 3; ++i)
        check(when[i + 3] == when[i]);
}

/* In a time so short that the slip cannot be told from rolling. */
TEST(a_slip_that_has_just_begun_takes_the_time_asked)
{
    const coin_params p = disc();
    const coin_table ice = {.mu_static = 0.01, .mu_kinetic = 0.005};
    const coin_state wild = {.theta = 0.7, .wX = 0.5, .wY = 1, .wZ = 0.5};
    coin_body d;
    double reached;
    coin_body_from_state(&d, &wild, &p);
    check_status(slide(&d, &p, &ice, NULL, 1e-12, 1e-9, &reached), COIN_SLIPS);
    check(reached == 1e-12);
    check_near(d.s.theta, wild.theta + 1e-12 * wild.wX, 2 * U);
}

/* Nothing turns and nothing pushes. */
TEST(an_upright_coin_without_friction_glides)
{
    const coin_params p = disc();
    const coin_table none = {.mu_static = 0, .mu_kinetic = 0};
    coin_body d = {.s = {0}, .vx = 0.5, .vz = 0.25};
    check_status(slide(&d, &p, &none, NULL, 8, 1e-9, NULL), COIN_SLIPS);
    check(d.vx == 0.5 && d.vz == 0.25 && d.s.theta == 0 && d.s.wZ == 0);
    check_near(d.s.x, 4, 16 * U);
    check_near(d.s.z, 2, 16 * U);
}

/* Rounding of its speed is no error of the other variables. */
TEST(a_slip_of_any_speed_takes_few_steps)
{
    const coin_params p = disc();
    coin_body d = thrown;
    for (double v = 1; v < 1e6; v *= 9) {
        d = thrown;
        d.vx = v;
        check_status(slide(&d, &p, &rough, NULL, 0.5, 1e-10, NULL), COIN_SLIPS);
        check(fabs(d.vx - v) < 0.5 * 0.5 * 2 + 4 * U * v); /* mu N t */
    }
}

TEST(many_calls_go_where_one_goes)
{
    const coin_params p = disc();
    coin_body one = thrown, many = thrown;
    check(slide(&one, &p, &rough, NULL, 3, 1e-11, NULL) >= 0);
    for (int i = 0; i < 300; ++i)
        check(slide(&many, &p, &rough, NULL, 0.01, 1e-11, NULL) >= 0);
    check(slides_apart(&one, &many, &p) < 1e-8);
}

/* ---------------------------------------------------------------- symmetry */
/* Friction turns the contact of this coin, which begins without a roll: a loss
 * that could not hold it changes nothing. */
TEST(a_weak_loss_does_not_hold_a_contact_that_friction_turns)
{
    const coin_params p = disc();
    coin_body ends[2];
    for (int weak = 0; weak < 2; ++weak) {
        const coin_table table = {.mu_static = 0.3,
                                  .mu_kinetic = 0.3,
                                  .losses.viscous = weak ? 1e-12 : 0};
        const coin_state s = {.theta = 1.525};
        check_status(coin_body_from_state(&ends[weak], &s, &p), COIN_OK);
        ends[weak].vx = 1;
        check(coin_move(&ends[weak], &p, &table, 0.1, 1e-12, 0, NULL) >= 0);
    }
    check_near(ends[1].s.phi, ends[0].s.phi, 1e-9);
    check_near(ends[1].s.psi, ends[0].s.psi, 1e-9);
}

TEST(mirror_heading_and_units_change_nothing)
{
    struct random r = random_begin(177);
    for (int i = 0; i < 40; ++i) {
        const coin_params p = disc();
        coin_params big;
        check_status(coin_params_disc(&big, 8, 4, 0.25), COIN_OK);
        const coin_body d = random_launch(&r, &p);
        coin_body a = d, b = d, c = d, e = d;
        /* x-y plane; y-z plane; a turn of the table; L = 4, T = 4, M = 8. */
        const coin_state s = d.s;
        b.s = (coin_state){-s.theta, -s.phi, s.psi, s.x,
                           -s.z,     -s.wX,  -s.wY, s.wZ};
        b.vz = -d.vz;
        c.s = (coin_state){s.theta, -s.phi, -s.psi, -s.x,
                           s.z,     s.wX,   -s.wY,  -s.wZ};
        c.vx = -d.vx;
        e.s = state_in(&s, 4, 4);
        const int32_t status = slide(&a, &p, &rough, NULL, 2, 1e-10, NULL);
        check_status(slide(&b, &p, &rough, NULL, 2, 1e-10, NULL), status);
        check_status(slide(&c, &p, &rough, NULL, 2, 1e-10, NULL), status);
        check_status(slide(&e, &big, &rough, NULL, 8, 1e-10, NULL), status);
        check_near(b.s.theta, -a.s.theta, 1e-8);
        check_near(b.s.z, -a.s.z, 1e-8);
        check_near(b.vz, -a.vz, 1e-8);
        check_near(c.s.wZ, -a.s.wZ, 1e-8);
        check_near(c.s.x, -a.s.x, 1e-8);
        check(e.s.theta == a.s.theta && e.s.x == 4 * a.s.x && e.vx == a.vx);
    }
}

/* A slip that grows by powers of ten in its last step, whose time no cubic
 * follows: Newton's method would leave the step. */
TEST(a_slip_that_grows_fast_ends_at_the_time_asked)
{
    const coin_params p = disc();
    const coin_table f = {.mu_static = 0.34, .mu_kinetic = 0.25};
    for (double u = 1e-9; u < 1e-3; u *= 1.1) {
        coin_body d = {.s = {.theta = 0.83, .wX = 0.22, .wY = -0.09, .wZ = 0.2},
                       .vx = u - 0.2,
                       .vz = 0.15 + u};
        const double t = 0.04, E = slide_energy(&d, &p);
        double reached;
        check_note("slip %g", u);
        check(slide(&d, &p, &f, NULL, t, 1e-2, &reached) >= 0);
        check(reached == t);
        check(slide_energy(&d, &p) < E * (1 + 1e-6));
    }
}

/* A slip whose acceleration or friction would be negative, by rounding, takes
 * no root.  An upright coin that falls at wX = 1 has no weight on its contact.
 */
TEST(no_launch_sets_errno)
{
    struct random r = random_begin(231);
    errno = 0;
    feclearexcept(FE_INVALID);
    for (int i = -40; i <= 40; ++i) {
        const coin_table held = {.mu_static = INFINITY, .mu_kinetic = 0.6};
        const coin_params p = disc();
        const coin_state s = {.wX = 1 + i * DBL_EPSILON};
        coin_body d;
        check_status(coin_body_from_state(&d, &s, &p), COIN_OK);
        check(coin_move(&d, &p, &held, 0.1, 1e-2, 0, NULL) >= 0);
        check_note("wX = 1 + %d u", i);
        check(errno == 0 && !fetestexcept(FE_INVALID));
    }
    for (int i = 0; i < 300; ++i) {
        const coin_params p = ring(random_between(&r, 0, 1));
        const double mu = random_between(&r, 0.2, 0.6);
        const coin_table f = {.mu_static = mu, .mu_kinetic = mu};
        coin_body d = random_launch(&r, &p);
        slide(&d, &p, &f, NULL, 2, 1e-4, NULL);
        check_note("launch %d", i);
        check(errno == 0 && !fetestexcept(FE_INVALID));
    }
}

/* Next to flat a good step may have further stages that run away, and its
 * polynomial may dip below the table: neither shows an event that is none, nor
 * sets errno. */
TEST(a_launch_next_to_flat_slides_on)
{
    const struct {
        double IZ, theta, phi, wX, wZ, vx, vz, mu_static, mu_kinetic;
        coin_losses l;
        double t, tol;
    } launches[] = {
        {0.10112607232063167,
         1.57079494015018,
         2.5800715773962803,
         0,
         -0.61059180579420391,
         0.3795551289741691,
         1.3070818765514924,
         0.0045664337462995577,
         0.0031812194933576879,
         {.rolling = 9.5227437337125042e-06, .layer = 0.00011793100162508609},
         1.3244427216727441,
         0.0009467716133710046},
        {0.003818950833348472,
         -1.5707952236456562,
         1.5260562715973682,
         -0.55537316087556265,
         -0.66251050430825398,
         0.029630256960182705,
         -0.66184757776366143,
         0,
         0,
         {.viscous = 0.0014597434718429997, .layer = 0.0010303154795372278},
         0.94144070726810458,
         0.00015049123687841973},
    };
    for (int i = 0; i < 2; ++i) {
        const coin_params p = {1, 1, 1, 0.25, launches[i].IZ, 0, {0, 0}};
        const coin_table f = {.mu_static = launches[i].mu_static,
                              .mu_kinetic = launches[i].mu_kinetic,
                              .losses = launches[i].l};
        const coin_state s = {.theta = launches[i].theta,
                              .phi = launches[i].phi,
                              .wX = launches[i].wX,
                              .wZ = launches[i].wZ};
        double reached;
        coin_body d;
        check_note("launch %d", i);
        check_status(coin_body_from_state(&d, &s, &p), COIN_OK);
        d.vx = launches[i].vx;
        d.vz = launches[i].vz;
        errno = 0;
        feclearexcept(FE_INVALID);
        check_status(
            coin_move(&d, &p, &f, launches[i].t, launches[i].tol, 0, &reached),
            COIN_SLIPS);
        check(reached == launches[i].t);
        check(errno == 0 && !fetestexcept(FE_INVALID));
    }
}
