/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/observable.h"
#include "support/random.h"

#include <math.h>

static void values(const coin_state *s, const coin_params *p, double *out)
{
    out[0] = coin_energy(s, p);
}

/* Of the source's form: 1/2 M v^2, the turning, and M g a cos theta. */
static void terms(const coin_state *s, const coin_params *p, double *out)
{
    const struct parts r = parts_of(s, p);
    const double moving = r.m * (r.wX * r.wX + r.wZ * r.wZ);
    const double turning =
        r.IX * (r.wX * r.wX + r.wY * r.wY) + r.IZ * r.wZ * r.wZ;
    out[0] = (moving + turning) / 2 + r.M * r.g * r.a * r.cth;
}

static const struct observable energy = {values, terms, 8, {"E"}};

TEST(energy_is_the_reference_s)
{
    observable_at_exact_states(&energy);
    observable_along_scenes(&energy);
}

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
        terms(&s, &p, &size);
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
