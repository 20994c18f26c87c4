/* SPDX-License-Identifier: MIT */
/* From the hand to rest: coin_move() of a coin that flies, bounces, slips,
 * rolls and slides on its face. */
#include "support/check.h"
#include "support/thrown.h"

#include <errno.h>
#include <fenv.h>
#include <float.h>
#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846
#define LAST_LEAN (1.5707963267948966 - 2.220446049250313e-16)

/* ------------------------------------------------------------- reference */
static coin_table table_in_row(const struct table *t, size_t i)
{
    coin_table f;
    memset(&f, 0, sizeof f);
    f.mu_static = table_at(t, i, "mu_static");
    f.mu_kinetic = table_at(t, i, "mu_kinetic");
    f.restitution = table_at(t, i, "e");
    return f;
}

/* Three bounces amplify rounding some thousand times: measured 1e-12 at most,
 * and a factor 8. */
#define OF_THREE 1e-11

TEST(three_bounces_are_those_of_newton_and_euler)
{
    static struct table t;
    table_load(&t, "toss/tosses.csv");
    for (size_t i = 0; i < t.rows; ++i) {
        const coin_params p =
            thrown_params(table_at(&t, i, "I_X"), table_at(&t, i, "I_Z"));
        const coin_table f = table_in_row(&t, i);
        const coin_body want = body_in_row(&t, i, "1");
        const double end = table_at(&t, i, "t_end");
        coin_body one = body_in_row(&t, i, ""), many = one, stops = one;
        double moved, sum = 0;
        check_note("row %zu", i);
        check_status(coin_move(&one, &p, &f, end, 1e-9, 0, &moved), COIN_LIFTS);
        check(moved == end);
        check_near(bodies_apart(&one, &want), 0, OF_THREE);
        for (int k = 0; k < 100; ++k)
            check_status(coin_move(&many, &p, &f, end / 100, 1e-2, 0, NULL),
                         COIN_LIFTS);
        check_near(bodies_apart(&many, &want), 0, OF_THREE);
        for (int k = 0; k < 3; ++k) {
            static const char *const names[] = {"t1", "t2", "t3"};
            const int32_t stop = COIN_TOUCHES;
            check_status(coin_move(&stops, &p, &f, end, 1e-9, stop, &moved),
                         COIN_LIFTS | COIN_TOUCHES);
            sum += moved;
            check_near(sum, table_at(&t, i, names[k]), OF_THREE);
        }
        check_status(coin_move(&stops, &p, &f, end - sum, 1e-9, 0, NULL),
                     COIN_LIFTS);
        check_near(bodies_apart(&stops, &want), 0, 8 * OF_THREE);
    }
}

/* ------------------------------------------------------------ all the way */
struct end {
    coin_body b;
    double t;
    int32_t status;
};

/* Calls of dt until one says neither that the coin moves on nor that the steps
 * did not suffice. */
static struct end in_calls(const coin_body *b, const coin_params *p,
                           const coin_table *f, double dt, double tol)
{
    struct end r = {*b, 0, COIN_OK};
    double moved, E = coin_body_energy(b, p);
    const double top = E;
    do {
        r.status = coin_move(&r.b, p, f, dt, tol, 0, &moved);
        r.t += moved;
        const double now = coin_body_energy(&r.b, p);
        check(now <= E + tol * top);
        E = now;
        check(gap(&r.b) >= -32 * U);
        check(r.t < 1e6);
    } while (r.status >= 0 && !(r.status & COIN_RESTS));
    return r;
}

TEST(a_toss_ends_at_rest)
{
    const int count = tries_asked(30);
    struct random r = random_begin(861);
    for (int i = 0; i < count; ++i) {
        const coin_params p = random_body(&r);
        const coin_table f = random_table(&r, &p);
        const coin_body b = random_throw(&r, 50, 60);
        check_note("seed 861, toss %d", i);
        const struct end end =
            in_calls(&b, &p, &f, i % 2 ? INFINITY : 0.5, 1e-6);
        check_status(end.status, COIN_RESTS);
        check(fabs(end.b.s.theta) >= LAST_LEAN - DBL_EPSILON);
        check(end.b.vx == 0 && end.b.vy == 0 && end.b.vz == 0);
        check(end.b.s.wX == 0 && end.b.s.wY == 0 && end.b.s.wZ == 0);
    }
}

/* ------------------------------------------------------------ nearly flat */
/* A disc from an engine, 1e-9 to 1e-4 rad from flat, a little below the table,
 * that turns and falls. */
static coin_body handed_over(struct random *r, const coin_params *p,
                             double rate)
{
    const double lean = pow(10, random_between(r, -9, -4));
    const double half = PI / 4 - lean / 2;
    const double q[] = {cos(half), sin(half), 0, 0};
    double omega[3], v[3] = {0, -random_between(r, 0, 1), 0};
    const double at[] = {0, sin(lean) - random_between(r, 0, 1e-3), 0};
    for (int i = 0; i < 3; ++i)
        omega[i] = rate * random_between(r, -1, 1);
    v[0] = random_between(r, -0.5, 0.5);
    v[2] = random_between(r, -0.5, 0.5);
    coin_body b;
    check_status(coin_body_from_motion(&b, p, q, omega, at, v), COIN_OK);
    return b;
}

/* Near flat a hop of normal speed v lasts about 2 v cos(theta)/w^2: shorter by
 * far than any time that is looked over at once. */
TEST(a_coin_handed_over_nearly_flat_needs_one_call)
{
    static const double rates[] = {0.1, 0.5, 1, 3, 10};
    static const double restitution[] = {0, 0.3, 0.6};
    const int count = tries_asked(300);
    struct random r = random_begin(2611);
    const coin_params p = thrown_params(0.25, 0.5);
    for (int i = 0; i < count; ++i) {
        coin_table f = {.mu_static = 0.35, .mu_kinetic = i % 4 ? 0.3 : 0.35};
        f.restitution = restitution[i % 3];
        if (i % 2)
            f.losses = (coin_losses){.rolling = 0.01, .viscous = 1e-3};
        coin_body b = handed_over(&r, &p, rates[i % 5]);
        double moved = 0;
        check_note("seed %llu, body %d", (unsigned long long)r.seed, i);
        const int32_t status = coin_move(&b, &p, &f, 0.5, 1e-6, 0, &moved);
        check(status >= 0);
        check(moved == 0.5 || status == COIN_RESTS);
    }
}

static double places_apart(const coin_body *a, const coin_body *b)
{
    return hypot(a->s.x - b->s.x, a->s.z - b->s.z);
}

/* Where a start that is changed by 1e-9 ends within 1e-6.  Of some 5000 tosses
 * one depends on the tolerance otherwise: where a series of ever lower hops is
 * cut decides how it slips. */
TEST(frames_of_a_60th_end_where_one_call_does)
{
    const coin_params quarter = thrown_params(0.25, 0.5);
    const double frame = 1.0 / 60 / sqrt(0.01213 / 9.80665);
    const int count = tries_asked(20);
    struct random r = random_begin(862);
    int calm = 0, far = 0, beyond = 0;
    for (int i = 0; i < count; ++i) {
        coin_table f = random_table(&r, &quarter);
        f.restitution *= 0.5;
        const coin_body b = random_throw(&r, 2, 4);
        coin_body nudged = b;
        nudged.vy += 1e-9;
        check_note("seed 862, toss %d", i);
        const struct end one = in_calls(&b, &quarter, &f, INFINITY, 1e-9);
        const struct end other =
            in_calls(&nudged, &quarter, &f, INFINITY, 1e-9);
        if (!(places_apart(&one.b, &other.b) < 1e-6))
            continue;
        ++calm;
        const struct end rough = in_calls(&b, &quarter, &f, INFINITY, 1e-6);
        const struct end frames = in_calls(&b, &quarter, &f, frame, 1e-6);
        check(one.b.s.theta == rough.b.s.theta);
        check(one.b.s.theta == frames.b.s.theta);
        /* tol, times how the motion amplifies the nudge, along its way */
        const double most =
            1e-4 + 1e-6 * (1 + one.t) * (places_apart(&one.b, &other.b) / 1e-9);
        const double r1 = places_apart(&one.b, &rough.b);
        const double r2 = places_apart(&one.b, &frames.b);
        beyond += r1 > most || r2 > most;
        far += r1 > 1e-4 || r2 > 1e-4;
    }
    check(calm > count / 4);
    check_share(calm - far, calm, 0.98);
    check_share(calm - beyond, calm, 0.999);
}

/* ------------------------------------------------------------- symmetries */
/* A body in the mirror plane z = 0, which turns theta, phi, wX, wY and z. */
static coin_body mirrored(coin_body b)
{
    b.s.theta = -b.s.theta;
    b.s.phi = -b.s.phi;
    b.s.z = -b.s.z;
    b.s.wX = -b.s.wX;
    b.s.wY = -b.s.wY;
    b.vz = -b.vz;
    return b;
}

static coin_body headed(coin_body b, double by)
{
    const double s = sin(by), c = cos(by), x = b.s.x, vx = b.vx;
    b.s.phi += by;
    b.s.x = c * x + s * b.s.z;
    b.s.z = c * b.s.z - s * x;
    b.vx = c * vx + s * b.vz;
    b.vz = c * b.vz - s * vx;
    return b;
}

/* In units in which a mass, a length and a time are 1. */
static coin_body in_units(coin_body b, double a, double w)
{
    double *const v[] = {&b.vx, &b.vy, &b.vz};
    double *const rates[] = {&b.s.wX, &b.s.wY, &b.s.wZ};
    b.s.x *= a;
    b.s.z *= a;
    b.y *= a;
    for (int i = 0; i < 3; ++i) {
        *v[i] *= a * w;
        *rates[i] *= w;
    }
    return b;
}

/* Some bounces, and a slip. */
#define WAY 8

TEST(mirror_heading_and_units_change_nothing)
{
    const int count = tries_asked(100);
    struct random r = random_begin(863);
    int same = 0;
    for (int i = 0; i < count; ++i) {
        const coin_params p = random_body(&r);
        const double mass = 3.7, a = 0.021, g = 9.7, w = sqrt(g / a);
        coin_table f = random_table(&r, &p), scaled;
        const double turn = random_between(&r, -3, 3);
        const coin_body b = random_throw(&r, 3, 6);
        coin_body plain = b, near = b, sees = mirrored(b);
        coin_body turns = headed(b, turn), units = in_units(b, a, w);
        coin_params q;
        memset(&f.losses, 0, sizeof f.losses);
        scaled = f;
        near.vy *= 1 + 1e-13;
        check_status(coin_params_body(&q, mass, a, g,
                                      p.inertia_X * mass * a * a,
                                      p.inertia_Z * mass * a * a),
                     COIN_OK);
        const int32_t want = coin_move(&plain, &p, &f, WAY, 1e-9, 0, NULL);
        coin_move(&near, &p, &f, WAY, 1e-9, 0, NULL);
        const double amplified = bodies_apart(&plain, &near);
        if (!(amplified < 1e-8))
            continue;
        ++same;
        check_note("seed 863, toss %d", i);
        check_status(coin_move(&sees, &p, &f, WAY, 1e-9, 0, NULL), want);
        check_status(coin_move(&turns, &p, &f, WAY, 1e-9, 0, NULL), want);
        check_status(coin_move(&units, &q, &scaled, WAY / w, 1e-9, 0, NULL),
                     want);
        const double most = 1e-11 + 1000 * amplified;
        sees = mirrored(sees);
        turns = headed(turns, -turn);
        units = in_units(units, 1 / a, 1 / w);
        check_near(bodies_apart(&sees, &plain), 0, most);
        check_near(bodies_apart(&turns, &plain), 0, most);
        check_near(bodies_apart(&units, &plain), 0, most);
    }
    check(same > count / 2);
}

/* ---------------------------------------------------------------- bouncing */
/* Upright, with the spin of a wheel that rolls at its speed: it bounces until
 * sqrt(2 H) (1 + e)/(1 - e), and rolls on.  The last bounces are left out. */
TEST(a_wheel_that_drops_bounces_and_rolls)
{
    const coin_params p = thrown_params(0.25, 0.5);
    for (double e = 0; e < 0.85; e += 0.2) {
        const coin_table f = {
            .mu_static = 0.5, .mu_kinetic = 0.4, .restitution = e};
        const coin_body start = {.s = {.wZ = 2}, .y = 1 + 0.5, .vx = -2};
        const double stands = (1 + e) / (1 - e);
        coin_body b = start;
        double moved;
        check_note("e %g", e);
        check_status(coin_move(&b, &p, &f, 100, 1e-9, COIN_ROLLS, &moved),
                     COIN_OK | COIN_ROLLS);
        check_within(moved, stands - 2e-4 * e / (1 - e) - 1e-12,
                     stands + 1e-12);
        check(b.y == 1 && b.vy == 0 && b.s.wZ == 2 && b.vx == -2);
        check_near(b.s.x, -2 * moved, 1e-13);
    }
}

/* It touches when its centre is all but on the table, where the distance that
 * is searched for a zero is rounding. */
TEST(a_coin_that_drops_on_its_face_bounces)
{
    const coin_params p = thrown_params(0.25, 0.5);
    struct random r = random_begin(867);
    for (int i = 0; i < 50; ++i) {
        coin_table f = {
            .mu_static = 0.3, .mu_kinetic = 0.3, .restitution = 0.5};
        f.losses.dry = 0.01;
        const coin_body b = {
            .s = {.theta = LAST_LEAN, .wZ = i % 3},
            .y = random_between(&r, 1, 100),
        };
        check_note("seed 867, drop %d", i);
        coin_body later = b;
        check_status(coin_move(&later, &p, &f, 1.2 * sqrt(2 * b.y), 1e-6,
                               COIN_TOUCHES, NULL),
                     COIN_LIFTS | COIN_TOUCHES);
        check_near(later.y, 0, 1e-6);
        check_status(in_calls(&b, &p, &f, INFINITY, 1e-6).status, COIN_RESTS);
    }
}

/* A disc dropped flat but for 0.02 rad: when it lies, by another program, in
 * which a split of its calls moves it by 1e-3. */
TEST(clattering_ends)
{
    const double e[] = {0, 0.2, 0.5, 0.7, 0.8, 0.9};
    const double lies[] = {1.4318, 1.4975, 2.3640, 3.1654, 3.6246, 16.603};
    const coin_params p = thrown_params(0.25, 0.5);
    for (int i = 0; i < 6; ++i) {
        const coin_table f = {.mu_static = 0.33,
                              .mu_kinetic = 0.3,
                              .restitution = e[i],
                              .losses = {.flat = 1e-5}};
        coin_body b = {.s = {.theta = 1.5707963267948966 - 0.02}};
        b.y = 1 + cos(b.s.theta);
        double t = 0;
        check_note("e %g", e[i]);
        for (; fabs(b.s.theta) < LAST_LEAN && t < 20; t += 1e-3)
            check(coin_move(&b, &p, &f, 1e-3, 1e-9, 0, NULL) >= 0);
        check_near(t, lies[i], 1e-3 + 1e-3 * lies[i]);
    }
}

TEST(an_impact_that_is_due_is_made_by_the_next_call)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {
        .mu_static = 0.5, .mu_kinetic = 0.4, .restitution = 0.5};
    coin_body b = {.s = {.theta = 0.3, .wX = 1}, .y = 3};
    double moved;
    check_status(coin_move(&b, &p, &f, 9, 1e-9, COIN_TOUCHES, &moved),
                 COIN_LIFTS | COIN_TOUCHES);
    check(b.y == cos(b.s.theta));
    const double down = b.vy + b.s.wX * sin(b.s.theta);
    check(down < -0.5);
    const coin_body due = b;
    check_status(coin_move(&b, &p, &f, 0, 1e-9, COIN_TOUCHES, &moved),
                 COIN_LIFTS);
    check_same(&b, &due, sizeof b);
    check_status(coin_move(&b, &p, &f, 1e-9, 1e-9, COIN_TOUCHES, &moved),
                 COIN_LIFTS);
    check_near(b.vy + b.s.wX * sin(b.s.theta), -0.5 * down, 1e-8);
}

/* -------------------------------------------------------------- on its face */
TEST(a_coin_that_lies_slides_and_rests)
{
    static struct table t;
    table_load(&t, "toss/flat_slides.csv");
    for (size_t i = 0; i < t.rows; ++i) {
        const double a = 0.013, g = 9.81, w = sqrt(g / a), M = 0.006;
        const double mu = table_at(&t, i, "mu"), v0 = table_at(&t, i, "v0");
        const double w0 = table_at(&t, i, "w0"), S = v0 + fabs(w0);
        const double time = table_at(&t, i, "time") / w;
        const double m = M * a * a, side = i % 2 ? 1 : -1;
        const coin_table f = {.mu_static = 2 * mu, .mu_kinetic = mu};
        coin_params p;
        double when, u[3];
        coin_force force;
        check_note("row %zu", i);
        check_status(coin_params_body(&p, M, a, g, table_at(&t, i, "I_X") * m,
                                      table_at(&t, i, "I_Z") * m),
                     COIN_OK);
        coin_body b = {.s = {.theta = side * LAST_LEAN, .phi = 1, .wZ = w0 * w},
                       .vz = v0 * a * w};
        b.y = a * cos(b.s.theta);
        check_status(coin_body_contact(&b, &p, u), COIN_OK);
        check(u[0] == 0 && u[1] == 0 && u[2] == b.vz);
        check_status(coin_body_reaction(&b, &p, &f, &force), COIN_OK);
        check(force.normal == M * g);
        check_near(force.R[0], 0, 8 * U * M * g);
        check((force.R[2] < 0) == (v0 > 0));
        check_within(force.ratio, 0, mu * (1 + 8 * U));
        check_status(coin_move(&b, &p, &f, time / 3, 1e-6, 0, NULL),
                     COIN_SLIPS);
        check_status(coin_move(&b, &p, &f, time / 6, 1e-6, 0, NULL),
                     COIN_SLIPS);
        check_near(b.vz, table_at(&t, i, "v_half") * a * w, 1e-8 * S * a * w);
        check_near(b.s.wZ, table_at(&t, i, "w_half") * w, 1e-8 * S * w);
        check(b.s.phi == 1 && b.s.wX == 0 && b.s.wY == 0 && b.vy == 0);
        check_status(coin_move(&b, &p, &f, INFINITY, 1e-6, 0, &when),
                     COIN_RESTS);
        check_near(when, time / 2, 1e-8 * S / mu / w);
        check_near(b.s.z, table_at(&t, i, "distance") * a,
                   1e-8 * S * S / mu * a);
        check_near(b.s.psi, table_at(&t, i, "turn"), 1e-8 * S * S / mu);
    }
}

/* On ice nothing slows the centre while the coin falls over in contact; and a
 * coin that comes down flat does not stick by its rim where no slip begins. */
TEST(a_coin_that_lies_down_keeps_its_way_along_the_table)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table ice = {.mu_static = 0, .mu_kinetic = 0};
    const coin_table rough = {.mu_static = 1e6, .mu_kinetic = 0.3};
    const coin_table sticks = {.mu_static = INFINITY, .mu_kinetic = 0.3};
    coin_body falls = {.s = {.theta = 1.5}, .vx = 1};
    coin_body lands = {.s = {.theta = LAST_LEAN - 1e-8}, .vx = 1, .vy = -1e-6};
    falls.y = cos(falls.s.theta);
    lands.y = cos(lands.s.theta) + 1e-9;
    check_status(coin_move(&falls, &p, &ice, 2, 1e-9, 0, NULL), COIN_SLIPS);
    check(falls.s.theta == LAST_LEAN);
    check_near(falls.vx, 1, 1e-9);
    check_status(coin_move(&lands, &p, &rough, 0.01, 1e-9, 0, NULL),
                 COIN_SLIPS);
    check(lands.s.theta == LAST_LEAN);
    check_near(lands.vx, 1 - 0.01 * rough.mu_kinetic, 1e-4);
    check_status(coin_move(&lands, &p, &sticks, 0, 1e-9, 0, NULL), COIN_RESTS);
    check(lands.vx > 0.9);
    check_status(coin_move(&lands, &p, &sticks, 1, 1e-9, 0, NULL), COIN_RESTS);
    check(lands.vx == 0 && lands.vz == 0 && lands.s.wZ == 0);
}

TEST(a_face_that_slides_goes_on_to_its_range)
{
    const coin_params p = thrown_params(0.25, 0.5);
    coin_body on = {.s = {.theta = LAST_LEAN}, .y = cos(LAST_LEAN), .vx = 1};
    const coin_table ice = {.mu_static = 0, .mu_kinetic = 0};
    check_status(coin_move(&on, &p, &ice, 1e9 - 1, 1e-6, 0, NULL), COIN_SLIPS);
    check(on.s.x == 1e9 - 1 && on.vx == 1);
    check_status(coin_move(&on, &p, &ice, INFINITY, 1e-6, 0, NULL),
                 COIN_ERANGE);
    check(on.s.x == 1e9 - 1);
}

/* A body counts as touching up to 16 U of a radius above the table, and at a
 * normal speed up to 1e-10. */
TEST(a_coin_that_lies_is_on_the_table_once_it_slides)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_static = 0.4, .mu_kinetic = 0.3};
    coin_body b = {.s = {.theta = LAST_LEAN}, .vx = 1, .vy = 5e-11};
    b.y = cos(LAST_LEAN) + 8 * U;
    check_status(coin_move(&b, &p, &f, 0.1, 1e-6, 0, NULL), COIN_SLIPS);
    check_near(b.y, cos(LAST_LEAN), U / 64);
    check(b.vy == 0);
    b.y = cos(LAST_LEAN) + 8 * U;
    b.vy = 5e-11;
    check_status(coin_move(&b, &p, &f, 9, 1e-6, 0, NULL), COIN_RESTS);
    check_near(b.y, cos(LAST_LEAN), U / 64);
    check(b.vy == 0);
}

TEST(a_coin_that_an_impact_lays_flat_lies_on_the_table)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_static = 0.4, .mu_kinetic = 0.3};
    coin_body b = {.s = {.theta = acos(0.0) - 5e-7}, .vx = 0.5, .vy = -1e-6};
    b.y = cos(b.s.theta);
    check_status(coin_move(&b, &p, &f, 0.1, 1e-6, 0, NULL), COIN_SLIPS);
    check_near(b.y, cos(LAST_LEAN), U / 64);
    check_status(coin_move(&b, &p, &f, 0, 1e-6, 0, NULL), COIN_SLIPS);
}

/* In units that are no powers of two. */
TEST(a_returned_body_rolls_or_touches_to_the_bit)
{
    const coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.25};
    struct random r = random_begin(868);
    int rolls = 0, slips = 0;
    for (int i = 0; i < 300; ++i) {
        coin_params p;
        double v[3];
        check_status(coin_params_disc(&p, 5.67e-3, 12.13e-3, 9.80665), COIN_OK);
        coin_body b = {.s = {.theta = random_between(&r, -1, 1),
                             .phi = random_between(&r, -3, 3),
                             .wX = random_between(&r, -2, 2),
                             .wY = random_between(&r, -30, 30),
                             .wZ = random_between(&r, -30, 30)}};
        check_status(coin_body_from_state(&b, &b.s, &p), COIN_OK);
        const int32_t status = coin_move(&b, &p, &f, 1.0 / 60, 1e-6, 0, NULL);
        check_note("seed 868, coin %d", i);
        if (status != COIN_OK && status != COIN_SLIPS)
            continue;
        ++*(status == COIN_OK ? &rolls : &slips);
        check_status(coin_velocity(&b.s, &p, v), COIN_OK);
        check(b.vy == v[1]);
        check(status == COIN_SLIPS || (b.vx == v[0] && b.vz == v[2]));
    }
    check(rolls > 30 && slips > 30);
}

/* ----------------------------------------------------------------- lift-off */
/* What losses alone would lift stays in contact: no coin hops. */
TEST(no_coin_chatters)
{
    const int count = tries_asked(100);
    struct random r = random_begin(864);
    long lifts = 0;
    for (int i = 0; i < count; ++i) {
        const coin_params p = random_body(&r);
        coin_table f = random_table(&r, &p);
        coin_body b = random_throw(&r, 1, 40);
        f.restitution = 0;
        if (i % 2)
            f.mu_static = INFINITY;
        double t = 0, moved, unit = 0;
        int hops = 0;
        int32_t status = COIN_OK;
        check_note("seed 864, toss %d", i);
        while (t < 20 && !(status & COIN_RESTS)) {
            const int flies = status == COIN_LIFTS;
            status = coin_move(&b, &p, &f, 0.5, 1e-6,
                               flies ? COIN_TOUCHES : COIN_LIFTS, &moved);
            check(status >= 0);
            status = status & COIN_LIFTS ? COIN_LIFTS : status;
            t += moved;
            hops += !flies && status == COIN_LIFTS;
            lifts += !flies && status == COIN_LIFTS;
            if (t > unit + 1) {
                unit = t;
                hops = 0;
            }
            check(hops <= 10);
        }
    }
    check(lifts > 0);
}

/* ------------------------------------------------------------------- ranges */
TEST(a_flight_out_of_the_ranges_keeps_its_progress)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.restitution = 1};
    const struct {
        coin_body b;
        int32_t status;
    } starts[] = {
        {{.s = {.theta = 0.3}, .y = 2, .vy = 1e6}, COIN_ERANGE},
        {{.s = {.theta = 0.3, .x = 1e9 - 1}, .y = 2, .vx = 1e6}, COIN_ERANGE},
        {{.s = {.theta = 0.3, .z = 1 - 1e9}, .y = 2, .vz = -1e6}, COIN_ERANGE},
        /* the speed of the fall; wX, which becomes 1.3e6 */
        {{.s = {.theta = 0.3}, .y = 1e8, .vy = -1e6}, COIN_ERANGE},
        {{.s = {.theta = 0.3, .wX = 9e5, .wY = 9e5}, .y = 1e8}, COIN_ERANGE},
        /* wX, which the impact makes 1.8e6 sin(theta) 4/(1 + 4 sin^2 theta) */
        {{.s = {.theta = 0.5}, .y = cos(0.5), .vy = -9e5}, COIN_ERANGE},
    };
    for (size_t i = 0; i < sizeof starts / sizeof *starts; ++i) {
        coin_body b = starts[i].b;
        double moved = 1;
        check_note("start %zu", i);
        check_status(coin_move(&b, &p, &f, INFINITY, 1e-6, 0, &moved),
                     starts[i].status);
        check(moved == 0);
        check_same(&b, &starts[i].b, sizeof b);
    }
}

/* The angular momentum of a disc with I_X = 1/4. */
static void momentum(const coin_body *b, double L[3])
{
    double R[9];
    check_status(coin_angular_velocity(&b->s, L), COIN_OK);
    check_status(coin_axes(&b->s, R), COIN_OK);
    for (int i = 0; i < 3; ++i)
        L[i] = (L[i] + b->s.wZ * R[6 + i]) / 4;
}

/* It turns by 3e10 rad on its way down, about its angular momentum. */
TEST(a_fast_spin_lands_as_exactly_as_a_slow_one)
{
    double before[3], after[3];
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_static = 0.5, .mu_kinetic = 0.4};
    coin_body b = {.s = {.theta = 0.3, .wZ = 1e6, .wY = 1e5}, .y = 1e8};
    double moved;
    momentum(&b, before);
    check_status(coin_move(&b, &p, &f, INFINITY, 1e-6, COIN_TOUCHES, &moved),
                 COIN_LIFTS | COIN_TOUCHES);
    check_near(moved, sqrt(2e8), 1e-3);
    check_near(b.y, cos(b.s.theta), 4 * U);
    momentum(&b, after);
    for (int i = 0; i < 3; ++i)
        check_near(after[i], before[i], 16 * U * 1e6);
}

/* A turn of 1e-11 is rest: the call ends there, and says 0. */
TEST(what_is_left_of_a_turn_at_rest_is_0)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_kinetic = 0.3, .mu_static = 0.3};
    const coin_body turns = {.s = {.theta = LAST_LEAN, .wZ = 0.5},
                             .y = cos(LAST_LEAN)};
    const double whole = 1.25; /* wZ/(4 mu/3 g/a) */
    coin_body b = turns;
    check_status(coin_move(&b, &p, &f, whole * (1 - 2e-11), 1e-9, 0, NULL),
                 COIN_RESTS);
    check(b.s.wZ == 0 && b.vx == 0 && b.vz == 0);
    b = turns;
    check_status(coin_move(&b, &p, &f, whole * (1 - 2e-8), 1e-9, 0, NULL),
                 COIN_SLIPS);
    check_near(b.s.wZ, 1e-8, 1e-12);
}

/* Any body and table, heights to 1e8 radii, spins to 1e6; some lie flat in the
 * air. */
/* Its slip neither grows nor turns. */
TEST(an_upright_coin_slides_without_friction_and_is_silent)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_static = 0};
    for (double vx = 1e-9; vx < 2; vx *= 1000) {
        coin_body b = {.y = 1, .vx = vx};
        feclearexcept(FE_ALL_EXCEPT);
        check_status(coin_move(&b, &p, &f, 3, 1e-2, 0, NULL), COIN_SLIPS);
        check(!fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW));
        check(b.vx == vx);
        check_near(b.s.x, 3 * vx, 32 * U * vx);
    }
}

/* No contact is stopped without a loss, however slowly it rolls. */
TEST(an_upright_coin_rolls_on_without_losses)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_static = 0.5, .mu_kinetic = 0.4};
    const coin_state s = {.wZ = -1e-9};
    coin_body b;
    check_status(coin_body_from_state(&b, &s, &p), COIN_OK);
    check_status(coin_move(&b, &p, &f, 3, 1e-6, 0, NULL), COIN_OK);
    check_near(b.s.x, 3e-9, 64 * U * 1e-9);
}

/* Friction sets it rolling: a contact that does not roll yet is not stopped by
 * a loss that is weaker. */
TEST(a_coin_that_is_pushed_along_begins_to_roll)
{
    const coin_params p = thrown_params(0.25, 0.5);
    for (int i = 0; i < 4; ++i) {
        coin_table f = {.mu_static = 0.4, .mu_kinetic = 0.3};
        const coin_state s = {.theta = 0.4 * i};
        coin_body ideal, lossy;
        check_status(coin_body_from_state(&ideal, &s, &p), COIN_OK);
        ideal.vx = 1;
        lossy = ideal;
        check_note("lean %g", s.theta);
        check_status(coin_move(&ideal, &p, &f, 0.1, 1e-9, 0, NULL), COIN_SLIPS);
        f.losses.dry = 1e-4;
        check_status(coin_move(&lossy, &p, &f, 0.1, 1e-9, 0, NULL), COIN_SLIPS);
        check(fabs(ideal.s.wZ) > 1e-3);
        check_near(lossy.s.wZ, ideal.s.wZ, 1e-3);
    }
}

TEST(any_throw_is_silent_and_its_body_is_accepted)
{
    const int count = tries_asked(1000);
    struct random r = random_begin(865);
    int seen[COIN_RESTS + 1] = {0};
    for (int i = 0; i < count; ++i) {
        const double IX = pow(10, random_between(&r, -3, 3) * 0.999);
        const coin_params p =
            thrown_params(IX, IX * pow(10, random_between(&r, -2.99, 0.3)));
        coin_table f = random_table(&r, &p);
        const double high = pow(10, random_between(&r, -9, 8));
        const double spin = pow(10, random_between(&r, -9, 5.9));
        coin_body b = random_throw(&r, high, spin);
        const double t = pow(10, random_between(&r, -9, 1));
        if (i % 5 == 0)
            b.s.theta = copysign(LAST_LEAN, b.s.theta);
        if (i % 7 == 0)
            b.s.wX = b.s.wY = b.s.wZ = 0;
        if (i % 25 == 0) { /* flat, below the table by rounding */
            b.y = -1e-15;
            b.vy = 1e-8;
            b.s.wX = b.s.wY = 0;
        }
        if (i % 3 == 0)
            f.mu_static = INFINITY;
        if (i % 11 == 0)
            f.mu_kinetic = f.mu_static = 0;
        if (i % 2)
            memset(&f.losses, 0, sizeof f.losses);
        check_note("seed 865, throw %d", i);
        feclearexcept(FE_ALL_EXCEPT);
        errno = 0;
        for (int k = 0; k < 4; ++k) {
            const int32_t status = coin_move(&b, &p, &f, t, 1e-4, 0, NULL);
            check(status >= 0 || status == COIN_ERANGE);
            ++seen[status < 0 ? 0 : status & ~COIN_MORE];
            check(coin_body_energy(&b, &p) >= 0);
        }
        check(!fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW));
        check(errno == 0);
    }
    check(seen[COIN_LIFTS] > count && seen[COIN_SLIPS] > count / 50);
}

/* Its height is rounded by more than a coin may be below the table. */
TEST(a_fall_from_high_up_that_nearly_touches_is_accepted)
{
    struct random r = random_begin(41);
    const int count = tries_asked(200);
    for (int i = 0; i < count; ++i) {
        const coin_params p = thrown_params(0.25, 0.5);
        const coin_table f = {.mu_static = 0.3, .mu_kinetic = 0.3};
        const coin_body from = {.s = {.theta = random_between(&r, -1, 1)},
                                .y = pow(10, random_between(&r, 1, 6))};
        coin_body b = from;
        double touch;
        check_status(
            coin_move(&b, &p, &f, INFINITY, 1e-9, COIN_TOUCHES, &touch),
            COIN_LIFTS | COIN_TOUCHES);
        for (int k = 1; k <= 4; ++k) {
            b = from;
            check_note("fall %d", i);
            check(coin_move(&b, &p, &f, touch * (1 - k * U), 1e-9, COIN_TOUCHES,
                            NULL) >= COIN_OK);
            check_within(b.y - cos(b.s.theta), -U, INFINITY);
        }
    }
}

/* A thousandth within each range, and a thousandth beyond it: the top of the
 * flight, the place and the speed at its end, without a pull and with one, and
 * wX of a coin that turns. */
TEST(a_flight_goes_on_up_to_the_ranges)
{
    const coin_params p = thrown_params(0.25, 0.5);
    for (int side = -1; side <= 1; side += 2) {
        const double part = 1 + side * 1e-3, turn = part * 1e6 / sqrt(2);
        const struct {
            coin_body b;
            double t, pull[2];
        } starts[] = {
            {{.y = 2, .vy = sqrt(part * 2e9)}, 1e5, {0, 0}},
            {{.y = 1e4, .s.x = part * 1e9 - 1e7, .vx = 1e6}, 10, {0, 0}},
            {{.y = 1e4, .s.z = 1e7 - part * 1e9, .vz = -1e6}, 10, {0, 0}},
            {{.y = 1e9, .vy = 1 - 1e6}, part, {0, 0}},
            {{.y = 1e4, .s = {.wX = turn, .wY = turn}}, 10, {0, 0}},
            {{.y = 1e4, .vx = 999000}, part * 10, {100, 0}},
            {{.y = 1e4, .vz = -999000}, part * 10, {0, -100}},
        };
        for (size_t i = 0; i < sizeof starts / sizeof *starts; ++i) {
            const coin_table f = {
                .pull = {starts[i].pull[0], starts[i].pull[1]}};
            coin_body b = starts[i].b;
            check_note("start %zu, side %d", i, side);
            const int32_t status =
                coin_move(&b, &p, &f, starts[i].t, 1e-6, COIN_TOUCHES, NULL);
            if (side > 0)
                check_status(status, COIN_ERANGE);
            else
                check_status(status & ~COIN_TOUCHES, COIN_LIFTS);
        }
    }
}

/* A face that does not turn: mu M g against its velocity, whatever its
 * heading. */
TEST(friction_of_a_face_opposes_its_velocity)
{
    const coin_params p = thrown_params(0.25, 0.5);
    const coin_table f = {.mu_static = 0.4, .mu_kinetic = 0.3};
    const int count = tries_asked(50);
    struct random r = random_begin(868);
    for (int i = 0; i < count; ++i) {
        const double way = random_between(&r, -3, 3);
        const coin_body b = {
            .s = {.theta = LAST_LEAN, .phi = random_between(&r, -3, 3)},
            .y = cos(LAST_LEAN),
            .vx = 2 * cos(way),
            .vz = 2 * sin(way),
        };
        coin_force force;
        check_note("seed 868, slide %d", i);
        check_status(coin_body_reaction(&b, &p, &f, &force), COIN_OK);
        check(force.normal == 1);
        check_near(force.R[0], -0.3 * cos(way), 8 * U);
        check_near(force.R[2], -0.3 * sin(way), 8 * U);
    }
}
