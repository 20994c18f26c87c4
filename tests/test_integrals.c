/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/observable.h"
#include "support/random.h"

#include "angles.h"

#include <math.h>

static void values(const coin_state *s, const coin_params *p, double *out)
{
    check_status(coin_integrals(s, p, out), COIN_OK);
}

/* The pair (p, wZ) carried from theta to upright, by Runge-Kutta steps of (33)
 * in w with u = tanh w, which is regular down to the table. */
static void carry_upright(double k1, double k2, double w, double pair[2])
{
    enum { STEPS = 400 };
    const double h = -w / STEPS;
    for (int i = 0; i < STEPS; ++i) {
        double p = 0, wZ = 0, to_p = 0, to_wZ = 0;
        for (int stage = 0; stage < 4; ++stage) {
            const double part = stage == 0 ? 0 : stage == 3 ? h : h / 2;
            const double weight = stage == 0 || stage == 3 ? h / 6 : h / 3;
            const double x = cosh(w + i * h + part);
            const double dp = k1 * (pair[1] + part * wZ) / (x * x);
            wZ = k2 * (pair[0] + part * p);
            p = dp;
            to_p += weight * p;
            to_wZ += weight * wZ;
        }
        pair[0] += to_p;
        pair[1] += to_wZ;
    }
}

/* Of Eq. (35), at every lean. */
static void terms(const coin_state *s, const coin_params *p, double *out)
{
    const struct parts r = parts_of(s, p);
    const double k1 = r.IZ / r.IX, k2 = r.m / r.K;
    double of_p[2] = {1, 0}, of_wZ[2] = {0, 1};
    carry_upright(k1, k2, asinh(r.tth), of_p);
    carry_upright(k1, k2, asinh(r.tth), of_wZ);
    for (int k = 0; k < 2; ++k)
        out[k] = fabs(of_p[k]) * r.wY * r.cth + fabs(of_wZ[k]) * r.wZ;
}

static const struct observable integrals = {values, terms, 12, {"KY", "KZ"}};

TEST(the_integrals_are_the_reference_s_down_to_the_table)
{
    observable_at_exact_states(&integrals);
    observable_along_scenes(&integrals);
}

/* Upright, nothing has to be carried. */
TEST(upright_they_are_wY_and_wZ)
{
    struct random r = random_begin(12);
    for (int i = 0; i < 50; ++i) {
        const coin_params p = random_coin(&r);
        coin_state s = random_state(&r, &p, 1);
        double K[2];
        s.theta = 0;
        check_status(coin_integrals(&s, &p, K), COIN_OK);
        check(K[0] == s.wY && K[1] == s.wZ);
    }
}

/* wY cos theta tends to K_Y Pe(1) + k1 K_Z Po(1) as the coin comes to lie: the
 * values at u = 1 are known in Gamma functions.  At 1e-9 from flat what is
 * left of the way moves it by less than 1e-16. */
TEST(near_flat_they_give_the_limit_of_wY_cos_theta)
{
    const struct {
        double b, Pe, Po;
    } at_1[] = {
        {0, 2.14069835342370998858580091523, 1.46906459645399235523737772231},
        {0.5, 2.03625063147817315676382059858, 1.42845597833385109925304166524},
        {1, 1.81210409561309565902770299275, 1.33998361240794624041753490037},
    };
    struct random r = random_begin(15);
    for (size_t i = 0; i < 300; ++i) {
        const size_t k = i % 3;
        coin_params p;
        double K[2], size[2];
        check_status(coin_params_ring(&p, 1, 1, at_1[k].b, 1), COIN_OK);
        coin_state s = random_state(&r, &p, 1);
        const double side = i % 2 ? 1 : -1;
        s.theta = side * (COIN_PRIV_HALF_PI - 1e-9);
        s.wY *= 1e5;
        values(&s, &p, K);
        terms(&s, &p, size);
        const double p_flat = K[0] * at_1[k].Pe + side * 2 * K[1] * at_1[k].Po;
        /* The errors of K_Y and K_Z are one error of al, be: it is not their
         * sum that counts, but either bounds it. */
        check_near(p_flat, s.wY * cos(s.theta),
                   12 * U * (size[0] * at_1[k].Pe + size[1] * 2 * at_1[k].Po));
    }
}
