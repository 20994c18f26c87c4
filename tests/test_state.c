/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/random.h"
#include "support/table.h"

#include <math.h>
#include <string.h>

/* ------------------------------------------------------ the state check -- */
/* What passes the check gives finite numbers everywhere. */
TEST(no_accepted_state_overflows)
{
    struct random r = random_begin(20);
    unsigned accepted = 0;
    for (int i = 0; i < 2000; ++i) {
        const coin_params p = random_coin(&r);
        coin_state s = random_state(&r, &p, 1), rates;
        coin_force f;
        double K[2];
        const double size = pow(10, random_between(&r, 0, 7));
        s.theta = nextafter(1.5707963267948966, 0);
        s.wX *= size;
        s.wY *= size;
        s.wZ *= size;
        if (coin_state_check(&s, &p) != COIN_OK)
            continue;
        ++accepted;
        check(isfinite(coin_energy(&s, &p)));
        check_status(coin_rates(&s, &p, &rates), COIN_OK);
        check(isfinite(rates.phi) && isfinite(rates.psi));
        check(isfinite(rates.wX) && isfinite(rates.wY));
        check_status(coin_reaction(&s, &p, &f), COIN_OK);
        check(isfinite(f.normal) && isfinite(f.friction));
        check_status(coin_integrals(&s, &p, K), COIN_OK);
        check(isfinite(K[0]) && isfinite(K[1]));
    }
    check_within(accepted, 500, 1990);
}

/* ------------------------------------------------- a state out of a motion */
static void from_row(const struct table *t, size_t row, coin_state *got)
{
    const coin_params p = disc();
    const double q[] = {table_at(t, row, "w"), table_at(t, row, "qx"),
                        table_at(t, row, "qy"), table_at(t, row, "qz")};
    const double omega[] = {table_at(t, row, "ox"), table_at(t, row, "oy"),
                            table_at(t, row, "oz")};
    check_status(coin_state_from_motion(got, &p, q, omega, 3, 4), COIN_OK);
    check(got->x == 3 && got->z == 4);
}

/* 8 u, or 8 times what rounding q to double moves the angle by, where that is
 * more; the rates turn with the angles. */
TEST(a_motion_gives_the_reference_s_state)
{
    struct table t;
    table_load(&t, "motions.csv");
    for (size_t row = 0; row < t.rows; ++row) {
        const struct {
            const char *name, *effect;
            size_t member;
        } of[] = {{"theta", "theta_q", 0}, {"phi", "phi_q", 1},
                  {"psi", "psi_q", 2},     {"wX", "wX_q", 5},
                  {"wY", "wY_q", 6},       {"wZ", "wZ_q", 7}};
        coin_state s;
        double got[8];
        from_row(&t, row, &s);
        memcpy(got, &s, sizeof got);
        for (size_t i = 0; i < 6; ++i) {
            const double effect = table_at(&t, row, of[i].effect);
            check_note("%s, row %zu of motions.csv", of[i].name, row);
            check_terms(got[of[i].member], table_at(&t, row, of[i].name), 8,
                        i < 3 ? fmax(1, effect) : 6 + effect);
        }
    }
}

/* The same angle, whole turns apart. */
static double apart(double a, double b)
{
    return fabs(remainder(a - b, 6.283185307179586));
}

static void check_round_trip(const coin_state *s, const coin_params *p)
{
    double q[4], omega[3];
    coin_state back;
    check_status(coin_quaternion(s, q), COIN_OK);
    check_status(coin_angular_velocity(s, omega), COIN_OK);
    check_status(coin_state_from_motion(&back, p, q, omega, s->x, s->z),
                 COIN_OK);
    const double w = fabs(s->wX) + fabs(s->wY) + fabs(s->wZ);
    /* 4 u in each member of q, 8 u in the angles; heading and roll are as
     * uncertain as 1/cos theta, their difference (or sum) is not. */
    const double sharp = 32 * U, weak = 32 * U / cos(s->theta);
    check_near(back.theta, s->theta, sharp);
    check_near(apart(back.phi, s->phi), 0, weak);
    check_near(apart(back.psi, s->psi), 0, weak);
    const double side = s->theta > 0 ? -1 : 1;
    check_near(apart(back.phi + side * back.psi, s->phi + side * s->psi), 0,
               2 * sharp);
    check_near(back.wX, s->wX, weak * w);
    check_near(back.wY, s->wY, weak * w);
    check_near(back.wZ, s->wZ, weak * w);
}

TEST(a_state_survives_the_way_through_an_engine)
{
    struct random r = random_begin(21);
    for (int i = 0; i < 500; ++i) {
        const coin_params p = random_coin(&r);
        coin_state s = random_state(&r, &p, 1.57);
        if (i % 2) {
            const double gap = pow(10, -random_between(&r, 1, 7));
            s.theta = copysign(1.5707963267948966 - gap, s.theta);
        }
        check_round_trip(&s, &p);
    }
}

TEST(the_norm_of_the_quaternion_does_not_matter)
{
    const coin_params p = disc();
    const double omega[3] = {0.1, 0.2, 0.3};
    const int exponents[] = {-24, -9, 1, 9, 24};
    const double q[4] = {0.3, -0.4, 0.5, 0.6};
    coin_state want, got;
    check_status(coin_state_from_motion(&want, &p, q, omega, 0, 0), COIN_OK);
    for (size_t i = 0; i < sizeof exponents / sizeof *exponents; ++i) {
        double scaled[4];
        for (int k = 0; k < 4; ++k)
            scaled[k] = ldexp(q[k], exponents[i]);
        check_note("norm 2^%d", exponents[i]);
        check_status(coin_state_from_motion(&got, &p, scaled, omega, 0, 0),
                     COIN_OK);
        check_same(&got, &want, sizeof got);
    }
}

TEST(angles_come_out_within_half_a_turn)
{
    struct random r = random_begin(22);
    const coin_params p = disc();
    const double omega[3] = {0, 0, 0}, pi = 3.141592653589793;
    for (int i = 0; i < 2000; ++i) {
        coin_state s = random_state(&r, &p, 1.57), back;
        double q[4];
        s.phi *= 100;
        s.psi *= i % 2 ? 100 : 0;
        check_status(coin_quaternion(&s, q), COIN_OK);
        check_status(coin_state_from_motion(&back, &p, q, omega, 0, 0),
                     COIN_OK);
        check(back.phi > -pi && back.phi <= pi);
        check(back.psi > -pi && back.psi <= pi);
    }
}

/* Found by a search that climbs towards the largest error; the angles by mpmath
 * from the exact q. */
TEST(the_worst_rotations_known_are_good_to_8_u)
{
    const struct {
        double q[4], theta, phi, psi;
    } worst[] = {
        {{-0x1.4f66089cf32bbp-1, -0x1.206505ba14ca2p-3, -0x1.7bdc9f6cba2f2p-1,
          -0x1.92fc449d9f294p-6},
         0.14854120505947643325,
         1.71338658142720444638,
         0.246344495936044248029},
        {{-0x1.4722f5445fd7dp-2, -0x1.3b38e92a052f3p-1, -0x1.0e606f3205113p-1,
          0x1.f5ae21f221ce4p-2},
         1.14524192068360315477,
         -2.4419118413697220055,
         2.18567619227628810471},
        {{-0x1.b8b1fa443e2d4p-5, -0x1.2ccfa7b5e35f8p-1, -0x1.40a626ed31897p-1,
          0x1.04ecf8f4f5d44p-1},
         0.777542200781631202525,
         -2.29994565716341632786,
         1.86960710646458777305},
    };
    const coin_params p = disc();
    const double omega[3] = {0, 0, 0};
    for (size_t i = 0; i < sizeof worst / sizeof *worst; ++i) {
        coin_state s;
        check_note("case %zu", i);
        check_status(coin_state_from_motion(&s, &p, worst[i].q, omega, 0, 0),
                     COIN_OK);
        check_terms(s.theta, worst[i].theta, 8, 1);
        check_terms(s.phi, worst[i].phi, 8, 1);
        check_terms(s.psi, worst[i].psi, 8, 1);
    }
}

/* Half a turn exactly: every sign of the quaternion gives +pi, never -pi. */
TEST(half_a_turn_is_positive)
{
    const coin_params p = disc();
    const double omega[3] = {0, 0, 0};
    const double half_turns[][4] = {{0, 0, 1, 0},      {0, 0, -1, 0},
                                    {0, 0, 0, 1},      {0, 0, 0, -1},
                                    {-0.0, 0, 1, 0},   {-0.0, -0.0, -1, -0.0},
                                    {1e-17, 0, -1, 0}, {-1e-17, 0, -1, 0},
                                    {1e-17, 0, 0, -1}, {-1e-17, 0, 0, -1}};
    for (size_t i = 0; i < 10; ++i) {
        coin_state s;
        check_note("case %zu", i);
        check_status(coin_state_from_motion(&s, &p, half_turns[i], omega, 0, 0),
                     COIN_OK);
        const double turned = half_turns[i][3] != 0 ? s.psi : s.phi;
        check_near(turned, 3.141592653589793, 4 * U);
        check(s.theta == 0);
    }
}

TEST(a_q_of_no_rotation_is_an_upright_coin)
{
    const coin_params p = disc();
    const double q[4] = {-2, 0, 0, 0}, omega[3] = {5, 6, 7};
    const coin_state want = {0, 0, 0, 3, 4, 5, 6, 7};
    coin_state s;
    check_status(coin_state_from_motion(&s, &p, q, omega, 3, 4), COIN_OK);
    check(s.theta == 0 && fabs(s.phi) == 0 && fabs(s.psi) == 0);
    check_same(&s.x, &want.x, 5 * sizeof(double));
}

TEST(a_motion_without_a_state_is_refused)
{
    const double r = sqrt(0.5);
    const struct {
        const char *why;
        double q[4], omega[3], x;
    } bad[] = {
        {"q is 0", {0, 0, 0, 0}, {0, 0, 0}, 0},
        {"q is tiny", {3.1e-8, 0, 0, 0}, {0, 0, 0}, 0},
        {"q is huge", {0, 0, 3.2e7, 0}, {0, 0, 0}, 0},
        {"q has a NaN", {1, NAN, 0, 0}, {0, 0, 0}, 0},
        {"q has an infinity", {1, 0, -INFINITY, 0}, {0, 0, 0}, 0},
        {"all of q is infinite",
         {INFINITY, INFINITY, INFINITY, INFINITY},
         {0, 0, 0},
         0},
        {"flat on one face", {r, r, 0, 0}, {0, 0, 0}, 0},
        {"flat on the other", {r, -r, 0, 0}, {0, 0, 0}, 0},
        {"flat and turned", {0.5, 0.5, 0.5, -0.5}, {0, 0, 0}, 0},
        {"omega has a NaN", {1, 0, 0, 0}, {0, NAN, 0}, 0},
        {"omega is infinite", {1, 0, 0, 0}, {0, 0, INFINITY}, 0},
        {"omega is absurd", {1, 0, 0, 0}, {1e200, 0, 0}, 0},
        {"the centre is nowhere", {1, 0, 0, 0}, {0, 0, 0}, NAN},
    };
    const coin_params p = disc();
    const coin_state before = {1, 2, 3, 4, 5, 6, 7, 8};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        coin_state s = before;
        check_note("%s", bad[i].why);
        check_status(
            coin_state_from_motion(&s, &p, bad[i].q, bad[i].omega, bad[i].x, 0),
            COIN_ESTATE);
        check_same(&s, &before, sizeof s);
    }
}

/* Without parameters: a rate up to 1e6 sqrt(g/a) = 1e21, a place up to 1e9 a =
 * 1e24 are those of some coin. */
TEST(a_state_of_no_coin_has_no_frame)
{
    const size_t at[] = {3, 4, 5, 6, 7}; /* x, z, wX, wY, wZ */
    const double most[] = {1e24, 1e24, 1e21, 1e21, 1e21};
    for (int i = 0; i < 5; ++i)
        for (int sign = -1; sign <= 1; sign += 2) {
            coin_state s = {.theta = 0.7};
            double out[9] = {1};
            ((double *)&s)[at[i]] = sign * 0.999 * most[i];
            check_status(coin_axes(&s, out), COIN_OK);
            check_status(coin_quaternion(&s, out), COIN_OK);
            check_status(coin_angular_velocity(&s, out), COIN_OK);
            out[0] = 2;
            ((double *)&s)[at[i]] = sign * 1.001 * most[i];
            check_note("member %zu, %g", at[i], ((double *)&s)[at[i]]);
            check_status(coin_axes(&s, out), COIN_ESTATE);
            check_status(coin_quaternion(&s, out), COIN_ESTATE);
            check_status(coin_angular_velocity(&s, out), COIN_ESTATE);
            check(out[0] == 2);
        }
}
