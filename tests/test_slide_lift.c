/* SPDX-License-Identifier: MIT */
/* Where a coin that slips, or begins to, lifts off. */
#include "support/check.h"
#include "support/coins.h"
#include "support/losses.h"
#include "support/slides.h"

#include <math.h>

static const coin_table rough = {.mu_static = 0.55, .mu_kinetic = 0.5};

/* With as much friction as that the coin keeps to the cone nearly until N = 0,
 * and rolls on for a time where its slip would begin.  The force of that slip
 * is far from the one that rolling would take. */
TEST(a_coin_lifts_off_where_the_force_of_its_slip_is_0)
{
    const coin_table high = {.mu_static = 1.1, .mu_kinetic = 1.1};
    const coin_params p = disc();
    for (double tol = 1e-2; tol > 1e-11; tol *= 1e-4) {
        const int count = tries_asked(75);
        struct random r = random_begin(178);
        int lifted = 0, pulled = 0;
        for (int i = 0; i < count; ++i) {
            const coin_state s = random_state(&r, &p, 1.2);
            coin_body d;
            coin_force force, rolls;
            double reached;
            coin_body_from_state(&d, &s, &p);
            if (slide(&d, &p, &high, NULL, 3, tol, &reached) != COIN_LIFTS ||
                reached == 0)
                continue;
            slide_reaction(&d, &p, &high, NULL, &force);
            check(force.normal == 0);
            coin_reaction(&d.s, &p, &rolls);
            pulled += rolls.normal < -0.1;
            ++lifted;
        }
        check(lifted > count / 15 && pulled > count / 30);
    }
}

/* Calls that end just before a lift, at a tol so large that the step to it may
 * go past their end.  A longer call tells when the lift is.  Both calls locate
 * it to tol. */
TEST(no_coin_lifts_off_after_the_end_of_a_call)
{
    const coin_table high = {.mu_static = 1.1, .mu_kinetic = 1.1};
    const coin_params p = disc();
    const double tol = 1e-2;
    const int count = tries_asked(225);
    struct random r = random_begin(191);
    int lifted = 0;
    for (int i = 0; i < count; ++i) {
        const coin_state s = random_state(&r, &p, 1.2);
        coin_body start, d;
        double when, reached;
        coin_body_from_state(&start, &s, &p);
        d = start;
        if (slide(&d, &p, &high, NULL, 3, tol, &when) != COIN_LIFTS)
            continue;
        ++lifted;
        for (double early = 1e-2; early > 1e-7; early /= 1.2) {
            const double t = when * (1 - early);
            d = start;
            const int32_t status = slide(&d, &p, &high, NULL, t, tol, &reached);
            check_within(reached, 0, t);
            if (status != COIN_LIFTS)
                continue;
            d = start;
            slide(&d, &p, &high, NULL, t + tol, tol, &reached);
            check_within(reached, 0, t + tol);
        }
    }
    check(lifted > count / 15);
}

/* Upright but for 0.1, and falling so fast that N is all but 0: there is hardly
 * any friction, and the slip that has begun grows as rolling lets it. */
TEST(a_coin_lifts_off_in_a_slip_that_has_just_begun)
{
    const coin_params p = disc();
    const double N = 1e-5, c = cos(0.1), wX = sqrt((1 - N) / c);
    const coin_body start = {
        .s = {.theta = -0.1, .wX = wX}, .vx = 0, .vz = wX * c - 1e-9};
    for (double tol = 1e-2; tol > 1e-11; tol *= 1e-4) {
        coin_body d = start;
        coin_force force;
        double reached;
        check_status(slide(&d, &p, &rough, NULL, 1, tol, &reached), COIN_LIFTS);
        slide_reaction(&d, &p, &rough, NULL, &force);
        check(force.normal == 0);
        check_near(reached, N / (sin(0.1) * wX * wX * wX), 1e-2 * N);
    }
}

/* The second derivative of the gap under the rim without a force, (96): by the
 * members of a state, in natural units. */
static double opens(const coin_state *s, const coin_params *p)
{
    const double c = cos(s->theta), sn = sin(s->theta);
    const double up = p->inertia_Z / p->inertia_X * s->wZ + s->wY * sn / c;
    return c * s->wX * s->wX - 1 - sn * s->wY * up;
}

/* Rolling would take a table that pulls.  The coin lifts off if the gap opens,
 * and else it slips: also where mu_static is infinite.  The sign is of the
 * coin, and not of its friction.  Where it is nearly 0 a slip may lift off at
 * once, or a coin that lifts off fall back. */
TEST(a_coin_slips_where_only_rolling_would_lift_it)
{
    const coin_table high = {.mu_static = 1.1, .mu_kinetic = 1.1},
                     low = {.mu_static = 0.3, .mu_kinetic = 0.25};
    const coin_table endless = {.mu_static = INFINITY, .mu_kinetic = 1.1};
    const coin_params p = disc();
    struct random r = random_begin(179);
    int slip = 0, lift = 0;
    for (int i = 0; i < 1000; ++i) {
        const coin_state s = random_state(&r, &p, 1.2);
        const double gap = opens(&s, &p);
        coin_body d;
        coin_force rolls, slips;
        coin_body_from_state(&d, &s, &p);
        coin_reaction(&s, &p, &rolls);
        if (rolls.normal > 0 || fabs(gap) < 1e-2)
            continue;
        const int32_t want = gap < 0 ? COIN_SLIPS : COIN_LIFTS;
        slide_reaction(&d, &p, &high, NULL, &slips);
        check((slips.normal > 0) == (gap < 0));
        check_status(slide(&d, &p, &high, NULL, 0, 1e-9, NULL), want);
        check_status(slide(&d, &p, &low, NULL, 0, 1e-9, NULL), want);
        check_status(slide(&d, &p, &endless, NULL, 1e-6, 1e-9, NULL), want);
        if (want == COIN_SLIPS)
            check_near(slips.ratio, 1.1, 1e-12);
        ++*(want == COIN_SLIPS ? &slip : &lift);
    }
    check(slip > 20 && lift > 20);
}

TEST(a_coin_that_is_pressed_down_does_not_lift_off_at_any_lean)
{
    struct random r = random_begin(227);
    int lifted = 0;
    for (int i = 0; i < 4000; ++i) {
        const double c = pow(10, random_between(&r, -5, 0));
        const coin_table table = {.mu_static = 0.3, .mu_kinetic = 0.2};
        coin_params p;
        coin_state s = {.theta = acos(c)};
        coin_body b;
        coin_params_ring(&p, 1, 1, random_between(&r, 0, 1), 1);
        s.wX = random_between(&r, -3, 3);
        s.wY = random_between(&r, -3, 3);
        s.wZ = random_between(&r, -3, 3);
        check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
        if (coin_move(&b, &p, &table, 0, 1e-6, 0, NULL) != COIN_LIFTS)
            continue;
        check_note("theta %.17g w %g %g %g", s.theta, s.wX, s.wY, s.wZ);
        check(opens(&s, &p) >= -1e-9);
        ++lifted;
    }
    check(lifted > 50);
}

/* Flown high above the table it opens its gap: the damping of a flight is that
 * of a contact. */
TEST(a_damped_coin_lifts_off_if_it_opens_its_gap_in_flight)
{
    const coin_params p = disc();
    const int count = tries_asked(4000);
    const double dt = 1e-5;
    struct random r = random_begin(233);
    int lifted = 0, by_damping = 0;
    for (int i = 0; i < count; ++i) {
        const coin_table table = {.mu_static = i % 3 ? 0.4 : INFINITY,
                                  .mu_kinetic = 0.3,
                                  .losses.angular = random_between(&r, 0.3, 3)};
        const coin_state s = random_state(&r, &p, 1.4);
        coin_body b, flies;
        coin_force force;
        check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
        b.vx += i % 2 ? random_between(&r, -1, 1) : 0;
        flies = b;
        flies.y += 10;
        check_status(coin_move(&flies, &p, &table, dt, 1e-9, 0, NULL),
                     COIN_LIFTS);
        const double gap = flies.y - 10 - cos(flies.s.theta);
        const double opens_by = 2 * (gap - (b.y - cos(s.theta))) / (dt * dt);
        if (fabs(opens_by) < 1e-2)
            continue;
        check_note("theta %.17g w %g %g %g", s.theta, s.wX, s.wY, s.wZ);
        const int32_t status = coin_move(&b, &p, &table, 0, 1e-9, 0, NULL);
        check(status != COIN_LIFTS || opens_by > 0);
        check_status(coin_body_reaction(&b, &p, &table, &force), COIN_OK);
        check((force.normal == 0) == (status == COIN_LIFTS));
        lifted += status == COIN_LIFTS;
        by_damping += status == COIN_LIFTS && opens(&s, &p) < 0;
    }
    check(lifted > count / 20 && by_damping > count / 100);
}

/* How much more the gap opens after a short time in the air: the coin flies
 * high above the table. */
static double opens_more(const coin_state *s, const coin_params *p,
                         const coin_table *table)
{
    coin_body b;
    check_status(coin_body_from_state(&b, s, p), COIN_OK);
    b.y += 10;
    check_status(coin_move(&b, p, table, 1e-4, 1e-6, 0, NULL), COIN_LIFTS);
    return opens(&b.s, p) - opens(s, p);
}

/* The table would have just ceased to press, and rolling would take a pull.  A
 * coin lifts off if it goes on to open the gap; its reverse, which has come
 * from there, falls back at once.  The table pulls neither. */
TEST(a_coin_that_would_fall_back_at_once_does_not_lift_off)
{
    const coin_table table = {.mu_static = INFINITY, .mu_kinetic = 0.2};
    const coin_params p = disc();
    const double k1 = p.inertia_Z / p.inertia_X;
    struct random r = random_begin(231);
    int lifts = 0, stays = 0;
    for (int i = 0; i < 2000; ++i) {
        coin_state s = {.theta = random_between(&r, -1.2, 1.2)};
        coin_body b;
        coin_force rolls, force;
        s.wX = random_between(&r, -2, 2);
        s.wY = random_between(&r, -2, 2);
        s.wZ = (opens(&s, &p) - 1e-9) / (k1 * s.wY * sin(s.theta));
        if (!(fabs(s.wZ) < 10))
            continue;
        const double more = opens_more(&s, &p, &table);
        check_status(coin_reaction(&s, &p, &rolls), COIN_OK);
        if (fabs(more) < 1e-5 || rolls.normal > 0)
            continue;
        check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
        check_note("theta %.17g w %g %g %g: %g", s.theta, s.wX, s.wY, s.wZ,
                   more);
        check_status(coin_move(&b, &p, &table, 0, 1e-6, 0, NULL),
                     more > 0 ? COIN_LIFTS : COIN_SLIPS);
        check_status(coin_body_reaction(&b, &p, &table, &force), COIN_OK);
        check(force.R[0] == 0 && force.R[1] == 0 && force.R[2] == 0);
        check(force.normal == 0 && force.friction == 0 && isinf(force.ratio));
        ++*(more > 0 ? &lifts : &stays);
    }
    check(lifts > 500 && stays > 500);
}

/* A call that is shorter than the time in which no lift-off is looked at. */
TEST(a_coin_that_lifts_off_flies_no_longer_than_the_call)
{
    const coin_params p = disc();
    const coin_state s = {.theta = -0.1, .wX = 1.5};
    const double t = 1e-6;
    coin_body b;
    check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
    const double vy = b.vy;
    check_status(coin_move(&b, &p, &rough, t, 1e-6, 0, NULL), COIN_LIFTS);
    check_near(b.vy, vy - t, 8 * U);
}

/* Rolling would press it on, by friction that the table does not have. */
TEST(a_coin_that_lifts_off_feels_no_force)
{
    const coin_state s = {.theta = 0.25, .wY = -1.5, .wZ = 2.1};
    const coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.3};
    coin_params p;
    coin_body b;
    coin_force rolling, force;
    check_status(coin_params_body(&p, 1, 1, 1, 0.12, 0.22), COIN_OK);
    check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
    check_status(coin_move(&b, &p, &f, 0, 1e-6, 0, NULL), COIN_LIFTS);
    check_status(coin_reaction(&s, &p, &rolling), COIN_OK);
    check(rolling.normal > 0.1 && rolling.ratio > 2 * f.mu_static);
    check_status(coin_body_reaction(&b, &p, &f, &force), COIN_OK);
    check(force.normal == 0 && force.friction == 0);
}
