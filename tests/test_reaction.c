/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/difference.h"
#include "support/observable.h"
#include "support/random.h"

#include <math.h>

static coin_force force_on(const coin_state *s, const coin_params *p)
{
    coin_force f;
    check_status(coin_reaction(s, p, &f), COIN_OK);
    return f;
}

static void values(const coin_state *s, const coin_params *p, double *out)
{
    const coin_force f = force_on(s, p);
    for (int i = 0; i < 3; ++i)
        out[i] = f.R[i];
    out[3] = f.friction;
}

static void terms(const coin_state *s, const coin_params *p, double *out)
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

TEST(the_force_is_the_reference_s)
{
    const struct observable force = {values, terms, 8, {"Rx", "Ry", "Rz", "F"}};
    observable_at_exact_states(&force);
    observable_along_scenes(&force);
}

static void momentum(const coin_state *s, const coin_params *p, double *out)
{
    check_status(coin_velocity(s, p, out), COIN_OK);
    for (int i = 0; i < 3; ++i)
        out[i] *= p->mass;
}

TEST(the_force_is_the_change_of_momentum_less_weight)
{
    struct random r = random_begin(9);
    for (int i = 0; i < 20; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1);
        const double weight = p.mass * p.gravity;
        const coin_force f = force_on(&s, &p);
        double change[OBSERVABLE_MAX];
        difference_along(&s, &p, momentum, 3, change);
        for (int k = 0; k < 3; ++k)
            check_near(f.R[k], change[k] + (k == 1 ? weight : 0),
                       DIFFERENCE_BOUND * weight);
    }
}

TEST(its_parts_belong_together)
{
    struct random r = random_begin(10);
    for (int i = 0; i < 500; ++i) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.5);
        const coin_force f = force_on(&s, &p);
        double size[OBSERVABLE_MAX];
        terms(&s, &p, size);
        check(f.normal == f.R[1]);
        check_near(f.friction, hypot(f.R[0], f.R[2]), 24 * U * size[3]);
        if (f.normal > 0)
            check_near(f.ratio, f.friction / f.normal, 2 * U * f.ratio);
        else
            check(f.ratio == INFINITY);
    }
}

/* Rest upright, then a fall to this lean: energy gives wX, and Newton's law
 * along the two fixed directions gives, with k = I_X/(M a^2),
 *   N/Mg = (k - 2c + 3c^2)/(1 + k),  F/Mg = sin theta |2 - 3c|/(1 + k). */
TEST(a_fall_from_upright_lifts_the_disc_off_between_60_and_80_degrees)
{
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    const double k = 0.25;
    for (int i = 1; i < 30; ++i) {
        const double theta = 0.05 * i, c = cos(theta);
        const double wX = sqrt(2 * (1 - c) / (1 + k));
        const coin_state s = {theta, 0.3, 0, 0, 0, wX, 0, 0};
        const coin_force f = force_on(&s, &p);
        check_note("theta = %g", theta);
        check_near(f.normal, (k - 2 * c + 3 * c * c) / (1 + k), 16 * U);
        check_near(f.friction, sin(theta) * fabs(2 - 3 * c) / (1 + k), 16 * U);
        check((f.normal <= 0) == (c >= 1.0 / 6 && c <= 0.5));
    }
}

TEST(steady_motions_press_with_their_weight)
{
    struct random r = random_begin(11);
    for (int i = 0; i < 200; ++i) {
        const coin_params p = random_coin(&r);
        const double w = 1 / natural_time(&p);
        const double theta = random_between(&r, 0.05, 1.4);
        const double wZ = random_between(&r, -2 * w, 2 * w);
        const double weight = p.mass * p.gravity;
        double size[OBSERVABLE_MAX];
        coin_state s;
        check_status(coin_steady_circle(&s, &p, theta, wZ, i % 2 ? 1 : -1),
                     COIN_OK);
        const coin_force f = force_on(&s, &p);
        terms(&s, &p, size);
        /* wY, 8 u, enters twice more. */
        check_near(f.normal, weight, 24 * U * size[1]);
        const double mu =
            p.radius * fabs(s.wY * s.wZ) / (p.gravity * cos(theta));
        check_near(f.ratio, mu, 24 * U * (size[3] + mu * size[1]) / weight);
    }
}

/* Upright and falling at sqrt(g/a), nothing holds the coin down: N and F are 0
 * to the bit, and no friction is enough. */
TEST(a_coin_that_does_not_press_needs_infinite_friction)
{
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
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
