/* SPDX-License-Identifier: MIT */
/* Which side of a coin is up, and the moment at which that is decided. */
#include "support/check.h"
#include "support/thrown.h"

#include <coin_body.h>

#include <math.h>

#define LAST_LEAN (1.5707963267948966 - 2.220446049250313e-16)

/* The energy of a coin that balances on a rim. */
static double barrier(const coin_params *p)
{
    const double half = p->thickness / 2;
    return sqrt(1 + half * half);
}

/* ------------------------------------------------------------------ faces */
static int32_t face_at(const coin_params *p, double theta)
{
    const coin_state s = {.theta = theta, .phi = 1, .psi = 2};
    const coin_body b = rolling(&s, p);
    return coin_body_face(&b, p);
}

TEST(a_thin_coin_has_an_edge_only_upright)
{
    const coin_params p = thrown_params(0.25, 0.5);
    check(face_at(&p, 0) == COIN_EDGE);
    check(face_at(&p, -1e-300) == COIN_HEADS &&
          face_at(&p, 1e-9) == COIN_TAILS);
    check(face_at(&p, -LAST_LEAN) == COIN_HEADS);
    check(face_at(&p, LAST_LEAN) == COIN_TAILS);
}

TEST(a_thick_coin_has_an_edge_up_to_where_it_balances)
{
    for (double half = 5e-5; half <= 2; half *= 1.5) {
        const coin_params p = cylinder(half);
        check_note("half = %g", half);
        check(face_at(&p, 0) == COIN_EDGE);
        for (int side = -1; side < 2; side += 2) {
            const int32_t face = side < 0 ? COIN_HEADS : COIN_TAILS;
            const double lean = side * atan(half);
            check(face_at(&p, lean * (1 - 1e-12)) == COIN_EDGE);
            check(face_at(&p, lean * (1 + 1e-12)) == face);
            check(face_at(&p, side * LAST_LEAN) == face);
        }
    }
}

/* It is how it would fall: back on its edge, or on its side. */
TEST(a_coin_let_go_falls_as_its_face_says)
{
    const coin_table f = {.mu_static = INFINITY, .mu_kinetic = 0.1};
    for (double half = 0.05; half < 1; half *= 1.7)
        for (int i = 0; i < 4; ++i) {
            const coin_params p = cylinder(half);
            const double part = (const double[]){-1.01, -0.99, 0.99, 1.01}[i];
            const coin_state s = {.theta = part * atan(half), .phi = 1};
            coin_body b = rolling(&s, &p);
            const int32_t face = coin_body_face(&b, &p);
            check_note("half = %g, %g of the lean", half, part);
            check_status(coin_move(&b, &p, &f, INFINITY, 1e-9, 0, NULL),
                         COIN_RESTS);
            check(coin_body_face(&b, &p) == face);
            check(face == (i == 0   ? COIN_HEADS
                           : i == 3 ? COIN_TAILS
                                    : COIN_EDGE));
        }
}

/* The side +Z is up where an engine's quaternion turns it up. */
TEST(heads_is_the_side_of_the_axis)
{
    const coin_params p = cylinder(0.1);
    const double still[] = {0, 0, 0}, r[] = {0, 3, 0};
    for (int i = 0; i < 8; ++i) {
        const double turn = i * 0.8 + 0.1; /* about x, from z up */
        const double q[] = {cos(turn / 2), sin(turn / 2), 0, 0};
        coin_body b;
        check_note("turned by %g", turn);
        check_status(coin_body_from_motion(&b, &p, q, still, r, still),
                     COIN_OK);
        check(coin_body_face(&b, &p) ==
              (-sin(turn) > 0 ? COIN_HEADS : COIN_TAILS));
    }
}

TEST(a_bad_body_has_no_face)
{
    coin_params p = cylinder(0.1);
    const coin_state s = {.theta = 0.3};
    coin_body b = rolling(&s, &p);
    check_status(coin_body_face(NULL, &p), COIN_EARG);
    check_status(coin_body_face(&b, NULL), COIN_EARG);
    b.s.theta = NAN;
    check_status(coin_body_face(&b, &p), COIN_ESTATE);
    b = rolling(&s, &p);
    b.reserved[0] = 1;
    check_status(coin_body_face(&b, &p), COIN_ESTATE);
    p.thickness = 5;
    check_status(coin_body_face(&b, &p), COIN_EPARAMS);
}

/* ---------------------------------------------------------------- decided */
/* Until it is decided: the status of the last call; the body is the one then.
 */
static int32_t until_decided(coin_body *b, const coin_params *p,
                             const coin_table *f, double tol, double *t)
{
    return coin_move(b, p, f, INFINITY, tol, COIN_DECIDED, t);
}

/* A roll against dry friction: the moment is where its energy is that of
 * balancing. */
TEST(the_moment_is_located_in_a_roll)
{
    for (int i = 0; i < 40; ++i) {
        const double half = (const double[]){0, 0.01, 0.07, 0.5}[i % 4];
        const double side = i / 4 % 2 ? 1 : -1;
        coin_params p = thrown_params(0.25, 0.5);
        if (half > 0)
            p = cylinder(half);
        const coin_table f = {.mu_static = INFINITY,
                              .mu_kinetic = 0.1,
                              .losses = {.dry = 0.02, .spin = 0.01}};
        coin_state s = {
            .theta = side * (atan(half) + 0.3 + 0.01 * i),
            .wX = side * 0.1,
            .wY = 0.2,
        };
        coin_body exact = rolling(&s, &p), b = exact;
        while (coin_body_energy(&b, &p) < barrier(&p) + 0.01) {
            s.wZ += side * 0.01;
            b = exact = rolling(&s, &p);
        }
        double at, t;
        check_note("half = %g, roll %d", half, i);
        check(coin_body_energy(&b, &p) > barrier(&p));
        check_status(until_decided(&exact, &p, &f, 1e-12, &at), COIN_DECIDED);
        check_within(at, 0.1, 1e3);
        check(coin_body_energy(&exact, &p) < barrier(&p));
        check_near(coin_body_energy(&exact, &p), barrier(&p), 1e-13);
        check_status(until_decided(&b, &p, &f, 1e-6, &t), COIN_DECIDED);
        check(coin_body_energy(&b, &p) < barrier(&p));
        check_near(coin_body_energy(&b, &p), barrier(&p), 1e-9);
        check_near(t, at, 2e-6 * (1 + at) / 0.005);
    }
}

/* On both rims: a roll that dry friction slows at the rate D/(I_Z + 1). */
TEST(the_moment_is_located_upright)
{
    for (int i = 0; i < 10; ++i) {
        const double half = 0.3 + 0.05 * i, dry = 0.01;
        const coin_params p = cylinder(half);
        const coin_table f = {.mu_static = 0.4,
                              .mu_kinetic = 0.3,
                              .losses = {.dry = dry, .soft = 1e-6}};
        const double m = 1 + p.inertia_Z, low = sqrt(2 * (barrier(&p) - 1) / m);
        coin_body b = rolling(&(coin_state){.wZ = low + 0.1}, &p);
        double t;
        check_note("half = %g", half);
        check_status(until_decided(&b, &p, &f, 1e-9, &t), COIN_DECIDED);
        check_near(t, 0.1 * m / dry, 1e-6);
        check(coin_body_energy(&b, &p) < barrier(&p));
        check_near(coin_body_energy(&b, &p), barrier(&p), 1e-9);
        check(coin_body_face(&b, &p) == COIN_EDGE);
    }
}

/* In the air the angular damping alone takes energy. */
TEST(the_moment_is_located_in_flight)
{
    for (int i = 0; i < 30; ++i) {
        const double half = (const double[]){0, 0.07, 0.5}[i % 3];
        coin_params p = thrown_params(0.25, 0.5);
        if (half > 0)
            p = cylinder(half);
        const double b = 0.1 + 0.02 * i;
        const coin_table f = {
            .mu_static = 0.3, .mu_kinetic = 0.3, .losses = {.angular = b}};
        const double up = 3.5, spin = 4;
        /* The centre rises from 1/2 below 0: its own energy stays below. */
        const coin_state s = {.theta = 0.5, .wX = spin};
        coin_body body = {.s = s, .y = 3, .vy = up};
        const double own = up * up / 2 + 3,
                     turn = 0.5 * p.inertia_X * spin * spin;
        /* Energy own + turn exp(-2 b t): above the barrier for ever. */
        double t;
        check_note("half = %g, angular = %g", half, b);
        check(own > barrier(&p) && turn > 0);
        check_status(coin_move(&body, &p, &f, 1, 1e-9, COIN_DECIDED, &t),
                     COIN_LIFTS);
        check(t == 1);
        /* Low and slow, it spins in the air: decided at a closed form. */
        const double lean = 1.5;
        const coin_state low = {.theta = lean, .wZ = spin};
        const double Y = cos(lean) + half * sin(lean);
        body = (coin_body){.s = low, .y = Y + 0.01, .vy = 0.9};
        const double left = barrier(&p) - body.y - 0.405;
        const double E = 0.5 * p.inertia_Z * spin * spin;
        const double when = log(E / left) / (2 * b);
        if (!(left > 0 && when < 1.7))
            continue;
        check_status(coin_move(&body, &p, &f, 9, 1e-9, COIN_DECIDED, &t),
                     COIN_LIFTS | COIN_DECIDED);
        check_near(t, when, 1e-12 + 1e-9);
        check(coin_body_energy(&body, &p) < barrier(&p));
        check_near(coin_body_energy(&body, &p), barrier(&p), 1e-9);
    }
}

/* Face down at a speed with which it could still turn over: v = v0 - mu t. */
TEST(the_moment_is_located_in_a_slide)
{
    for (int i = 0; i < 10; ++i) {
        const double half = 0.05 * i, mu = 0.1 + 0.01 * i, fast = 2;
        coin_params p = thrown_params(0.25, 0.5);
        if (half > 0)
            p = cylinder(half);
        const coin_table f = {.mu_static = mu, .mu_kinetic = mu};
        const coin_state s = {.theta = -LAST_LEAN};
        coin_body b = rolling(&s, &p);
        double t, v = sqrt(2 * (barrier(&p) - half));
        check_note("half = %g", half);
        b.vx = fast;
        check_status(until_decided(&b, &p, &f, 1e-9, &t),
                     COIN_SLIPS | COIN_DECIDED);
        check_near(t, (fast - v) / mu, 1e-11);
        check_near(b.vx, v, 1e-11);
        check(coin_body_energy(&b, &p) < barrier(&p));
        check(coin_body_face(&b, &p) == COIN_HEADS);
        check_status(until_decided(&b, &p, &f, 1e-9, &t), COIN_RESTS);
        check_near(t, v / mu, 1e-11);
    }
}

/* In the first steps of a slip, which are written otherwise, the energy is that
 * of the members too. */
TEST(the_moment_is_located_where_a_slip_begins)
{
    static const struct {
        double mu_static, mu_kinetic, viscous;
        coin_state s;
    } cases[] = {
        {0.2311, 0.2217, 0.0283, {1.03626, 0, 0, 0, 0, 0.1968, 1.9291, 0.2645}},
        {0.3723, 0.3522, 0.0119, {0.74842, 0, 0, 0, 0, 0.4145, 1.1856, 0.1782}},
        {0.2783, 0.2763, 0.0144, {1.18299, 0, 0, 0, 0, 0.4230, 1.9324, 0.2708}},
    };
    const coin_params p = thrown_params(0.25, 0.5);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        const coin_table f = {.mu_static = cases[i].mu_static,
                              .mu_kinetic = cases[i].mu_kinetic,
                              .losses = {.viscous = cases[i].viscous}};
        for (double tol = 1e-9; tol < 1e-2; tol *= 3) {
            coin_body b = rolling(&cases[i].s, &p);
            check_note("case %zu, tol %g", i, tol);
            check_status(coin_move(&b, &p, &f, 5, tol, COIN_DECIDED, NULL),
                         COIN_DECIDED | COIN_SLIPS);
            check_within(coin_body_energy(&b, &p), 1 - tol, 1);
        }
    }
}

/* An impact decides at once. */
TEST(an_impact_decides)
{
    const coin_params p = cylinder(0.1);
    const coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.3};
    const coin_state s = {.theta = 0.7};
    coin_body b = rolling(&s, &p);
    double t;
    b.y += 0.25;
    check(coin_body_energy(&b, &p) > barrier(&p));
    const int32_t stop = COIN_DECIDED | COIN_TOUCHES;
    check_status(coin_move(&b, &p, &f, 9, 1e-9, stop, &t),
                 COIN_LIFTS | COIN_TOUCHES);
    check_near(t, sqrt(0.5), 1e-14);
    const int32_t status = coin_move(&b, &p, &f, 9, 1e-9, stop, &t);
    check(status & COIN_DECIDED && t == 0);
    check(coin_body_energy(&b, &p) < barrier(&p));
}

/* Frames to rest: none ends because it is decided. */
static void rests_untold(coin_body *b, const coin_params *p,
                         const coin_table *f)
{
    int32_t status;
    do {
        status = coin_move(b, p, f, 0.3, 1e-9, COIN_DECIDED, NULL);
        check(status >= 0 && !(status & COIN_DECIDED));
    } while (!(status & COIN_RESTS));
}

TEST(what_is_decided_at_the_start_is_no_moment)
{
    const coin_params p = cylinder(0.1);
    const coin_table f = {
        .mu_static = 0.3, .mu_kinetic = 0.3, .losses = {.dry = 0.01}};
    const coin_state s = {.theta = 0.9, .wY = 0.1};
    coin_body b = rolling(&s, &p);
    check(coin_body_energy(&b, &p) < barrier(&p));
    rests_untold(&b, &p, &f);
}

/* With the slip of the body, not without it: that slip is so slow that the coin
 * rolls. */
TEST(what_a_slip_that_is_none_decides_is_no_moment)
{
    const coin_params p = cylinder(0.1);
    const coin_table f = {
        .mu_static = 0.3, .mu_kinetic = 0.3, .losses = {.dry = 0.01}};
    coin_state s = {.theta = 0.9, .wZ = 1};
    double low = 0, high = 9;
    for (int i = 0; i < 60; ++i) {
        s.wZ = (low + high) / 2;
        const coin_body b = rolling(&s, &p);
        *(coin_body_energy(&b, &p) < barrier(&p) + 1e-12 ? &low : &high) = s.wZ;
    }
    coin_body b = rolling(&s, &p);
    check(coin_body_energy(&b, &p) > barrier(&p));
    b.vx += 5e-11;
    check(coin_body_energy(&b, &p) < barrier(&p));
    rests_untold(&b, &p, &f);
}

TEST(with_a_pull_nothing_is_decided_by_energy)
{
    const coin_params p = cylinder(0.1);
    coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.3, .pull = {0, 1e-9}};
    const coin_state s = {.theta = 0.9};
    coin_body b = rolling(&s, &p);
    const coin_body before = b;
    double t = 7;
    for (int i = 0; i < 2; ++i) {
        check_status(coin_move(&b, &p, &f, 1, 1e-9, COIN_DECIDED, &t),
                     COIN_EARG);
        check_status(
            coin_move(&b, &p, &f, 1, 1e-9, COIN_DECIDED | COIN_TOUCHES, &t),
            COIN_EARG);
        f.pull[0] = 1e-9;
        f.pull[1] = 0;
    }
    check_same(&b, &before, sizeof b);
    check(t == 7);
}

/* Where a face sticks, it is decided as it comes to lie. */
TEST(a_face_that_sticks_is_decided_where_it_comes_to_rest)
{
    const coin_params p = cylinder(0);
    const coin_table f = {
        .mu_static = INFINITY, .mu_kinetic = 0.3, .losses = {.dry = 0.01}};
    const coin_state s = {.theta = 1.4, .wX = 0.3, .wZ = 2};
    coin_body b = rolling(&s, &p);
    check_status(coin_move(&b, &p, &f, INFINITY, 1e-6, COIN_DECIDED, NULL),
                 COIN_RESTS | COIN_DECIDED);
}

/* On its rim at the start of the call, on its face at once. */
TEST(a_fall_on_the_face_decides_and_begins_a_slide)
{
    const coin_params p = cylinder(0);
    const coin_table f = {.mu_static = 0.5, .mu_kinetic = 0.4};
    for (int side = -1; side <= 1; side += 2) {
        const coin_state s = {
            .theta = -side * 1.5707958, .wX = 3 * side, .wZ = 1};
        for (int i = 0; i < 2; ++i) {
            const int32_t stop = i ? COIN_SLIPS : COIN_DECIDED;
            coin_body b = rolling(&s, &p);
            double t;
            check_status(coin_move(&b, &p, &f, 1, 1e-6, stop, &t),
                         COIN_SLIPS | (i ? 0 : COIN_DECIDED));
            check(t == 0 && b.vx * b.vx + b.vz * b.vz > 0.9);
        }
    }
}

/* ------------------------------------------------------------------ tosses */
/* A toss to rest by calls that end at the moments: 1 if it came to lie as the
 * moment said; 0 if not; -1 if it stands on its edge. */
static int keeps_its_word(const coin_body *from, const coin_params *p,
                          const coin_table *f, double tol)
{
    coin_body b = *from;
    int32_t status = COIN_OK, said = 0;
    int calls = 0;
    while (!(status & COIN_RESTS)) {
        status = coin_move(&b, p, f, INFINITY, tol, COIN_DECIDED, NULL);
        check(status >= 0 && ++calls < 2000);
        if (status & COIN_DECIDED) {
            check(said == 0); /* it is told once */
            said = coin_body_face(&b, p);
            check(coin_body_energy(&b, p) < barrier(p));
        }
        if (b.s.theta == 0 && b.s.wX == 0)
            return said == COIN_EDGE || said == 0 ? -1 : 0;
    }
    check(said != 0);
    return coin_body_face(&b, p) == said;
}

/* All of them, thin and thick, at 1e-6 and 1e-9; at 1e-3 nearly all. */
TEST(a_toss_lies_as_it_was_decided)
{
    struct random r = random_begin(5150);
    const int count = tries_asked(120);
    int kept[3] = {0, 0, 0}, lie[3] = {0, 0, 0};
    for (int i = 0; i < count; ++i) {
        static const double tols[] = {1e-6, 1e-9, 1e-3};
        coin_params p = thrown_params(0.25, 0.5);
        if (i % 2)
            p = random_cylinder(&r, 1e-2, 0.5);
        coin_table f = random_table(&r, &p);
        f.losses.angular = i % 4 < 2 ? 0 : 0.01;
        const coin_body b = random_toss(&r, &p, 10, 20);
        for (int k = 0; k < 3; ++k) {
            check_note("seed 5150, toss %d, tol = %g", i, tols[k]);
            const int word = keeps_its_word(&b, &p, &f, tols[k]);
            check(word != 0 || k == 2);
            kept[k] += word == 1;
            lie[k] += word >= 0;
        }
    }
    check(lie[0] > count / 2 && lie[1] > count / 2);
    check_share(kept[2], lie[2], 0.99);
}

/* The search for the moment moves the coin ahead about 40 times.  The steps of
 * that are not taken from those of the call. */
TEST(looking_ahead_takes_no_steps_of_the_call)
{
    const coin_params p = cylinder(0.7);
    const coin_table f = {.mu_static = 0.1,
                          .mu_kinetic = 0.1,
                          .losses = {.dry = 0.002, .spin = 0.02}};
    const coin_body b = {.s = {.wZ = -1.2}, .y = 1, .vx = 1.5};
    static coin_priv_moving searches, moves;
    coin_priv_moving *const calls[] = {&searches, &moves};
    for (int i = 0; i < 2; ++i) {
        coin_priv_moving *const g = calls[i];
        coin_priv_constants of;
        check_status(coin_priv_check_coin_body(&g->c, &b, &p, &of), COIN_OK);
        check_status(coin_priv_table_law(&g->law, &f, &of, 0.7), COIN_OK);
        coin_priv_begin_call(g, i ? searches.moved.sum : INFINITY, 1e-6, 11000);
        g->stop = i ? 0 : COIN_DECIDED;
        check_status(coin_priv_go_on(g), i ? COIN_OK : COIN_DECIDED);
    }
    check(searches.tries == moves.tries);
}
