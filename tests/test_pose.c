/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/difference.h"
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

static const struct observable all[] = {
    {centre, centre_terms, 4, {"y"}},
    {velocity, velocity_terms, 8, {"vx", "vy", "vz"}},
    {contact, contact_terms, 8, {"xc", "zc", "vxc", "vzc"}},
    {axes,
     ones,
     4,
     {"eXx", "eXy", "eXz", "eYx", "eYy", "eYz", "eZx", "eZy", "eZz"}},
    {quaternion, ones, 4, {"q0", "q1", "q2", "q3"}},
    {turning, turning_terms, 8, {"ox", "oy", "oz"}},
};

TEST(the_pose_is_the_reference_s)
{
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i)
        observable_at_exact_states(&all[i]);
}

TEST(contact_and_quaternion_follow_the_reference_paths)
{
    observable_along_scenes(&all[2]);
    observable_along_scenes(&all[4]);
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

static void members_of_pose(const coin_state *s, const coin_params *p,
                            double *out)
{
    double r[3], v[3];
    check_status(coin_center(s, p, out), COIN_OK);
    check_status(coin_contact(s, p, r, v), COIN_OK);
    for (int i = 0; i < 3; ++i)
        out[3 + i] = r[i];
}

TEST(centre_and_contact_move_with_their_velocities)
{
    struct random r = random_begin(19);
    for (int n = 0; n < 20; ++n) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1);
        const double unit = p.radius / natural_time(&p);
        double want[OBSERVABLE_MAX], v[3], at[3], vc[3];
        difference_along(&s, &p, members_of_pose, 6, want);
        check_status(coin_velocity(&s, &p, v), COIN_OK);
        check_status(coin_contact(&s, &p, at, vc), COIN_OK);
        for (int i = 0; i < 3; ++i) {
            check_near(v[i], want[i], DIFFERENCE_BOUND * unit);
            check_near(vc[i], want[3 + i], DIFFERENCE_BOUND * unit);
        }
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
