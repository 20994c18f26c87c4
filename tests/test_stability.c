/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/random.h"
#include "support/steadies.h"

#include <math.h>

static double lambda2(const coin_state *s, const coin_params *p)
{
    double L;
    check_status(coin_stability(s, p, &L), COIN_OK);
    return L;
}

TEST(it_is_the_reference_s)
{
    struct table t;
    table_load(&t, "circles.csv");
    for (size_t row = 0; row < t.rows; ++row) {
        const struct circle c = circle_at(&t, row);
        check_terms(lambda2(&c.state, &c.params), table_at(&t, row, "lambda2"),
                    16, table_at(&t, row, "lambda2_terms"));
    }
}

/* ------------------------------------------------------------ by simulation */
/* Time until wX has changed its sign n times, linear between steps. */
static double crossing(coin_state s, const coin_params *p, double dt, int n)
{
    double t = 0;
    for (; n > 0; --n) {
        double before;
        do {
            before = s.wX;
            check_status(coin_step(&s, p, dt), COIN_OK);
            t += dt;
        } while (before * s.wX > 0);
        if (n == 1)
            t -= dt * s.wX / (s.wX - before);
    }
    return t;
}

/* A lean 1e-5 off oscillates; from its first turn to its third is a period.
 * Amplitude and shift of the steady motion change it by parts of 1e-5. */
TEST(stable_motions_oscillate_with_the_period_it_gives)
{
    const coin_params p = ring(0);
    coin_state spin;
    check_status(coin_steady_spin(&spin, &p, 0.6), COIN_OK);
    coin_state states[] = {circle(&p, 0.4, 1, 1), circle(&p, 1.2, -0.7, 1),
                           spin};
    for (size_t i = 0; i < 3; ++i) {
        const double period = 2 * acos(-1) / sqrt(-lambda2(&states[i], &p));
        check_note("state %zu", i);
        states[i].theta += 1e-5;
        /* The first step leaves wX = 0. */
        check_status(coin_step(&states[i], &p, period / 1000), COIN_OK);
        const double first = crossing(states[i], &p, period / 1000, 1);
        const double third = crossing(states[i], &p, period / 1000, 3);
        check_near(third - first, period, 1e-4 * period);
    }
}

/* A slow upright roll that leans by 1e-5 on its own leaf, K_Y = 0, falls as
 * cosh(lambda t). */
TEST(unstable_motions_grow_at_the_rate_it_gives)
{
    const coin_params p = ring(0);
    const double wZ = 0.3, lean = 1e-5;
    coin_state s;
    check_status(coin_steady_roll(&s, &p, wZ), COIN_OK);
    const double rate = sqrt(lambda2(&s, &p));
    s.theta = lean;
    s.wY = 2 * wZ * lean;
    check_status(coin_run(&s, &p, COIN_RK4, 3 / rate / 1000, 1000, NULL),
                 COIN_OK);
    /* lean cosh(3) squared, 1e-8, is neglected. */
    check_near(s.theta / lean, cosh(3), 1e-6);
}

/* -------------------------------------------------------- critical motions */
TEST(slow_upright_motions_fall_and_fast_ones_stand)
{
    struct random r = random_begin(29);
    for (int i = 0; i < 200; ++i) {
        const coin_params p = random_coin(&r);
        const double roll = coin_critical_roll(&p);
        const double spin = coin_critical_spin(&p);
        coin_state s;
        for (int side = -1; side <= 1; side += 2) {
            const double part = 1 + side * 1e-12;
            check_status(coin_steady_roll(&s, &p, -roll * part), COIN_OK);
            check(lambda2(&s, &p) * side < 0);
            check_status(coin_steady_upright_spin(&s, &p, spin * part),
                         COIN_OK);
            check(lambda2(&s, &p) * side < 0);
        }
    }
}

TEST(the_critical_rates_are_those_of_physics_md)
{
    const struct {
        double b, roll, spin;
    } rows[] = {
        {0, 0.57735026918962576451, 0.89442719099991587856},
        {0.5, 0.55470019622522912202, 0.87287156094396952506},
        {0.9, 0.51231551957855997202, 0.82973981364502234860},
        {1, 0.5, 0.81649658092772603273},
    };
    for (size_t i = 0; i < 4; ++i) {
        const coin_params p = ring(rows[i].b);
        check_note("b = %g", rows[i].b);
        check_near(coin_critical_roll(&p), rows[i].roll, 8 * U);
        check_near(coin_critical_spin(&p), rows[i].spin, 8 * U);
    }
}
