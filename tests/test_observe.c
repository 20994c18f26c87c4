/* SPDX-License-Identifier: MIT */
/* What can be read off a state, but for its rates and integrals. */
#include "support/check.h"
#include "support/coins.h"
#include "support/observable.h"
#include "support/random.h"

#include <math.h>

static void cross(const double u[3], const double v[3], double out[3])
{
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = u[j] * v[k] - u[k] * v[j];
    }
}

static double dot(const double u[3], const double v[3])
{
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

/* ------------------------------------------------- against the references */
static void centre(const coin_state *s, const coin_params *p, double *out)
{
    double r[3];
    check_status(coin_center(s, p, r), COIN_OK);
    check(r[0] == s->x && r[2] == s->z);
    out[0] = r[1];
}

static void centre_terms(const coin_state *s, const coin_params *p, double *out)
{
    out[0] = p->radius * cos(s->theta);
}

static void velocity(const coin_state *s, const coin_params *p, double *out)
{
    check_status(coin_velocity(s, p, out), COIN_OK);
}

static void velocity_terms(const coin_state *s, const coin_params *p,
                           double *out)
{
    const struct parts r = parts_of(s, p);
    out[0] = r.a * (r.wZ * r.cph + r.wX * r.cth * r.sph);
    out[1] = r.a * r.wX * r.sth;
    out[2] = r.a * (r.wZ * r.sph + r.wX * r.cth * r.cph);
}

static void contact(const coin_state *s, const coin_params *p, double *out)
{
    double r[3], v[3];
    check_status(coin_contact(s, p, r, v), COIN_OK);
    check(r[1] == 0 && v[1] == 0);
    out[0] = r[0];
    out[1] = r[2];
    out[2] = v[0];
    out[3] = v[2];
}

static void contact_terms(const coin_state *s, const coin_params *p,
                          double *out)
{
    const struct parts r = parts_of(s, p);
    const double dpsi = r.wZ + r.wY * r.tth;
    out[0] = fabs(s->x) + r.a * r.sth * r.sph;
    out[1] = fabs(s->z) + r.a * r.sth * r.cph;
    out[2] = r.a * dpsi * r.cph;
    out[3] = r.a * dpsi * r.sph;
}

static void axes(const coin_state *s, const coin_params *p, double *out)
{
    (void)p;
    check_status(coin_axes(s, out), COIN_OK);
}

static void quaternion(const coin_state *s, const coin_params *p, double *out)
{
    (void)p;
    check_status(coin_quaternion(s, out), COIN_OK);
}

static void ones(const coin_state *s, const coin_params *p, double *out)
{
    (void)s, (void)p;
    for (int i = 0; i < OBSERVABLE_MAX; ++i)
        out[i] = 1;
}

static void turning(const coin_state *s, const coin_params *p, double *out)
{
    (void)p;
    check_status(coin_angular_velocity(s, out), COIN_OK);
}

static void turning_terms(const coin_state *s, const coin_params *p,
                          double *out)
{
    const struct parts r = parts_of(s, p);
    out[0] = r.wX * r.cph + (r.wY * r.sth + r.wZ * r.cth) * r.sph;
    out[1] = r.wY * r.cth + r.wZ * r.sth;
    out[2] = r.wX * r.sph + (r.wY * r.sth + r.wZ * r.cth) * r.cph;
}

static void energy(const coin_state *s, const coin_params *p, double *out)
{
    out[0] = coin_energy(s, p);
}

/* Of the source's form: 1/2 M v^2, the turning, and M g a cos theta. */
static void energy_terms(const coin_state *s, const coin_params *p, double *out)
{
    const struct parts r = parts_of(s, p);
    const double moving = r.m * (r.wX * r.wX + r.wZ * r.wZ);
    const double turning =
        r.IX * (r.wX * r.wX + r.wY * r.wY) + r.IZ * r.wZ * r.wZ;
    out[0] = (moving + turning) / 2 + r.M * r.g * r.a * r.cth;
}

static void rate(const coin_state *s, const coin_params *p, double *out)
{
    out[0] = coin_fastest_rate(s, p);
}

/* All rate_terms of W^2 are positive: W itself is their size. */
static void rate_terms(const coin_state *s, const coin_params *p, double *out)
{
    const struct parts r = parts_of(s, p);
    const double turn = hypot(hypot(r.wX, r.wY) / r.cth, r.wZ);
    out[0] = hypot(turn, sqrt(r.g / (r.a * r.cth)));
}

static coin_force force_on(const coin_state *s, const coin_params *p)
{
    coin_force f;
    check_status(coin_reaction(s, p, &f), COIN_OK);
    return f;
}

static void force(const coin_state *s, const coin_params *p, double *out)
{
    const coin_force f = force_on(s, p);
    for (int i = 0; i < 3; ++i)
        out[i] = f.R[i];
    out[3] = f.friction;
}

static void force_terms(const coin_state *s, const coin_params *p, double *out)
{
    const struct parts r = parts_of(s, p);
    const double Ma = r.M * r.a;
    const double RX = Ma * r.wX * r.wY * r.IZ / r.K;
    const double Rh =
        Ma * (r.wX * r.wX * r.sth + r.dwX * r.cth + r.wY * r.wZ / r.cth);
    out[0] = RX * r.cph + Rh * r.sph;
    out[1] = r.M * r.g + Ma * (r.wX * r.wX * r.cth + r.dwX * r.sth);
    out[2] = RX * r.sph + Rh * r.cph;
    out[3] = hypot(RX, Rh);
}

/* The last four are in the files of scenes too. */
static const struct observable all[] = {
    {centre, centre_terms, 4, {"y"}},
    {velocity, velocity_terms, 8, {"vx", "vy", "vz"}},
    {axes,
     ones,
     4,
     {"eXx", "eXy", "eXz", "eYx", "eYy", "eYz", "eZx", "eZy", "eZz"}},
    {turning, turning_terms, 8, {"ox", "oy", "oz"}},
    {rate, rate_terms, 4, {"W"}},
    {contact, contact_terms, 8, {"xc", "zc", "vxc", "vzc"}},
    {quaternion, ones, 4, {"q0", "q1", "q2", "q3"}},
    {energy, energy_terms, 8, {"E"}},
    {force, force_terms, 8, {"Rx", "Ry", "Rz", "F"}},
};
enum { ALL = sizeof all / sizeof *all, IN_SCENES = 4 };

TEST(they_are_the_reference_s)
{
    for (int i = 0; i < ALL; ++i)
        observable_at_exact_states(&all[i]);
}

TEST(they_follow_the_reference_paths)
{
    for (int i = ALL - IN_SCENES; i < ALL; ++i)
        observable_along_scenes(&all[i]);
}

/* ------------------------------------------------------ among one another */
/* Rotates by a unit quaternion: v + 2 r x (r x v + w v). */
static void turn(const double q[4], const double v[3], double out[3])
{
    double inner[3], outer[3];
    cross(q + 1, v, inner);
    for (int i = 0; i < 3; ++i)
        inner[i] += q[0] * v[i];
    cross(q + 1, inner, outer);
    for (int i = 0; i < 3; ++i)
        out[i] = v[i] + 2 * outer[i];
}

TEST(the_quaternion_turns_the_body_into_the_rolled_axes)
{
    static const double X[3] = {1, 0, 0}, Z[3] = {0, 0, 1};
    struct random r = random_begin(16);
    for (int n = 0; n < 500; ++n) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.57);
        double q[4], R[9], x[3], z[3];
        check_status(coin_quaternion(&s, q), COIN_OK);
        check_status(coin_axes(&s, R), COIN_OK);
        turn(q, X, x);
        turn(q, Z, z);
        /* q, 4 u in each of four, enters squared: 2 sqrt(4) 4 u, and the
         * arithmetic here. */
        for (int i = 0; i < 3; ++i) {
            const double rolled = cos(s.psi) * R[i] + sin(s.psi) * R[3 + i];
            check_near(x[i], rolled, 24 * U);
            check_near(z[i], R[6 + i], 24 * U);
        }
    }
}

TEST(a_full_turn_changes_the_quaternion_s_sign)
{
    coin_state s = {0.4, 0.3, -2, 0, 0, 0, 0, 0};
    double q[4], turned[4];
    check_status(coin_quaternion(&s, q), COIN_OK);
    s.psi += 6.283185307179586;
    check_status(coin_quaternion(&s, turned), COIN_OK);
    /* psi + 2 pi is rounded by up to 4 u, which counts half. */
    for (int i = 0; i < 4; ++i)
        check_near(turned[i], -q[i], (4 + 4 + 2 + 2) * U);
}

TEST(the_material_at_the_contact_is_at_rest)
{
    struct random r = random_begin(18);
    for (int n = 0; n < 500; ++n) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.5);
        double v[3], omega[3], R[9], at[3], vc[3], centre_[3], arm[3], slip[3];
        check_status(coin_velocity(&s, &p, v), COIN_OK);
        check_status(coin_angular_velocity(&s, omega), COIN_OK);
        check_status(coin_axes(&s, R), COIN_OK);
        check_status(coin_contact(&s, &p, at, vc), COIN_OK);
        check_status(coin_center(&s, &p, centre_), COIN_OK);
        for (int i = 0; i < 3; ++i) {
            arm[i] = -p.radius * R[3 + i];
            /* The contact point lies a down the slope from the centre. */
            check_near(at[i], centre_[i] + arm[i],
                       8 * U * (fabs(centre_[i]) + p.radius));
        }
        cross(omega, arm, slip);
        const double speed = p.radius * sqrt(dot(omega, omega));
        for (int i = 0; i < 3; ++i)
            check_near(v[i] + slip[i], 0, 40 * U * speed);
    }
}

static void check_axes(const coin_state *s, const double want[9])
{
    double R[9];
    check_status(coin_axes(s, R), COIN_OK);
    for (int i = 0; i < 9; ++i)
        check_near(R[i], want[i], 8 * U);
}

/* Poses that can be told by eye.  h is the sine of 60 degrees. */
TEST(the_frame_is_the_header_s)
{
    const double h = sqrt(3) / 2;
    const double unit[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const double leaning[] = {1, 0, 0, 0, 0.5, h, 0, -h, 0.5};
    const double turned[] = {0, 0, -1, 0, 1, 0, 1, 0, 0};
    const coin_state upright = {0};
    const coin_state leans = {acos(0.5), 0, 0, 0, 0, 0, 0, 0};
    const coin_state turns = {0, asin(1), 0, 0, 0, 0, 0, 0};
    check_axes(&upright, unit);
    check_axes(&leans, leaning);
    check_axes(&turns, turned);
}

/* ------------------------------------------------------------------- energy */
/* 1/2 M v^2 from the velocity that coin_velocity() gives. */
static double kinetic(const coin_state *s, const coin_params *p)
{
    double v[3];
    check_status(coin_velocity(s, p, v), COIN_OK);
    const double v2 = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    const double turning = p->inertia_X * (s->wX * s->wX + s->wY * s->wY) +
                           p->inertia_Z * s->wZ * s->wZ;
    return (p->mass * v2 + turning) / 2;
}

TEST(energy_is_that_of_moving_turning_and_standing_high)
{
    struct random r = random_begin(1);
    for (int i = 0; i < 200; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.5);
        double centre[3];
        check_status(coin_center(&s, &p, centre), COIN_OK);
        const double height = p.mass * p.gravity * centre[1];
        /* 8 u each for the energy and for v, which enters squared. */
        const double E = coin_energy(&s, &p);
        double size;
        energy_terms(&s, &p, &size);
        check_near(E, kinetic(&s, &p) + height, 24 * U * size);
    }
}

TEST(an_upright_coin_at_rest_has_m_g_a)
{
    coin_params p;
    const coin_state rest = {0, 1, 2, 3, 4, 0, 0, 0};
    check_status(coin_params_disc(&p, 2, 4, 8), COIN_OK);
    check(coin_energy(&rest, &p) == 2 * 4 * 8);
}

/* -------------------------------------------------------------- fastest rate
 */
/* What coin.h says of COIN_COARSE holds for the W that this function gives. */
TEST(steps_are_coarse_beyond_the_limits_over_it)
{
    static const double limits[] = {0.35, 1, 0.08, 0.16};
    struct random r = random_begin(31);
    for (int i = 0; i < 400; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.5);
        const double dt = (i & 4 ? -limits[i % 4] : limits[i % 4]) /
                          coin_fastest_rate(&s, &p);
        const double mu = INFINITY;
        check((coin_check(&s, &p, i % 4, dt * (1 - 8 * U), mu) & COIN_COARSE) ==
              0);
        check(coin_check(&s, &p, i % 4, dt * (1 + 8 * U), mu) & COIN_COARSE);
    }
}

/* Straight rolling at wZ: sqrt(wZ^2 + g/a). */
TEST(it_is_known_of_an_upright_coin)
{
    coin_params p;
    const coin_state s = {0, 1, 2, 3, 4, 0, 0, 4};
    check_status(coin_params_disc(&p, 7, 0.5, 4.5), COIN_OK);
    check(coin_fastest_rate(&s, &p) == 5);
}

/* -------------------------------------------------------------------- force */
TEST(the_parts_of_a_force_belong_together)
{
    struct random r = random_begin(10);
    for (int i = 0; i < 500; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.5);
        const coin_force f = force_on(&s, &p);
        double size[OBSERVABLE_MAX];
        force_terms(&s, &p, size);
        check(f.normal == f.R[1]);
        check_near(f.friction, hypot(f.R[0], f.R[2]), 24 * U * size[3]);
        if (f.normal > 0)
            check_near(f.ratio, f.friction / f.normal, 2 * U * f.ratio);
        else
            check(f.ratio == INFINITY);
    }
}

/* Upright and falling at sqrt(g/a), nothing holds the coin down: N and F are 0
 * to the bit, and no friction is enough. */
TEST(a_coin_that_does_not_press_needs_infinite_friction)
{
    const coin_params p = disc();
    const coin_state s = {0, 0.3, 0, 0, 0, 1, 0, 0};
    const coin_force f = force_on(&s, &p);
    check(f.normal == 0 && f.friction == 0);
    check(f.ratio == (double)INFINITY);
}

/* The squares in sqrt(R_x^2 + R_z^2) must not leave the range of doubles where
 * the force does not. */
TEST(friction_scales_with_any_mass)
{
    const coin_state s = {0.5, 0.7, 0, 0, 0, 0.1, 0.8, 1.2};
    const double masses[] = {0x1p-49, 0x1p49};
    coin_params one, p;
    check_status(coin_params_disc(&one, 1, 1, 1), COIN_OK);
    const coin_force want = force_on(&s, &one);
    for (int i = 0; i < 2; ++i) {
        check_status(coin_params_disc(&p, masses[i], 1, 1), COIN_OK);
        const coin_force f = force_on(&s, &p);
        check_note("mass %g", masses[i]);
        check_near(f.friction / masses[i], want.friction, 8 * U);
        check_near(f.ratio, want.ratio, 8 * U);
    }
}
