/* SPDX-License-Identifier: MIT */
/* Where a slip begins, or does not: the cases that an audit found wrong. */
#include "support/check.h"
#include "support/coins.h"
#include "support/slides.h"

#include <fenv.h>
#include <math.h>

#define HALF_PI 1.5707963267948966

/* A coin that rolls, but for a slip of a speed against the force that rolling
 * needs.  Such a slip is under way, so its motion owes nothing to the search
 * for an onset. */
static coin_body seeded(const coin_state *s, const coin_params *p,
                        const coin_losses *l, double speed)
{
    const coin_table endless = {.mu_static = INFINITY, .mu_kinetic = 0};
    coin_body d;
    coin_force f;
    check_status(coin_body_from_state(&d, s, p), COIN_OK);
    check_status(slide_reaction(&d, p, &endless, l, &f), COIN_OK);
    d.vx -= speed * f.R[0] / f.friction;
    d.vz -= speed * f.R[2] / f.friction;
    return d;
}

/* SEED is 10 times the speed with which a slip begins.  What it changes of a
 * motion is a few times as large. */
#define SEED 1e-9
#define SEED_EFFECT (4 * SEED)

/* Rolling needs 1e-6 more friction than there is, and soon less again.  By then
 * the coin slips, and the friction of a slip is a tenth less. */
TEST(a_slip_goes_on_where_rolling_would_need_less_again)
{
    const coin_params p = disc();
    const coin_table f = {.mu_static = 0x1.3b598115c0dcap-1,
                          .mu_kinetic = 0x1.192c6e545f453p-1};
    const coin_state s = {.theta = 0x1.dad9739391d4p-1,
                          .wX = -0x1.5eeedb6709p-5,
                          .wY = -0x1.29af536b79dbp+0,
                          .wZ = -0x1.8140a843483cp-1};
    const double t = 0.3, E = coin_energy(&s, &p);
    coin_state soon = s;
    coin_force now, then;
    check_status(coin_reaction(&s, &p, &now), COIN_OK);
    check_status(coin_advance(&soon, &p, 1e-3, 1e-13, NULL), COIN_OK);
    check_status(coin_reaction(&soon, &p, &then), COIN_OK);
    check(now.ratio > f.mu_static && then.ratio < f.mu_static);
    coin_body want = seeded(&s, &p, NULL, SEED);
    check_status(slide(&want, &p, &f, NULL, t, 1e-13, NULL), COIN_SLIPS);
    const double lost = E - slide_energy(&want, &p);
    int tried = 0;
    for (double tol = 1e-3; tol > 5e-14; tol /= 10, ++tried) {
        coin_body d;
        check_note("tol %g", tol);
        check_status(coin_body_from_state(&d, &s, &p), COIN_OK);
        check_status(slide(&d, &p, &f, NULL, t, tol, NULL), COIN_SLIPS);
        check_near(d.s.theta, want.s.theta, tol + SEED_EFFECT);
        check_near(slip_speed(&d, &p), slip_speed(&want, &p),
                   tol + SEED_EFFECT);
        check_near(E - slide_energy(&d, &p), lost, tol + SEED_EFFECT);
    }
    check(tried == 11);
}

/* The time in which a disc that glides falls to a lean, from wX at a lean of 0.
 * The spin and the angular momentum about the vertical are kept, so
 * wY = wZ k tan(theta) with k = I_Z/I_X = 2, and the energy gives wX. */
static double time_to_fall(double theta, double wX, double wZ)
{
    enum { PARTS = 400 };
    double sum = 0;
    for (int i = 0; i <= PARTS; ++i) { /* Simpson */
        const double at = theta * i / PARTS, sth = sin(at);
        const double wY = 2 * wZ * tan(at);
        const double twice =
            0.25 * wX * wX + 2 * (1 - cos(at)) - 0.25 * wY * wY;
        const double weight = i == 0 || i == PARTS ? 1 : i % 2 ? 4 : 2;
        sum += weight * sqrt((0.25 + sth * sth) / twice);
    }
    return sum * theta / (3 * PARTS);
}

/* Nothing pushes the centre along the table.  The direction of the friction,
 * which is 0, is undetermined. */
TEST(a_coin_on_a_frictionless_table_falls_and_glides)
{
    const coin_params p = disc();
    const double mus[] = {0, 0x1p-1074}, tol = 1e-9, t = 1, wX = 0.1;
    for (int i = 0; i < 4; ++i) {
        const double mu = mus[i / 2], wZ = i % 2;
        const coin_table f = {.mu_static = mu, .mu_kinetic = mu};
        const coin_state s = {.wX = wX, .wZ = wZ};
        coin_body from, d;
        double reached;
        check_note("mu %g, wZ %g", mu, wZ);
        check_status(coin_body_from_state(&from, &s, &p), COIN_OK);
        d = from;
        check_status(slide(&d, &p, &f, NULL, t, tol, &reached), COIN_SLIPS);
        check(reached == t);
        check_near(d.vx, from.vx, tol);
        check_near(d.vz, from.vz, tol);
        check_near(d.s.wZ, wZ, tol);
        check_near(slide_energy(&d, &p), slide_energy(&from, &p), tol);
        check_near(time_to_fall(d.s.theta, wX, wZ), t, tol / wX);
    }
}

/* Rolling needs 1e-13 more friction than there is, and that is rounding at the
 * start. */
TEST(a_slip_begins_where_only_rounding_keeps_the_coin)
{
    const coin_params p = disc();
    const double mu = 0x1.05adc7b1b6d58p-2, tol = 1e-9;
    const coin_table f = {.mu_static = mu, .mu_kinetic = 0.9 * mu};
    const coin_state s = {.theta = -0x1.30767c8f5d6cp-1,
                          .wX = -0x1.0a59e89cedp-5,
                          .wY = 0x1.6a98a7c4119cp+0,
                          .wZ = -0x1.6e34e5e25868p+0};
    const double times[] = {1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6,
                            1e-5,  1e-4,  1e-3,  1e-2, 0.1,  0.5};
    for (int i = 0; i < 13; ++i) {
        const double t = times[i];
        coin_body d, want = seeded(&s, &p, NULL, SEED);
        double reached;
        check_note("t %g", t);
        check_status(coin_body_from_state(&d, &s, &p), COIN_OK);
        check_status(slide(&d, &p, &f, NULL, t, tol, &reached), COIN_SLIPS);
        check(reached == t);
        check_status(slide(&want, &p, &f, NULL, t, 1e-13, NULL), COIN_SLIPS);
        check(slides_apart(&d, &want, &p) <= tol + SEED_EFFECT);
    }
}

/* An unstable steady circle, and its mirror image.  On it the sign of wX is
 * that of rounding for long.  Then the coin leaves the circle, and slips where
 * stop says. */
TEST(rounding_about_a_steady_circle_is_no_swing)
{
    const coin_params p = disc();
    const double mu = 0x1.328f8b69cb968p-1, t = 0x1.bc69955a04f7ep+5;
    const double tol = 0x1.de3dd30816bc8p-31;
    const coin_table f = {.mu_static = mu, .mu_kinetic = 0.8 * mu};
    for (int side = -1; side < 2; side += 2) {
        const coin_state s = {.theta = side * 0x1.0f073c0f28266p-4,
                              .wY = side * -0x1.63071f9b211e8p-3,
                              .wZ = -0x1.026c5afb60a4dp-2};
        const double E = coin_energy(&s, &p);
        coin_body d, rest;
        double when;
        check_note("side %d", side);
        check_status(coin_body_from_state(&rest, &s, &p), COIN_OK);
        check_status(coin_move(&rest, &p, &f, t, tol, COIN_SLIPS, &when),
                     COIN_SLIPS);
        check_status(slide(&rest, &p, &f, NULL, t - when, tol, NULL), COIN_OK);
        check(E - slide_energy(&rest, &p) > 0.01);
        check_status(coin_body_from_state(&d, &s, &p), COIN_OK);
        check_status(slide(&d, &p, &f, NULL, t, tol, NULL), COIN_OK);
        check_near(slide_energy(&d, &p), slide_energy(&rest, &p), tol * t);
    }
}

/* The slip velocity is the difference of two speeds of |wZ|, each rounded a few
 * times.  20 times what that may be is a slip. */
TEST(a_fast_straight_roll_does_not_slip)
{
    const coin_params p = disc();
    const coin_table f = {.mu_static = 0.55, .mu_kinetic = 0.5};
    const double speeds[] = {1e5, -1e5, 9e5, -9e5};
    for (int i = 0; i < 4 * 200; ++i) {
        const double phi = i / 4 * 0.0317 - 3;
        const coin_state s = {.phi = phi, .wZ = speeds[i % 4]};
        coin_body d;
        check_note("wZ %g, phi %g", s.wZ, phi);
        check_status(coin_body_from_state(&d, &s, &p), COIN_OK);
        check_status(slide(&d, &p, &f, NULL, 0, 1e-9, NULL), COIN_OK);
        d.vx += 160 * U * s.wZ * cos(phi);
        d.vz -= 160 * U * s.wZ * sin(phi);
        check_status(slide(&d, &p, &f, NULL, 0, 1e-9, NULL), COIN_SLIPS);
    }
}

/* Found by the search: the clearance at an end of the step is rounding.  The
 * halving of the step did not end. */
TEST(a_step_of_almost_no_length_ends)
{
    coin_params p;
    check_status(coin_params_body(&p, 0x1.d1e0b919e5fccp-11,
                                  0x1.30a43209cfa33p+16, 0x1.3b0dabb8cca7p+2,
                                  0x1.19d1c8a27eaddp+22, 0x1.34eebe6d4d516p+21),
                 COIN_OK);
    const coin_table f = {.mu_static = 0x1.4d5518f2196c6p+0,
                          .mu_kinetic = 0x1.2f078b0aa2bf9p+0};
    const coin_state s = {
        .theta = -0x1.3652251208c16p-1,
        .wX = -0x1.d1e2434515222p-11,
        .wY = 0x1.561f4b7a54455p-11,
        .wZ = 0x1.fcc1b605c19dbp-7,
    };
    coin_body d;
    double reached;
    check_status(coin_body_from_state(&d, &s, &p), COIN_OK);
    check_status(slide(&d, &p, &f, NULL, 202.65581375722547,
                       0x1.817f444125c59p-39, &reached),
                 COIN_SLIPS);
    check(reached == 202.65581375722547);
}

/* With equal coefficients a slip begins with no acceleration.  Its direction is
 * stiff while it is slow. */
TEST(a_slip_that_hardly_accelerates_ends_no_call_early)
{
    const coin_params p = disc();
    const coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.3};
    const coin_state starts[] = {
        {.theta = 0.94546180622952847,
         .wX = -0.010740010559801189,
         .wY = 0.89849275349168234,
         .wZ = -0.081208633799117594},
        {.theta = 0.46933360677338054,
         .wX = 0.26114857442453382,
         .wY = 0.47027177485936655,
         .wZ = 0.74213910794703453},
        {.theta = -0.062549760280231792,
         .wX = -0.72139647750815938,
         .wY = 0.43894928746726303,
         .wZ = 0.81082159221974737},
    };
    for (size_t i = 0; i < sizeof starts / sizeof *starts; ++i) {
        coin_body fine;
        check_status(coin_body_from_state(&fine, &starts[i], &p), COIN_OK);
        coin_body start = fine;
        check_within(slide(&fine, &p, &f, NULL, 0.1, 1e-11, NULL), 0, 1);
        for (double tol = 1e-2; tol > 1e-9; tol *= 1e-2) {
            coin_body b = start;
            check_note("start %zu, tol %g", i, tol);
            for (int k = 0; k < 100; ++k)
                check(coin_move(&b, &p, &f, 1e-3, tol, 0, NULL) >= 0);
            check_near(slides_apart(&b, &fine, &p), 0, tol);
        }
    }
}

/* It is not slow: its direction is not stiff. */
TEST(a_slip_almost_without_friction_ends_no_call_early)
{
    const coin_params p = disc();
    const coin_table f = {.mu_static = 4e-10, .mu_kinetic = 4e-10};
    const coin_state s = {.theta = -1.5237, .wZ = -0.7};
    coin_body b;
    check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
    check_status(coin_move(&b, &p, &f, 1e-3, 2e-8, 0, NULL), COIN_SLIPS);
}

/* The slip is as slow as one that hardly accelerates, and turns into the
 * direction of its onset within 1e-4 of a natural unit. */
TEST(a_slow_slip_aside_turns_before_it_grows)
{
    const coin_params p = disc();
    const coin_table rough = {.mu_static = INFINITY, .mu_kinetic = 0.1};
    const double tol = 1e-6;
    for (int i = 0; i < 64; ++i) {
        const coin_state s = {.theta = 0.6, .wY = 0.5, .wZ = 0.6};
        const double way = i * HALF_PI / 16;
        coin_body b, fine;
        coin_force need;
        check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
        check_status(coin_body_reaction(&b, &p, &rough, &need), COIN_OK);
        const coin_table f = {.mu_static = need.ratio / 1.08,
                              .mu_kinetic = need.ratio / 1.08};
        b.vx += 1e-5 * cos(way);
        b.vz += 1e-5 * sin(way);
        fine = b;
        check_note("way %g", way);
        check_status(coin_move(&b, &p, &f, 0.01, tol, 0, NULL), COIN_SLIPS);
        check_status(coin_move(&fine, &p, &f, 0.01, 1e-11, 0, NULL),
                     COIN_SLIPS);
        check_near(slides_apart(&b, &fine, &p), 0, tol);
    }
}

TEST(a_coin_that_begins_to_slip_is_nearly_flat_at_the_same_moment_at_any_tol)
{
    const coin_params p = disc();
    for (int i = 0; i < 40; ++i) {
        const double c = 0.0100005 + i * 4.75e-6;
        const double mu = 0.02 + 0.02 * i;
        const coin_table f = {.mu_static = mu, .mu_kinetic = mu};
        const coin_state s = {
            .theta = HALF_PI - c, .wX = 0.3, .wY = 3 * c, .wZ = 0.1};
        double when = 0;
        check_note("start %d", i);
        for (double tol = 1e-12; tol < 1e-3; tol *= 1e3) {
            coin_body b;
            double reached;
            check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
            const int32_t status =
                coin_move(&b, &p, &f, 0.1, tol, COIN_NEARLY_FLAT, &reached);
            check(status & COIN_NEARLY_FLAT);
            when = tol < 2e-12 ? reached : when;
            check_near(reached, when, tol);
        }
    }
}

/* It falls, and is nearly flat from the start.  If the steps of its slip still
 * went half of the way to that moment at most, they would never get past it:
 * COIN_MORE. */
TEST(a_slow_slip_just_below_nearly_flat_goes_on)
{
    const coin_params p = {
        1, 1, 1, 0.24587948306893975, 0.13056421100009277, 0, {0, 0}};
    const coin_table f = {.mu_static = 0.31277658222777621,
                          .mu_kinetic = 0.31277658222777621};
    const coin_state s = {.theta = 1.5607961754027089,
                          .wX = 0.005475218954620286,
                          .wY = 0.0033468586649615234,
                          .wZ = 0.16130382227027498};
    const double t = 7.1573905837126585e-06;
    coin_body b;
    double reached;
    check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
    check(cos(s.theta) < 0.01 && s.wX > 0);
    check_status(coin_move(&b, &p, &f, t, 3.77e-5,
                           COIN_NEARLY_FLAT | COIN_TOUCHES, &reached),
                 COIN_SLIPS);
    check(reached == t);
}

/* On ice the centre keeps its velocity along the table.  A coin that falls
 * through upright needs a force that turns round there, within the first step
 * of its slip. */
TEST(a_slip_that_begins_on_ice_turns_round_where_its_force_does)
{
    const coin_params p = disc();
    const coin_table ice = {.mu_static = 0, .mu_kinetic = 0};
    for (double theta = 1e-9; theta < 1e-2; theta *= 2)
        for (double tol = 1e-4; tol > 5e-12; tol /= 10) {
            const coin_state s = {.theta = theta, .wX = -0.24, .wY = theta};
            coin_body b, start;
            check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
            start = b;
            check_note("theta %g, tol %g", theta, tol);
            check_status(coin_move(&b, &p, &ice, 0.05, tol, 0, NULL),
                         COIN_SLIPS);
            check_near(b.vx, start.vx, tol);
            check_near(b.vz, start.vz, tol);
        }
}

/* A roll that is straight but for a wobble slips on ice from a speed next to 0
 * on, which grows exponentially. */
TEST(a_nearly_straight_roll_on_ice_goes_on)
{
    struct random r = random_begin(77);
    const coin_params p = disc();
    const coin_table ice = {.mu_static = 0, .mu_kinetic = 0};
    for (int i = 0; i < 600; ++i) {
        const double wobble = pow(10, random_between(&r, -16, -6));
        coin_state s = {.wZ = random_between(&r, 0.2, 2)};
        *(i % 3 == 0 ? &s.theta : i % 3 == 1 ? &s.wX : &s.wY) = wobble;
        coin_body b;
        check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
        check_note("wobble %d of %g, wZ %g", i % 3, wobble, s.wZ);
        check(coin_move(&b, &p, &ice, 1, i % 2 ? 1e-9 : 1e-6, 0, NULL) >= 0);
    }
}

/* The direction of a slip that ends settles ever more slowly as its speed
 * falls: an upright body, and a ring that leans. */
TEST(a_slip_ends_whose_direction_does_not_settle)
{
    coin_params p = ring(0.9);
    const coin_table held = {.mu_static = INFINITY, .mu_kinetic = 0.2};
    const coin_table equal = {.mu_static = 0.1, .mu_kinetic = 0.1};
    coin_body b = {.s = {.theta = 0.1}, .vx = -3.6e-6, .vz = -1.2e-14};
    feclearexcept(FE_ALL_EXCEPT);
    check_status(slide(&b, &p, &held, NULL, 0.02, 1e-12, NULL), COIN_OK);
    check_status(coin_params_body(&p, 1, 1, 1, 1, 1), COIN_OK);
    const coin_body upright = {
        .s = {.wY = -0.2276, .wZ = -2e-14}, .vx = 0.0658, .vz = -3.5e-10};
    b = upright;
    check(slide(&b, &p, &equal, NULL, 10, 1e-6, NULL) >= 0);
    check(!fetestexcept(FE_DIVBYZERO | FE_INVALID));
}

/* The weight is taken off an upright coin that tips so fast.  The slip that
 * begins grows a thousandfold in a step that tol = 0.008 allows. */
TEST(a_slip_that_grows_from_nothing_gains_no_energy)
{
    coin_params p;
    const coin_table f = {.mu_static = INFINITY, .mu_kinetic = 0.19};
    check_status(coin_params_body(&p, 1, 1, 1, 0.25, 0.25), COIN_OK);
    for (int i = 0; i < 20; ++i) {
        const coin_state s = {.wX = 1, .wY = 1.2207e-4 * (1 + 0.1 * i)};
        const double tol = 0x1p-7;
        coin_body b;
        check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
        const double before = coin_body_energy(&b, &p);
        check_note("wY %g", s.wY);
        check_status(coin_move(&b, &p, &f, 1, tol, 0, NULL), COIN_SLIPS);
        check_within(coin_body_energy(&b, &p) - before, -1, 2 * tol);
    }
}

/* A coin that tips on ice, from a slip of 1e-6: its time grows with the slip,
 * and went back within a step that tol = 0.008 allowed. */
TEST(a_slip_on_ice_does_not_go_back_in_time)
{
    const coin_table ice = {0};
    const int32_t stop =
        COIN_SLIPS | COIN_NEARLY_FLAT | COIN_ROLLS | COIN_TOUCHES;
    struct random r = random_begin(105);
    coin_params p;
    check_status(coin_params_cylinder(&p, 1, 1, 1.2207e-4, 1), COIN_OK);
    for (int i = 0; i < 100; ++i) {
        const coin_state s = {.wX = random_between(&r, 0.003, 0.008),
                              .wY = random_between(&r, 0.005, 0.015)};
        double left = 25, moved;
        coin_body b;
        check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
        check_note("seed 105, coin %d", i);
        for (int calls = 0; left > 0 && calls < 100; ++calls) {
            check(coin_move(&b, &p, &ice, left, 0x1p-7, stop, &moved) >= 0);
            check(moved >= 0 && moved <= left);
            left -= moved;
        }
        check(left == 0);
    }
}
