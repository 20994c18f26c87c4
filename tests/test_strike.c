/* SPDX-License-Identifier: MIT */
/* A blow on a body: coin_body_strike(). */
#include "support/check.h"
#include "support/thrown.h"

#include <float.h>
#include <math.h>

#define PI 3.14159265358979323846
#define LAST_LEAN (1.5707963267948966 - 2.220446049250313e-16)

/* ------------------------------------------------------------ closed form */
static void cross(double out[3], const double a[3], const double b[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* The angular momentum about the centre, along the table's axes: I_X omega +
 * (I_Z - I_X) (omega.e_Z) e_Z. */
static void angular_momentum(double L[3], const coin_body *b,
                             const coin_params *p)
{
    double R[9], omega[3];
    check_status(coin_axes(&b->s, R), COIN_OK);
    check_status(coin_angular_velocity(&b->s, omega), COIN_OK);
    const double along = omega[0] * R[6] + omega[1] * R[7] + omega[2] * R[8];
    for (int i = 0; i < 3; ++i)
        L[i] = p->inertia_X * omega[i] +
               (p->inertia_Z - p->inertia_X) * along * R[6 + i];
}

static coin_params any_coin(struct random *r, int i)
{
    coin_params p = random_coin(r);
    if (i % 2)
        p.thickness = p.radius * random_between(r, 1e-3, 4);
    return p;
}

/* The pose stays; momentum grows by J, angular momentum by r x J. */
TEST(a_blow_adds_its_momentum_and_its_moment)
{
    struct random r = random_begin(801);
    const int count = tries_asked(1000);
    for (int i = 0; i < count; ++i) {
        const coin_params p = any_coin(&r, i);
        const double v = sqrt(p.gravity * p.radius);
        const coin_state s = random_state(&r, &p, 1.57);
        coin_body b = rolling(&s, &p);
        b.y += p.radius * random_between(&r, 0, 2);
        const coin_body before = b;
        double J[3], at[3], L[3], after[3], moment[3];
        for (int k = 0; k < 3; ++k) {
            J[k] = p.mass * v * random_between(&r, -3, 3);
            at[k] = p.radius * random_between(&r, -2, 2);
        }
        angular_momentum(L, &b, &p);
        check_status(coin_body_strike(&b, &p, J, at), COIN_OK);
        angular_momentum(after, &b, &p);
        cross(moment, at, J);
        check_near(b.vx, before.vx + J[0] / p.mass, 4 * U * 9 * v);
        check_near(b.vy, before.vy + J[1] / p.mass, 4 * U * 9 * v);
        check_near(b.vz, before.vz + J[2] / p.mass, 4 * U * 9 * v);
        for (int k = 0; k < 3; ++k) {
            const double size = p.mass * v * p.radius;
            check_near(after[k] - L[k], moment[k], 1e-14 * 20 * size);
        }
        b.s.wX = before.s.wX;
        b.s.wY = before.s.wY;
        b.s.wZ = before.s.wZ;
        b.vx = before.vx;
        b.vy = before.vy;
        b.vz = before.vz;
        check_same(&b, &before, sizeof b);
    }
}

TEST(a_blow_and_its_opposite_cancel)
{
    struct random r = random_begin(802);
    for (int i = 0; i < 100; ++i) {
        const coin_params p = random_cylinder(&r, 1e-2, 2);
        coin_body b = random_toss(&r, &p, 3, 3);
        const coin_body before = b;
        const double J[] = {0.3, -0.2, 0.5}, back[] = {-0.3, 0.2, -0.5};
        const double at[] = {0.2, random_between(&r, -1, 1), -0.7};
        check_status(coin_body_strike(&b, &p, J, at), COIN_OK);
        check(bodies_apart(&b, &before) > 0.1);
        check_status(coin_body_strike(&b, &p, back, at), COIN_OK);
        check_near(bodies_apart(&b, &before), 0, 64 * U);
    }
}

/* ------------------------------------------------------- a coin that lies */
/* A coin that lies, always in one place, with its axes at phi. */
static coin_body lying(const coin_params *p, double side, double phi)
{
    const coin_state s = {
        .theta = side * LAST_LEAN,
        .phi = remainder(phi, 2 * PI),
        .psi = remainder(side * phi, 2 * PI),
    };
    return rolling(&s, p);
}

/* What a body is whatever its axes: the matrix of its pose, its velocities. */
struct seen {
    double m[16], omega[3], v[3], energy;
};

static struct seen seen_of(const coin_body *b, const coin_params *p)
{
    struct seen r = {.v = {b->vx, b->vy, b->vz},
                     .energy = coin_body_energy(b, p)};
    check_status(coin_body_matrix(b, p, r.m), COIN_OK);
    check_status(coin_angular_velocity(&b->s, r.omega), COIN_OK);
    return r;
}

static double seen_apart(const struct seen *a, const struct seen *b)
{
    const size_t numbers = sizeof *a / sizeof(double);
    double most = 0;
    for (size_t i = 0; i < numbers; ++i)
        most =
            fmax(most, fabs(((const double *)a)[i] - ((const double *)b)[i]));
    return most;
}

static const double blows[][2][3] = {
    {{0, 2, 0}, {0, 0, 0.375}},        {{0, -1, 0}, {0.3, 0, 0.9}},
    {{0.2, 1, -0.4}, {0.9, 0, 0}},     {{0.5, 0, 0.1}, {0.2, 0, 0.4}},
    {{0.1, 0.3, 0}, {-0.6, 0.1, 0.6}},
};

/* It may be told with any heading: a strike has the same effect. */
TEST(a_lying_coin_has_no_heading_for_a_blow)
{
    for (int i = 0; i < 3 * 2 * 5 * 16; ++i) {
        const double half = (const double[]){0, 0.07, 0.5}[i % 3];
        const double side = i / 3 % 2 ? 1 : -1;
        const int blow = i / 6 % 5, heading = i / 30;
        coin_params p = thrown_params(0.25, 0.5);
        if (half > 0)
            p = cylinder(half);
        const coin_table f = {.mu_static = 0.33,
                              .mu_kinetic = 0.3,
                              .restitution = 0.4,
                              .losses = {.dry = 3e-3, .spin = 0.02}};
        coin_body a = lying(&p, side, 0);
        coin_body b = lying(&p, side, 2 * PI * heading / 16);
        check_note("half %g, side %g, blow %d, heading %d of 16", half, side,
                   blow, heading);
        for (int k = 0; k < 4; ++k) {
            static const double times[] = {0, 1e-9, 0.01, 0.3};
            if (k == 0) {
                check_status(
                    coin_body_strike(&a, &p, blows[blow][0], blows[blow][1]),
                    COIN_OK);
                check_status(
                    coin_body_strike(&b, &p, blows[blow][0], blows[blow][1]),
                    COIN_OK);
            }
            const int32_t status =
                coin_move(&a, &p, &f, times[k], 1e-12, 0, NULL);
            check_status(coin_move(&b, &p, &f, times[k], 1e-12, 0, NULL),
                         status);
            const struct seen x = seen_of(&a, &p), y = seen_of(&b, &p);
            check_near(seen_apart(&x, &y), 0, 1e-12);
        }
    }
}

/* From below through its centre: a flight without a turn. */
TEST(a_blow_from_below_throws_a_coin_up)
{
    const coin_params p = cylinder(0.07);
    const coin_table f = {.mu_static = 0.33, .mu_kinetic = 0.3};
    coin_body b = lying(&p, 1, 1);
    const double J[] = {0, 1, 0}, centre[] = {0, -0.07, 0};
    check_status(coin_body_strike(&b, &p, J, centre), COIN_OK);
    check_status(coin_move(&b, &p, &f, 0, 1e-9, 0, NULL), COIN_LIFTS);
    double t;
    check_status(coin_move(&b, &p, &f, INFINITY, 1e-9, COIN_TOUCHES, &t),
                 COIN_LIFTS | COIN_TOUCHES);
    check_near(t, 2, 1e-14);
    check_near(b.vy, -1, 1e-14);
}

/* Along the table through its centre: it slides v^2/(2 mu g), and turns if it
 * is struck aside. */
TEST(a_blow_from_the_side_makes_a_coin_slide)
{
    const coin_params p = cylinder(0.07);
    const coin_table f = {.mu_static = 0.33, .mu_kinetic = 0.3};
    const double J[] = {0.5, 0, 0}, centre[] = {0, 0, 0}, aside[] = {0, 0, 1};
    coin_body b = lying(&p, -1, 1), turns = b;
    double t;
    check_status(coin_body_strike(&b, &p, J, centre), COIN_OK);
    check_status(coin_move(&b, &p, &f, 0, 1e-9, 0, NULL), COIN_SLIPS);
    check_status(coin_move(&b, &p, &f, 99, 1e-9, 0, &t), COIN_RESTS);
    check_near(t, 0.5 / 0.3, 1e-9);
    check_near(b.s.x, 0.25 / 0.6, 1e-9);
    check_near(b.s.z, 0, 1e-12);
    check_status(coin_body_strike(&turns, &p, J, aside), COIN_OK);
    check_near(turns.s.wZ, 0.5 / 0.5, 1e-14); /* e_Z is up, r x J too */
    check_status(coin_move(&turns, &p, &f, 99, 1e-9, 0, &t), COIN_RESTS);
    check(t > 0.5 / 0.3 && turns.s.x > 0.25 / 0.6);
}

/* In SI units: a quarter that lies is flicked at its rim, from above.  The rim
 * hits the table at once; the coin flies, and comes to rest. */
TEST(a_flick_at_the_rim_of_a_quarter)
{
    const double M = 5.67e-3, a = 0.01213, g = 9.81;
    coin_params p;
    check_status(coin_params_cylinder(&p, M, a, 1.75e-3, g), COIN_OK);
    const coin_table f = {.mu_static = 0.3,
                          .mu_kinetic = 0.25,
                          .restitution = 0.5,
                          .losses = {.dry = 3e-3 * M * g * a,
                                     .spin = 0.02 * M * a * sqrt(g * a)}};
    const coin_state flat = {.theta = LAST_LEAN};
    coin_body b = rolling(&flat, &p);
    const double J[] = {0, -0.2 * M, 0}, rim[] = {0, p.thickness / 2, a};
    double v[3], height = 0, E, moved;
    int32_t status;
    check(coin_body_face(&b, &p) == COIN_TAILS);
    check_status(coin_body_strike(&b, &p, J, rim), COIN_OK);
    check_status(coin_body_contact(&b, &p, v), COIN_OK);
    /* v + omega x r of the rim that was struck: (1 + M a^2/I_X) J/M. */
    check_near(v[1], -0.2 * (1 + M * a * a / p.inertia_X), 1e-14);
    check_status(coin_move(&b, &p, &f, 0, 1e-9, 0, NULL), COIN_LIFTS);
    E = coin_body_energy(&b, &p);
    do {
        status = coin_move(&b, &p, &f, 1e-3, 1e-9, 0, &moved);
        check(status >= 0);
        check(coin_body_energy(&b, &p) <= E * (1 + 1e-9));
        E = coin_body_energy(&b, &p);
        height = fmax(height, b.y);
    } while (!(status & COIN_RESTS));
    check_within(height, a / 10, 2 * a);
    check_near(b.y, p.thickness / 2, 1e-9 * a);
}

/* On a table that holds it a blow may lift a coin, make it slip or roll on. */
TEST(a_rolling_coin_answers_a_blow)
{
    const coin_params p = cylinder(0.1);
    const coin_table f = {.mu_static = 0.5, .mu_kinetic = 0.5};
    const coin_state s = {.theta = 0.5, .wZ = 1};
    const double centre[] = {0, 0, 0};
    const double up[] = {0, 1, 0}, down[] = {0, -1, 0}, along[] = {1, 0, 0};
    coin_body b = rolling(&s, &p);
    check_status(coin_body_strike(&b, &p, up, centre), COIN_OK);
    check_status(coin_move(&b, &p, &f, 1e-3, 1e-9, 0, NULL), COIN_LIFTS);
    check(rim_gap(&b, &p) > 0);
    b = rolling(&s, &p);
    check_status(coin_body_strike(&b, &p, down, centre), COIN_OK);
    check_status(coin_move(&b, &p, &f, 0, 1e-9, 0, NULL), COIN_LIFTS);
    check(coin_move(&b, &p, &f, 1e-9, 1e-9, 0, NULL) != COIN_LIFTS);
    check_near(rim_gap(&b, &p), 0, 8 * U);
    b = rolling(&s, &p);
    check_status(coin_body_strike(&b, &p, along, centre), COIN_OK);
    check_status(coin_move(&b, &p, &f, 0, 1e-9, COIN_SLIPS, NULL), COIN_SLIPS);
    double moved;
    (void)coin_move(&b, &p, &f, 1e-2, 1e-9, COIN_SLIPS, &moved);
    check(moved == 1e-2); /* a slip that is there is no moment */
}

/* A face that is struck up leaves the table with a rim at rest. */
TEST(a_struck_face_does_not_stay_where_it_was)
{
    struct random r = random_begin(806);
    const int count = tries_asked(300);
    const double thick[] = {0, 0.144, 1, 2};
    for (int i = 0; i < count; ++i) {
        const coin_params p = cylinder(thick[i % 4] / 2);
        const coin_table f = {.mu_static = 0.4,
                              .mu_kinetic = 0.3,
                              .restitution = random_between(&r, 0, 0.1)};
        const coin_state lies = {.theta = i % 2 ? LAST_LEAN : -LAST_LEAN};
        const double J[] = {random_between(&r, -1, 1), 0,
                            random_between(&r, -1, 1)};
        const double at[] = {0, thick[i % 4] / 2 + 0.1, 0};
        coin_body b = rolling(&lies, &p);
        double left = 0.5, moved;
        int32_t status = COIN_OK;
        check_note("seed 806, blow %d", i);
        check_status(coin_body_strike(&b, &p, J, at), COIN_OK);
        for (int calls = 0; status != COIN_RESTS && left > 0; ++calls) {
            check(calls < 20);
            status = coin_move(&b, &p, &f, left, 1e-6, 0, &moved);
            check(status >= 0);
            left -= moved;
        }
    }
}

/* -------------------------------------------------------------- bad input */
TEST(a_bad_blow_is_refused_and_nothing_touched)
{
    static const double bad[] = {NAN,    INFINITY, -INFINITY, 1e300,
                                 -1e300, DBL_MAX,  1.1e6,     -1.1e6};
    const coin_params p = cylinder(0.1);
    const coin_state s = {.theta = 0.3};
    const coin_body good = rolling(&s, &p);
    const int count = (int)(sizeof bad / sizeof *bad);
    for (int i = 0; i < 6 * count; ++i) {
        double J[] = {1, 1, 1}, r[] = {1, -0.9, 0.8};
        coin_body b = good;
        (i < 3 * count ? J : r)[i % 3] = bad[i / 3 % count];
        check_note("%d: %g", i, bad[i / 3 % count]);
        check_status(coin_body_strike(&b, &p, J, r), COIN_ESTATE);
        check_same(&b, &good, sizeof b);
    }
    const double J[] = {1, 0, 0}, r[] = {0, 0, 0};
    coin_body b = good;
    coin_params none = p;
    none.mass = -1;
    check_status(coin_body_strike(NULL, &p, J, r), COIN_EARG);
    check_status(coin_body_strike(&b, NULL, J, r), COIN_EARG);
    check_status(coin_body_strike(&b, &p, NULL, r), COIN_EARG);
    check_status(coin_body_strike(&b, &p, J, NULL), COIN_EARG);
    check_status(coin_body_strike(&b, &none, J, r), COIN_EPARAMS);
    check_same(&b, &good, sizeof b);
    b.y = 0.5; /* below the table */
    const coin_body below = b;
    check_status(coin_body_strike(&b, &p, J, r), COIN_ESTATE);
    check_same(&b, &below, sizeof b);
}

/* Of a scene with a thickness and a pull, one number is anything. */
struct scene {
    coin_params p;
    coin_body b;
    coin_table f;
    double J[3], r[3], t, tol;
};

static struct scene spoilt(struct random *r)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY, 1e300, -1e300,
                                 -1,  0,        5e-324,    4.1,   1e-5};
    struct scene c = {.p = random_cylinder(r, 1e-3, 2), .t = 1e-2, .tol = 1e-6};
    c.b = random_toss(r, &c.p, 0.1, 3);
    c.f = random_table(r, &c.p);
    const size_t numbers = sizeof c / sizeof(double);
    for (int i = 0; i < 3; ++i) {
        c.f.pull[i % 2] = random_between(r, -2, 2);
        c.J[i] = random_between(r, -1, 1);
        c.r[i] = random_between(r, -1, 1);
    }
    ((double *)&c)[(size_t)random_between(r, 0, (double)numbers)] =
        bad[(int)random_between(r, 0, 10)];
    return c;
}

static void check_refused(int32_t status, const struct scene *c,
                          const struct scene *was)
{
    check(status >= 0 || status == COIN_EARG || status == COIN_EPARAMS ||
          status == COIN_ESTATE || status == COIN_ESTEP ||
          status == COIN_ERANGE);
    if (status < 0 && status != COIN_ERANGE)
        check_same(c, was, sizeof *c);
}

TEST(bad_numbers_are_refused_and_nothing_touched)
{
    struct random r = random_begin(803);
    const int count = tries_asked(10000);
    int refused[3] = {0};
    for (int i = 0; i < count; ++i) {
        struct scene c = spoilt(&r);
        const struct scene was = c;
        double reached = -7;
        const int32_t stop = (int32_t)random_between(&r, -99, 999);
        const int32_t face = coin_body_face(&c.b, &c.p);
        check_refused(face, &c, &was);
        const int32_t struck = coin_body_strike(&c.b, &c.p, c.J, c.r);
        check_refused(struck, &c, &was);
        c = was;
        const int32_t moved =
            coin_move(&c.b, &c.p, &c.f, c.t, c.tol, i % 2 ? 0 : stop, &reached);
        check_refused(moved, &c, &was);
        if (moved < 0 && moved != COIN_ERANGE)
            check(reached == -7);
        refused[0] += face < 0;
        refused[1] += struck < 0;
        refused[2] += moved < 0;
    }
    for (int i = 0; i < 3; ++i)
        check(refused[i] > count / 10 && refused[i] < count);
}

TEST(a_blow_may_lead_to_the_end_of_the_range)
{
    const coin_params p = cylinder(0.1);
    const coin_state s = {.theta = 0.3};
    coin_body b = rolling(&s, &p);
    const double J[] = {0.999e6, 0, 0}, more[] = {0.002e6, 0, 0};
    const double centre[] = {0, 0, 0};
    check_status(coin_body_strike(&b, &p, J, centre), COIN_OK);
    const coin_body fast = b;
    check_status(coin_body_strike(&b, &p, more, centre), COIN_ESTATE);
    check_same(&b, &fast, sizeof b);
}

/* The end is 1e6 a sqrt(g/a) for a velocity. */
TEST(the_end_of_the_range_of_a_blow_has_units)
{
    const coin_state s = {.theta = 0.3};
    const double centre[] = {0, 0, 0};
    for (double a = 1e-3; a < 2e3; a *= 1e3) {
        coin_params p;
        check_status(coin_params_cylinder(&p, 3, a, a / 10, 9), COIN_OK);
        const coin_body good = rolling(&s, &p);
        const double J = 3 * 1e6 * sqrt(9 * a);
        const double less[] = {0.999 * J, 0, 0}, more[] = {1.001 * J, 0, 0};
        coin_body b = good;
        check_status(coin_body_strike(&b, &p, more, centre), COIN_ESTATE);
        check_same(&b, &good, sizeof b);
        check_status(coin_body_strike(&b, &p, less, centre), COIN_OK);
        check_near(b.vx, 0.999 * J / 3, 4 * U * J / 3);
    }
}
