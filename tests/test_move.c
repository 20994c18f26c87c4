/* SPDX-License-Identifier: MIT */
/* The page on coin_move() in coin.h: touching, modes, stop, statuses. */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"
#include "support/slides.h"

#include <fenv.h>
#include <math.h>

static const double q0[4] = {1, 0, 0, 0}, zero3[3] = {0, 0, 0};
static const coin_table grip = {.mu_static = 0.55, .mu_kinetic = 0.5};

static coin_params quarter(void)
{
    coin_params p;
    check_status(coin_params_disc(&p, 0.00567, 0.01213, 9.80665), COIN_OK);
    return p;
}

/* 10 to a power between two. */
static double random_ten(struct random *r, double low, double high)
{
    return pow(10, random_between(r, low, high));
}

static coin_body rolling(const coin_params *p, const coin_state *s)
{
    coin_body b;
    check_status(coin_body_from_state(&b, s, p), COIN_OK);
    return b;
}

/* The mode that a call of no time tells. */
static int32_t mode(const coin_body *b, const coin_params *p)
{
    coin_body same = *b;
    double reached = 1;
    const int32_t status = coin_move(&same, p, &grip, 0, 1e-9, 0, &reached);
    check(reached == 0);
    check_same(&same, b, sizeof same);
    return status;
}

/* --------------------------------------------------------------- touching */
TEST(a_body_of_a_state_rolls_and_touches_exactly)
{
    struct random r = random_begin(801);
    for (int i = 0; i < 300; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.4);
        const coin_body b = rolling(&p, &s);
        double at[3], v[3], u[3], m[16], n[16];
        check_status(coin_center(&s, &p, at), COIN_OK);
        check_status(coin_velocity(&s, &p, v), COIN_OK);
        check(b.y == at[1]);
        check(b.vx == v[0] && b.vy == v[1] && b.vz == v[2]);
        check_same(&b.s, &s, sizeof s);
        check_status(coin_body_contact(&b, &p, u), COIN_OK);
        check_near(hypot(u[0], u[2]), 0,
                   8 * U * p.radius * (fabs(s.wX) + fabs(s.wZ)));
        check_near(coin_body_energy(&b, &p) / coin_energy(&s, &p), 1, 16 * U);
        check_status(coin_body_matrix(&b, &p, m), COIN_OK);
        check_status(coin_matrix(&s, &p, n), COIN_OK);
        check_same(m, n, sizeof m);
    }
}

TEST(the_matrix_of_a_body_has_the_height_of_its_centre)
{
    const coin_params p = quarter();
    const coin_state s = {.theta = 0.3, .x = 1, .z = 2};
    coin_body b = rolling(&p, &s);
    double m[16];
    b.y += 3 * p.radius;
    check_status(coin_body_matrix(&b, &p, m), COIN_OK);
    check(m[13] == b.y);
}

TEST(each_edge_of_touching_is_where_coin_h_says)
{
    const coin_params p = quarter();
    const double v0 = sqrt(p.gravity * p.radius), a = p.radius;
    const coin_state s = {.theta = 0.3, .wX = 1, .wY = 2, .wZ = 30};
    const coin_body b = rolling(&p, &s);
    /* a change of units rounds a height by 3 u */
    const double least = 1e-10 * v0 + 16 * U * a * (1 + 30);
    const struct {
        double y, vy, slip;
        int32_t want;
    } edges[] = {
        {12 * U * a, 0, 0, COIN_OK},
        {-12 * U * a, 0, 0, COIN_OK},
        {20 * U * a, 0, 0, COIN_LIFTS},
        {-20 * U * a, 0, 0, COIN_ESTATE},
        {0, 0.99e-10 * v0, 0, COIN_OK},
        {0, 1.01e-10 * v0, 0, COIN_LIFTS},
        {0, -0.99e-10 * v0, 0, COIN_OK},
        {0, -1.01e-10 * v0, 0, COIN_LIFTS}, /* an impact is due */
        {0, 0, 0.99 * least, COIN_OK},
        {0, 0, 1.01 * least, COIN_SLIPS},
    };
    for (size_t i = 0; i < sizeof edges / sizeof *edges; ++i) {
        coin_body at = b;
        at.y += edges[i].y;
        at.vy += edges[i].vy;
        at.vx += edges[i].slip;
        check_note("edge %zu", i);
        if (edges[i].want < 0)
            check_status(coin_move(&at, &p, &grip, 0, 1e-9, 0, NULL),
                         edges[i].want);
        else
            check_status(mode(&at, &p), edges[i].want);
    }
}

/* Every body that is returned is what the status says. */
TEST(every_body_that_returns_is_what_its_status_says)
{
    struct random r = random_begin(802);
    const int count = tries_asked(120);
    int said[COIN_RESTS + 1] = {0}, begins = 0;
    for (int i = 0; i < count; ++i) {
        const coin_params p = i % 2 ? disc() : ring(random_between(&r, 0, 1));
        const double mu = random_between(&r, 0.1, 0.7);
        coin_table f = {.mu_static = mu * (1 + i % 3 / 10.0), .mu_kinetic = mu};
        coin_body b = random_launch(&r, &p);
        const double dt = random_ten(&r, -2, 0);
        int32_t status = COIN_OK;
        if (i % 2)
            f.losses.dry = 1e-2;
        b = rolling(&p, &b.s);
        b.vx += i % 4 ? 0 : 0.5;
        for (int k = 0; k < 40 && status != COIN_RESTS; ++k) {
            double at[3], v[3], u[3];
            status = coin_move(&b, &p, &f, dt, random_ten(&r, -9, -2), 0, NULL);
            check(status >= 0);
            status &= ~COIN_MORE;
            ++said[status];
            check_status(coin_center(&b.s, &p, at), COIN_OK);
            check_status(coin_velocity(&b.s, &p, v), COIN_OK);
            check_status(coin_body_contact(&b, &p, u), COIN_OK);
            if (status == COIN_LIFTS) {
                check(b.y >= at[1] - 16 * U * p.radius);
                continue;
            }
            check(b.y == at[1]);
            if (status == COIN_RESTS)
                check(b.vx == 0 && b.vy == 0 && b.vz == 0 && b.s.wX == 0 &&
                      b.s.wY == 0 && b.s.wZ == 0);
            else
                check(b.vy == v[1]);
            if (status == COIN_OK)
                check(b.vx == v[0] && b.vz == v[2]);
            /* where a slip only begins, the members still roll */
            begins += status == COIN_SLIPS && hypot(u[0], u[2]) <= 1e-10;
            check_status(coin_move(&b, &p, &f, 0, 1e-6, 0, NULL), status);
        }
    }
    check(said[COIN_OK] > count && said[COIN_SLIPS] > count / 2);
    check(said[COIN_LIFTS] > 0 && said[COIN_RESTS] > 0);
    check(begins < said[COIN_SLIPS] / 100);
}

/* ------------------------------------------------------------ from engines */
TEST(a_body_of_an_engine_is_set_on_the_table_or_in_the_air)
{
    const coin_params p = disc();
    const struct {
        double y;
        int32_t want;
    } of[] = {{1.5, COIN_OK}, {1, COIN_OK},         {0.95, COIN_OK},
              {0.9, COIN_OK}, {0.899, COIN_ESTATE}, {NAN, COIN_ESTATE}};
    for (int i = 0; i < 6; ++i) {
        coin_body b;
        const double r[3] = {2, of[i].y, 3}, v[3] = {0.1, 0, 0.2};
        check_note("y %g", of[i].y);
        check_status(coin_body_from_motion(&b, &p, q0, zero3, r, v),
                     of[i].want);
        if (of[i].want != COIN_OK)
            continue;
        check(b.s.x == 2 && b.s.z == 3 && b.vx == 0.1 && b.vz == 0.2);
        check(b.y == fmax(of[i].y, 1));
        check_status(mode(&b, &p), of[i].y > 1 ? COIN_LIFTS : COIN_SLIPS);
    }
}

TEST(an_overlap_is_measured_in_radii)
{
    const coin_params p = quarter();
    const double low[3] = {0, 0.899 * p.radius, 0};
    coin_body b;
    check_status(coin_body_from_motion(&b, &p, q0, zero3, low, zero3),
                 COIN_ESTATE);
}

TEST(an_engines_motion_is_that_of_the_state)
{
    struct random r = random_begin(803);
    for (int i = 0; i < 100; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.4);
        const coin_body want = rolling(&p, &s);
        const double at[3] = {s.x, want.y, s.z};
        const double v[3] = {want.vx, want.vy, want.vz};
        double q[4], omega[3], w0 = sqrt(p.gravity / p.radius);
        coin_body got;
        check_status(coin_quaternion(&s, q), COIN_OK);
        check_status(coin_angular_velocity(&s, omega), COIN_OK);
        check_status(coin_body_from_motion(&got, &p, q, omega, at, v), COIN_OK);
        check_near(got.s.theta, s.theta, 1e-14);
        check_near(got.s.wX / w0, s.wX / w0, 1e-13 * (1 + fabs(s.wX / w0)));
        check_near(got.s.wZ / w0, s.wZ / w0, 1e-12 * (1 + fabs(s.wZ / w0)));
        check_near(got.y / p.radius, want.y / p.radius, 1e-14);
    }
}

/* A face that is horizontal: the start of a toss. */
TEST(a_horizontal_face_is_accepted)
{
    const coin_params p = disc();
    const double h = sqrt(0.5), up[3] = {0, 2, 0}, spin[3] = {1, 3, 2};
    const double faces[][4] = {
        {h, h, 0, 0}, {h, -h, 0, 0}, {0, 0, h, h}, {0.3, 0.3, 0.6, -0.6}};
    for (int i = 0; i < 4; ++i) {
        coin_body b;
        double R[9], omega[3];
        check_note("face %d", i);
        feclearexcept(FE_ALL_EXCEPT);
        check_status(coin_body_from_motion(&b, &p, faces[i], spin, up, zero3),
                     COIN_OK);
        check(!fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW));
        check(fabs(b.s.theta) >= 1.5707963267948963 && b.s.psi == 0);
        check(b.y == 2);
        check_status(coin_axes(&b.s, R), COIN_OK);
        const double *q = faces[i];
        const double n = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
        check_near(R[7], 2 * (q[2] * q[3] - q[0] * q[1]) / n, 1e-15);
        check_near(R[0],
                   (q[0] * q[0] + q[1] * q[1] - q[2] * q[2] - q[3] * q[3]) / n,
                   1e-15);
        check_near(R[2], 2 * (q[1] * q[3] - q[0] * q[2]) / n, 1e-15);
        check_status(coin_angular_velocity(&b.s, omega), COIN_OK);
        for (int k = 0; k < 3; ++k)
            check_near(omega[k], spin[k], 1e-14);
        check_status(mode(&b, &p), COIN_LIFTS);
    }
}

TEST(a_quaternion_of_any_length_is_the_same_rotation)
{
    const coin_params p = disc();
    const double lengths[] = {4e-8, 1e-3, 1e3, 3e7}, up[3] = {0, 2, 0};
    const coin_state leaning = {.theta = 1.4, .phi = 0.4, .psi = 0.7};
    const double turned = 0.6, h = sqrt(0.5);
    double q[2][4] = {
        {0},
        {h * cos(turned), h * cos(turned), h * sin(turned), -h * sin(turned)}};
    check_status(coin_quaternion(&leaning, q[0]), COIN_OK);
    for (int face = 0; face < 2; ++face) {
        coin_body want;
        check_status(
            coin_body_from_motion(&want, &p, q[face], zero3, up, zero3),
            COIN_OK);
        for (int i = 0; i < 4; ++i) {
            coin_body b;
            double long_q[4];
            for (int k = 0; k < 4; ++k)
                long_q[k] = lengths[i] * q[face][k];
            check_note("face %d, length %g", face, lengths[i]);
            check_status(
                coin_body_from_motion(&b, &p, long_q, zero3, up, zero3),
                COIN_OK);
            check_near(b.s.theta, want.s.theta, 1e-15);
            check_near(b.s.phi, want.s.phi, 1e-14);
            check_near(b.s.psi, want.s.psi, 1e-14);
        }
    }
}

TEST(what_is_no_rotation_or_no_place_is_refused)
{
    const coin_params p = disc();
    const double up[3] = {0, 2, 0}, none[4] = {0, 0, 0, 0};
    coin_body b;
    check_status(coin_body_from_motion(&b, &p, none, zero3, up, zero3),
                 COIN_ESTATE);
    check_status(coin_body_from_motion(&b, &p, q0, zero3, NULL, zero3),
                 COIN_EARG);
    check_status(coin_body_from_motion(&b, &p, q0, NULL, up, zero3), COIN_EARG);
    check_status(coin_body_from_motion(&b, &p, q0, zero3, up, NULL), COIN_EARG);
    check_status(coin_body_from_motion(&b, &p, NULL, zero3, up, zero3),
                 COIN_EARG);
    for (int i = 0; i < 4; ++i) { /* |q|^2 */
        const double sizes[4] = {0.9e-15, 1.1e-15, 0.9e15, 1.1e15};
        const double c = sqrt(sizes[i] / 2), face[4] = {c, c, 0, 0};
        check_status(coin_body_from_motion(&b, &p, face, zero3, up, zero3),
                     i == 1 || i == 2 ? COIN_OK : COIN_ESTATE);
    }
    const double flat[4] = {1, 1, 0, 0}, fast[3] = {0, 2e6, 0};
    const coin_params zero = {0};
    check_status(coin_body_from_motion(&b, &p, flat, fast, up, zero3),
                 COIN_ESTATE);
    check_status(coin_body_from_motion(&b, &zero, flat, zero3, up, zero3),
                 COIN_EPARAMS);
    check_status(coin_body_from_motion(&b, &zero, q0, zero3, up, zero3),
                 COIN_EPARAMS);
}

/* --------------------------------------------------------------------- stop */
/* The scene tumble: slips at 9.6549649113956, rolls again at
 * 11.754521766231. */
static coin_body tumble(const coin_params *p)
{
    const coin_state s = {.theta = 1e-3, .wZ = 0.3};
    return rolling(p, &s);
}

TEST(a_slip_and_its_end_are_found_by_stop)
{
    const coin_params p = disc();
    coin_body b = tumble(&p);
    double slips, rolls;
    check_status(coin_move(&b, &p, &grip, 20, 1e-12, COIN_SLIPS, &slips),
                 COIN_SLIPS);
    check_near(slips, 9.6549649113956, 1e-8);
    check_status(mode(&b, &p), COIN_SLIPS);
    check_status(coin_move(&b, &p, &grip, 20, 1e-12, COIN_ROLLS, &rolls),
                 COIN_ROLLS);
    check_near(slips + rolls, 11.754521766231, 1e-8);
    check_status(mode(&b, &p), COIN_OK);
}

TEST(a_stop_within_one_long_call_or_many_short_ones_is_the_same)
{
    const coin_params p = disc();
    for (double dt = 0.02; dt < 3; dt *= 3) {
        coin_body b = tumble(&p);
        double t = 0, moved;
        int32_t status = COIN_OK;
        while (status == COIN_OK) {
            status = coin_move(&b, &p, &grip, dt, 1e-11, COIN_SLIPS, &moved);
            t += moved;
        }
        check_status(status, COIN_SLIPS);
        check_near(t, 9.6549649113956, 1e-8);
    }
}

TEST(a_moment_is_told_with_the_mode_and_what_holds_is_none)
{
    const coin_params p = disc();
    const int32_t flat = COIN_NEARLY_FLAT;
    const coin_state leans = {.theta = 1.2};
    coin_body b = rolling(&p, &leans);
    double moved;
    check_status(coin_move(&b, &p, &grip, 10, 1e-11, flat, &moved) & flat,
                 flat);
    check_within(cos(b.s.theta), 0.01 - 1e-9, 0.01);
    check_status(coin_move(&b, &p, &grip, 1e-3, 1e-9, flat, &moved) & flat, 0);
    check(moved == 1e-3);
    coin_body slips = rolling(&p, &leans);
    slips.vx = 0.5;
    check_status(coin_move(&slips, &p, &grip, 1e-3, 1e-9, COIN_SLIPS, &moved),
                 COIN_SLIPS);
    check(moved == 1e-3);
}

TEST(a_lift_off_ends_the_call_once)
{
    const coin_params p = disc();
    struct random r = random_begin(804);
    const int count = tries_asked(120);
    int lifted = 0;
    for (int i = 0; i < count; ++i) {
        coin_body b = random_launch(&r, &p);
        coin_force force;
        double moved;
        b = rolling(&p, &b.s);
        if (coin_move(&b, &p, &grip, 9, 1e-10, COIN_LIFTS, &moved) !=
                COIN_LIFTS ||
            moved == 0)
            continue;
        ++lifted;
        check_status(coin_body_reaction(&b, &p, &grip, &force), COIN_OK);
        check(force.normal == 0 && force.friction == 0);
        const double E = coin_body_energy(&b, &p);
        check_status(mode(&b, &p), COIN_LIFTS);
        check_status(coin_move(&b, &p, &grip, 5, 1e-9,
                               COIN_LIFTS | COIN_TOUCHES, &moved),
                     COIN_LIFTS | COIN_TOUCHES);
        check(moved > 0 && coin_body_energy(&b, &p) <= E * (1 + 64 * U));
    }
    check_share(lifted, count, 0.21);
}

/* A disc that falls over from rest, where nothing slips: N comes to 0 at cos
 * theta = 1/2, though nothing lifts it.  It slips instead. */
TEST(where_rolling_needs_a_pull_a_coin_slips)
{
    const coin_params p = disc();
    const coin_table rough = {.mu_static = INFINITY, .mu_kinetic = 0.5};
    const coin_state up = {.theta = 1e-6};
    coin_body b = rolling(&p, &up);
    double moved;
    check_status(coin_move(&b, &p, &rough, 30, 1e-11, COIN_SLIPS, &moved),
                 COIN_SLIPS);
    check_near(cos(b.s.theta), 0.5, 1e-9);
    check_status(coin_move(&b, &p, &rough, 0.1, 1e-11, 0, &moved), COIN_SLIPS);
    check(moved == 0.1);
}

/* ----------------------------------------------------------------- at rest */
TEST(a_coin_that_rests_stays_there)
{
    const coin_params p = quarter();
    coin_table f = grip;
    coin_state s;
    coin_force force;
    double when, moved, u[3];
    check_status(coin_steady_spin(&s, &p, 1.2), COIN_OK);
    f.losses.dry = 1e-2 * p.mass * p.gravity * p.radius;
    coin_body b = rolling(&p, &s);
    check_status(coin_move(&b, &p, &f, INFINITY, 1e-9, 0, &when), COIN_RESTS);
    check(when > 0 && when < 10);
    check(fabs(b.s.theta) >= 1.5707963267948963);
    check(b.s.wX == 0 && b.s.wY == 0 && b.s.wZ == 0);
    check(b.vx == 0 && b.vy == 0 && b.vz == 0);
    const coin_body rests = b;
    check_status(coin_move(&b, &p, &f, 1, 1e-9, 0, &moved), COIN_RESTS);
    check(moved == 0);
    check_same(&b, &rests, sizeof b);
    check_status(coin_body_reaction(&b, &p, &f, &force), COIN_OK);
    check(force.R[0] == 0 && force.R[2] == 0 && force.friction == 0);
    check(force.R[1] == p.mass * p.gravity && force.ratio == 0);
    check_status(coin_body_contact(&b, &p, u), COIN_OK);
    check(u[0] == 0 && u[1] == 0 && u[2] == 0);
}

/* It falls without a spin that counts: 1e-12, below the 1e-10 of a rest. */
TEST(at_rest_not_even_a_rate_too_slow_to_count_is_left)
{
    const coin_params p = disc();
    const coin_table f = {
        .mu_static = INFINITY, .mu_kinetic = 0.3, .losses = {.flat = 1e-12}};
    const coin_state s = {.theta = 1.2, .wZ = 1e-12};
    coin_body b = rolling(&p, &s);
    check_status(coin_move(&b, &p, &f, INFINITY, 1e-9, 0, NULL), COIN_RESTS);
    check(b.s.wX == 0 && b.s.wY == 0 && b.s.wZ == 0);
    check(b.vx == 0 && b.vy == 0 && b.vz == 0);
}

/* What friction it needs is rounding. */
TEST(a_spin_does_not_slip_where_there_is_no_friction)
{
    const coin_params p = disc();
    const coin_table ice = {.mu_static = 0};
    for (int i = 1; i <= 300; ++i) {
        coin_state s;
        check_note("lean %g", i / 200.0);
        check_status(coin_steady_spin(&s, &p, i / 200.0), COIN_OK);
        coin_body b = rolling(&p, &s);
        check_status(coin_move(&b, &p, &ice, 0, 1e-9, COIN_SLIPS, NULL),
                     COIN_OK);
    }
}

TEST(in_the_air_there_is_no_force)
{
    const coin_params p = disc();
    const double up[3] = {0, 3, 0};
    coin_force force;
    coin_body b;
    double moved;
    check_status(coin_body_from_motion(&b, &p, q0, zero3, up, zero3), COIN_OK);
    check_status(coin_body_reaction(&b, &p, &grip, &force), COIN_OK);
    check(force.normal == 0 && force.friction == 0 && isinf(force.ratio));
    check_status(coin_move(&b, &p, &grip, 1, 1e-9, 0, &moved), COIN_LIFTS);
    check(moved == 1 && b.y == 2.5 && b.vy == -1);
    check_near(coin_body_energy(&b, &p), 3, 1e-15);
}

/* It rolls, and falls so fast that the table would have to pull. */
TEST(a_call_of_no_time_tells_that_a_coin_lifts_off)
{
    const coin_params p = disc();
    const coin_state s = {.theta = 0.3, .wX = 2};
    const coin_body b = rolling(&p, &s);
    check_status(mode(&b, &p), COIN_LIFTS);
}

/* The damping of a fast fall turns the rim up, from the table. */
TEST(angular_damping_may_lift_a_coin)
{
    const coin_params p = disc();
    const coin_table strong = {
        .mu_static = 0.55, .mu_kinetic = 0.5, .losses = {.angular = 100}};
    const coin_state s = {.theta = -0.5, .wX = 0.5};
    for (int slips = 0; slips < 2; ++slips) {
        coin_body b = rolling(&p, &s);
        coin_force force;
        b.vx += slips;
        check_note("slips %d", slips);
        check_status(coin_body_reaction(&b, &p, &strong, &force), COIN_OK);
        check(force.normal == 0 && force.friction == 0);
        const double energy = coin_body_energy(&b, &p);
        check_status(coin_move(&b, &p, &strong, 1e-3, 1e-9, 0, NULL),
                     COIN_LIFTS);
        check(b.y > cos(b.s.theta));
        check(coin_body_energy(&b, &p) < energy);
    }
}

static coin_body on_face(const coin_params *p, double vx, double vz, double wZ)
{
    coin_body b = {
        .s = {.theta = 0x1.921fb54442d17p+0, .wZ = wZ}, .vx = vx, .vz = vz};
    double at[3];
    check_status(coin_center(&b.s, p, at), COIN_OK);
    b.y = at[1];
    return b;
}

/* Friction acts against the velocity of the centre.  A face that only turns has
 * a torque alone. */
TEST(a_face_that_only_turns_feels_no_friction)
{
    const coin_params p = disc();
    coin_force force;
    coin_body b = on_face(&p, 0, 0, 3);
    check_status(coin_body_reaction(&b, &p, &grip, &force), COIN_OK);
    check(force.normal == 1 && force.friction == 0);
    b.vx = 1e6;
    check_status(coin_body_reaction(&b, &p, &grip, &force), COIN_OK);
    check_near(force.R[0], -grip.mu_kinetic, 1e-9);
    check_near(force.R[2], 0, 1e-15);
}

/* A face that turns fast slides with little friction, whichever its sense. */
TEST(the_sense_of_a_turn_does_not_change_the_friction)
{
    const coin_params p = disc();
    coin_force force[2];
    for (int i = 0; i < 2; ++i) {
        const coin_body b = on_face(&p, 1, 0, i == 0 ? 9 : -9);
        check_status(coin_body_reaction(&b, &p, &grip, &force[i]), COIN_OK);
    }
    check_within(force[0].friction, 0, 0.3 * grip.mu_kinetic);
    check(force[1].friction == force[0].friction);
}

/* ------------------------------------------------------------------ refused */
TEST(a_bad_table_is_refused)
{
    const coin_params p = disc();
    const coin_state s = {.theta = 0.3, .wZ = 1};
    const coin_body good = rolling(&p, &s);
    coin_table tables[] = {
        {.mu_static = NAN, .mu_kinetic = 0.1},
        {.mu_static = 0.3, .mu_kinetic = 0.4},
        {.mu_static = 0.3, .mu_kinetic = -0.1},
        {.mu_static = 2, .mu_kinetic = 1.12}, /* Painleve: 1.118 */
        {.mu_static = 1, .restitution = 1.01},
        {.mu_static = 1, .restitution = -0.1},
        {.mu_static = 1, .losses = {.damping = 1e-3}},
        {.mu_static = 1, .losses = {.dry = 2e3}},
        {.mu_static = 1, .losses = {.dry = 1e-13}},
        {.mu_static = 1, .losses = {.flat = 0.02}},
        {.mu_static = 1, .losses = {.flat = -1e-6}},
        {.mu_static = 1, .losses = {.reserved = {0, 1}}},
        {.mu_static = 1, .pull = {80, 80}},
        {.mu_static = 1, .pull = {NAN, 0}},
        {.mu_static = 1, .reserved = {0, 0, 1}},
    };
    for (size_t i = 0; i < sizeof tables / sizeof *tables; ++i) {
        coin_body b = good;
        double moved = 7;
        check_note("table %zu", i);
        check_status(coin_table_check(&tables[i], &p), COIN_EPARAMS);
        check_status(coin_move(&b, &p, &tables[i], 1, 1e-9, 0, &moved),
                     COIN_EPARAMS);
        check_same(&b, &good, sizeof b);
    }
}

TEST(a_bad_body_is_refused_and_not_touched)
{
    const coin_params p = disc();
    const coin_state s = {.theta = 0.3, .wZ = 1};
    const coin_body good = rolling(&p, &s);
    double moved = 7;
    coin_body bodies[9];
    for (int i = 0; i < 9; ++i)
        bodies[i] = good;
    bodies[0].y = NAN;
    bodies[1].y -= 1e-6;
    bodies[2].vx = 1e7;
    bodies[3].vz = NAN;
    bodies[4].s.x = 2e9;
    bodies[5].s.theta = 2;
    bodies[6].reserved[3] = 1;
    bodies[7].vy = INFINITY;
    bodies[8].y = 2e9;
    for (int i = 0; i < 9; ++i) {
        const coin_body before = bodies[i];
        check_note("body %d", i);
        check_status(coin_move(&bodies[i], &p, &grip, 1, 1e-9, 0, &moved),
                     COIN_ESTATE);
        check_same(&bodies[i], &before, sizeof before);
        check(isnan(coin_body_energy(&bodies[i], &p)));
    }
    check(moved == 7);
    check(isnan(coin_body_energy(&good, NULL)));
    check(isnan(coin_body_energy(NULL, &p)));
}

/* At the last lean a coin lies flat only if it does not turn over. */
TEST(the_last_lean_alone_is_not_flat)
{
    const coin_params p = disc();
    const double last = nextafter(asin(1), 0);
    const coin_state states[] = {{.theta = last, .wZ = 0.3},
                                 {.theta = last, .wZ = 0.3, .wX = 1e-3},
                                 {.theta = last, .wZ = 0.3, .wY = 1}};
    const double want[][3] = {{0.5, 0, 0}, {0.2, -2e-3, 0}, {0.5, -1, -0.3}};
    for (int i = 0; i < 3; ++i) {
        coin_body b = rolling(&p, &states[i]);
        double v[3];
        b.vx = 0.5;
        check_note("state %d", i);
        check_status(mode(&b, &p), i == 0 ? COIN_SLIPS : COIN_LIFTS);
        check_status(coin_body_contact(&b, &p, v), COIN_OK);
        for (int k = 0; k < 3; ++k)
            check_near(v[k], want[i][k], 1e-15);
    }
}

/* The table answers a coin that lies and is struck in the same way in each
 * description of its heading: the rim that goes down hits it. */
TEST(a_coin_that_lies_has_no_heading_of_its_own)
{
    const coin_params p = disc();
    const coin_table f = {
        .mu_static = 0.33, .mu_kinetic = 0.3, .restitution = 0.4};
    double first[2][4];
    for (int k = 0; k < 16; ++k) {
        const double side = k % 2 ? -1 : 1, phi = k * 0.4;
        coin_body b = {.s = {.theta = side * nextafter(asin(1), 0),
                             .phi = phi,
                             .psi = 1 + side * phi,
                             .wX = 3 * cos(phi),
                             .wY = side * 3 * sin(phi)},
                       .vy = 2};
        b.y = cos(b.s.theta);
        double w[3], q[4], moved, same = 0;
        check_note("heading %g", phi);
        check_status(coin_move(&b, &p, &f, 0, 1e-9, 0, NULL), COIN_LIFTS);
        check_status(coin_move(&b, &p, &f, 1e-9, 1e-9, COIN_TOUCHES, &moved),
                     COIN_LIFTS);
        check_status(coin_angular_velocity(&b.s, w), COIN_OK);
        check_status(coin_quaternion(&b.s, q), COIN_OK);
        check_near(w[0], 1.88, 4 * U); /* 3 - 1.4/5 4 */
        check_near(w[1], 0, 8 * U);
        check_near(w[2], 0, 8 * U);
        check_near(b.vy, 2.28 - 1e-9, 8 * U); /* 2 + 1.4/5 */
        for (int i = 0; i < 4; ++i) {
            first[k % 2][i] = k < 2 ? q[i] : first[k % 2][i];
            same += q[i] * first[k % 2][i];
        }
        check_near(fabs(same), 1, 8 * U);
    }
}

/* In any time it lies down; in none it stays as it is. */
TEST(a_coin_nearer_to_flat_than_flat_lies_down_in_time)
{
    const coin_params p = disc();
    const coin_state s = {.theta = acos(1e-7), .wZ = 1e-3};
    coin_body b = rolling(&p, &s), before = b;
    check_status(coin_move(&b, &p, &grip, 0, 1e-6, 0, NULL), COIN_OK);
    check_same(&b, &before, sizeof b);
    check_status(coin_move(&b, &p, &grip, 1e-9, 1e-6, 0, NULL), COIN_SLIPS);
    check(b.s.wX == 0 && b.s.wY == 0 && cos(b.s.theta) < 1e-15);
}

/* No point of it is lowest. */
TEST(a_coin_that_falls_flat_bounces_without_a_turn)
{
    const coin_params p = disc();
    const coin_table f = {
        .mu_static = 0.33, .mu_kinetic = 0.3, .restitution = 0.5};
    coin_body b = {.s = {.theta = -nextafter(asin(1), 0), .wZ = 2}, .vx = 1};
    b.y = 0.5 + cos(b.s.theta);
    double v[3];
    check_status(coin_move(&b, &p, &f, 9, 1e-9, COIN_TOUCHES, NULL),
                 COIN_LIFTS | COIN_TOUCHES);
    check_status(coin_body_contact(&b, &p, v), COIN_OK);
    check_near(v[1], -1, 8 * U);
    check_status(coin_move(&b, &p, &f, 0.5, 1e-9, COIN_TOUCHES, NULL),
                 COIN_LIFTS);
    check_near(b.vy, 0, 8 * U);
    check_near(b.y, 0.125, 8 * U);
    check(b.vx == 1 && b.s.wX == 0 && b.s.wY == 0 && b.s.wZ == 2);
}

/* The velocity of the centre is that of two rates. */
TEST(a_state_that_rolls_too_fast_for_a_body_is_refused)
{
    const coin_params p = disc();
    const coin_state s = {.phi = 2.4, .wX = 9e5, .wZ = 9e5};
    coin_body b = {.y = 7};
    const coin_body before = b;
    check_status(coin_state_check(&s, &p), COIN_OK);
    check_status(coin_body_from_state(&b, &s, &p), COIN_ESTATE);
    check_same(&b, &before, sizeof b);
}

TEST(a_bad_time_tolerance_or_stop_is_refused)
{
    const coin_params p = disc();
    const coin_state s = {.theta = 0.3, .wZ = 1};
    const coin_body good = rolling(&p, &s);
    double moved = 7;
    const struct {
        double t, tol;
        int32_t stop, want;
    } calls[] = {
        {-1, 1e-9, 0, COIN_ESTEP},         {NAN, 1e-9, 0, COIN_ESTEP},
        {1.1e15, 1e-9, 0, COIN_ESTEP},     {1, 1e-13, 0, COIN_EARG},
        {1, 0.02, 0, COIN_EARG},           {1, NAN, 0, COIN_EARG},
        {1, 1e-9, COIN_COARSE, COIN_EARG}, {1, 1e-9, COIN_RESTS, COIN_EARG},
        {1, 1e-9, 128, COIN_EARG},         {NAN, 1e-9, -1, COIN_EARG},
    };
    for (size_t i = 0; i < sizeof calls / sizeof *calls; ++i) {
        coin_body b = good;
        check_note("call %zu", i);
        check_status(coin_move(&b, &p, &grip, calls[i].t, calls[i].tol,
                               calls[i].stop, &moved),
                     calls[i].want);
        check_same(&b, &good, sizeof b);
    }
    check(moved == 7);
}

/* Nothing changes its slip. */
TEST(a_slide_without_friction_is_silent)
{
    const coin_params p = disc();
    const coin_table ice = {.mu_static = 0, .mu_kinetic = 0};
    coin_body b = {.s = {.wZ = 1e-4}, .y = 1, .vx = 0.5};
    feclearexcept(FE_ALL_EXCEPT);
    check_status(coin_move(&b, &p, &ice, 6, 1e-6, 0, NULL), COIN_SLIPS);
    check(!fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW));
    check(b.vx == 0.5 && b.s.wZ == 1e-4);
    check_near(b.s.x, 3, 1e-14);
}

TEST(damping_is_for_coin_settle)
{
    const coin_params p = disc();
    const coin_table f = {.mu_static = INFINITY, .losses = {.damping = 0.01}};
    check_status(coin_losses_check(&f.losses, &p), COIN_OK);
    check_status(coin_table_check(&f, &p), COIN_EPARAMS);
}

/* 2 sqrt(k (1 + k)): the disc's sqrt(5)/2, the hoop's sqrt(3). */
TEST(friction_beyond_the_bound_of_painleve_is_refused)
{
    const double inner[] = {0, 0.5, 1};
    const double bound[] = {1.1180339887498949, 1.2808688457449498,
                            1.7320508075688772};
    for (int i = 0; i < 3; ++i) {
        const coin_params p = ring(inner[i]);
        coin_table f = {.mu_static = INFINITY,
                        .mu_kinetic = bound[i] * (1 - 1e-14)};
        check_status(coin_table_check(&f, &p), COIN_OK);
        f.mu_kinetic = bound[i] * (1 + 1e-14);
        check_status(coin_table_check(&f, &p), COIN_EPARAMS);
    }
}

/* phi, psi, x and z end where their ranges do, and the progress is kept. */
TEST(at_the_end_of_a_range_the_progress_is_kept)
{
    const coin_params p = disc();
    const coin_table f = {.mu_static = INFINITY};
    coin_state starts[4];
    for (int i = 0; i < 4; ++i)
        starts[i] = (coin_state){.theta = 0, .wY = i ? 0 : 5, .wZ = i ? -5 : 0};
    starts[0].phi = starts[1].psi = 2147483648.0 - 20;
    starts[1].wZ = 5;
    starts[2].x = 1e9 - 20;
    starts[3].z = -1e9 + 20;
    starts[3].phi = 1.5707963267948966;
    for (int i = 0; i < 4; ++i) {
        coin_body b = rolling(&p, &starts[i]);
        double moved = 0;
        check_note("range %d", i);
        check_status(coin_move(&b, &p, &f, 100, 1e-9, 0, &moved), COIN_ERANGE);
        check_within(moved, 2.5, 4.001);
        check_status(coin_move(&b, &p, &f, 0, 1e-9, 0, NULL), COIN_OK);
    }
}

/* Nothing stops a face on ice: it slides, or turns, out of range. */
TEST(a_face_on_ice_ends_at_its_range)
{
    const coin_params p = disc();
    const coin_table ice = {.mu_static = 0};
    for (int i = 0; i < 3; ++i) {
        coin_body b = on_face(&p, i == 1, i == 2, i == 0);
        double moved = 1;
        check_note("range %d", i);
        const coin_body before = b;
        check_status(coin_move(&b, &p, &ice, 1e10, 1e-9, 0, &moved),
                     COIN_ERANGE);
        check(moved == 0);
        check_same(&b, &before, sizeof b);
    }
}

/* A disc that needs more steps than a call has. */
TEST(a_call_is_bounded_and_the_next_goes_on)
{
    const coin_params p = disc();
    const coin_table f = {.mu_static = INFINITY};
    coin_state s;
    double moved = 0;
    check_status(coin_steady_roll(&s, &p, 2), COIN_OK);
    s.theta = 0.1;
    coin_body b = rolling(&p, &s);
    check_status(coin_move(&b, &p, &f, 1e9, 1e-9, 0, &moved), COIN_MORE);
    check(moved > 1000);
    check_near(coin_body_energy(&b, &p), coin_energy(&s, &p), 1e-9);
    check_status(coin_move(&b, &p, &f, 1, 1e-9, 0, &moved), COIN_OK);
    check(moved == 1);
}
