/* SPDX-License-Identifier: MIT */
/* coin_advance() where the coin truly falls flat: without momentum, or on the
 * edge between two passes. */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"
#include "support/random.h"

#include <math.h>

#define HALF_PI 1.5707963267948966

/* ------------------------------------------------------------- the impact */
/* The same fall of another body of the same I_X, in other units. */
static coin_params in_units(const coin_params *p, double part, double length,
                            double gravity)
{
    coin_params q;
    const double IX = 3 * p->inertia_X * length * length;
    check_status(coin_params_body(&q, 3, length, gravity, IX, part * IX),
                 COIN_OK);
    return q;
}

/* A row of falls.csv in some units, forward or backward, within a time whose
 * rounding is 0.01 natural units. */
static void check_fall(const struct table *t, size_t row, double sign,
                       const coin_params *p)
{
    const double side = table_at(t, row, "side"), T = natural_time(p);
    const double impact = sign * table_at(t, row, "t");
    coin_state s = {.theta = table_at(t, row, "theta"),
                    .wX = sign * table_at(t, row, "wX") / T};
    double reached = 7;
    check_note("row %zu of falls.csv, side %g, radius %g", row, sign,
               p->radius);
    check_status(coin_advance(&s, p, 1e14 * sign * T, 1e-12, &reached),
                 COIN_EFLAT);
    check_near(reached / T, impact, 1e-11);
    check(s.theta == side * (HALF_PI - 0x1p-52));
    check_status(coin_state_check(&s, p), COIN_OK);
}

/* Not to the last digit of a start in other units, which its rounding moves:
 * that is far below 1e-11 in all but the slowest fall. */
TEST(falls_are_timed_to_1e_11)
{
    struct table t;
    table_load(&t, "falls.csv");
    check(t.rows == 11);
    for (size_t row = 0; row < t.rows; ++row) {
        const coin_params p = ring(table_at(&t, row, "b"));
        const coin_params others[] = {
            p,
            in_units(&p, 0.1, 1, 1),
            in_units(&p, 1.2, 0.01213, 9.80665),
            in_units(&p, 2, 1e9, 9.80665),
            in_units(&p, 2, 1e-9, 9.80665),
        };
        for (size_t i = 0; i < sizeof others / sizeof *others; ++i)
            for (int sign = -1; sign <= 1; sign += 2)
                check_fall(&t, row, sign, &others[i]);
    }
}

/* It falls upright: the point of contact, heading and roll stay; the speed is
 * that of the height lost. */
TEST(the_last_state_is_that_of_the_impact)
{
    const coin_params p = ring(0);
    const coin_state start = {0.3, 1, 2, 3, 4, 0.25, 0, 0};
    coin_state s = start;
    double before[3], after[3], v[3];
    check_status(coin_contact(&s, &p, before, v), COIN_OK);
    check_status(coin_advance(&s, &p, 50, 1e-10, NULL), COIN_EFLAT);
    check_status(coin_contact(&s, &p, after, v), COIN_OK);
    /* By the path of the centre, of the error of tol. */
    check_near(after[0], before[0], 1e-12);
    check_near(after[2], before[2], 1e-12);
    check(s.phi == start.phi && s.psi == start.psi && s.wY == 0 && s.wZ == 0);
    const double E = coin_energy(&start, &p);
    check_near(s.wX, sqrt(2 * E / (p.inertia_X + 1)), 1e-10);
    /* Falling on, it is at once there; backward it gets up again. */
    double reached = 7;
    const coin_state last = s;
    check_status(coin_advance(&s, &p, 1, 1e-10, &reached), COIN_EFLAT);
    check_within(reached, 0, 1e-15);
    s = last;
    check_status(coin_advance(&s, &p, -1.945199152647443958, 1e-10, NULL),
                 COIN_OK);
    check_within(states_apart(&s, &start, &p), 0, 1e-10);
}

TEST(a_call_that_ends_just_before_the_impact_succeeds)
{
    const coin_params p = ring(0);
    const double impact = 2.689538375431411885;
    for (double left = 1; left > 1e-11; left /= 10) {
        coin_state s = {.theta = 0.3};
        check_note("%g before impact", left);
        check_status(coin_advance(&s, &p, impact - left, 1e-12, NULL), COIN_OK);
        /* At the speed of the fall. */
        check_within((HALF_PI - s.theta) / left, 0.7, 1.3);
    }
}

/* ------------------------------------------------- the edge of two passes */
/* With spin only those fall flat whose integrals have the ratio of the table in
 * docs/physics.md, "Flat".  No double is that ratio: to either side of it the
 * coin passes, and the heading turns by the angle of Eq. (51), this way or
 * that. The ratio has 12 digits there. */
TEST(falls_with_spin_are_the_edge_between_two_passes)
{
    const struct {
        double b, ratio;
    } bodies[] = {
        {0, -1.37250967107},
        {0.5, -1.40302569463},
        {0.9, -1.46159677729},
        {1, -1.47892564853},
    };
    for (int i = 0; i < 4; ++i)
        for (double off = 1e-11; off < 1e-7; off *= 10) {
            const coin_params p = ring(bodies[i].b);
            coin_state s[2];
            check_note("b = %g, ratio off by %g", bodies[i].b, off);
            for (int k = 0; k < 2; ++k) {
                const double ratio = bodies[i].ratio * (k ? 1 + off : 1 - off);
                const coin_state start = {
                    .wX = 0.4, .wY = 0.3 * ratio, .wZ = 0.3};
                const double E = coin_energy(&start, &p);
                s[k] = start;
                check_status(coin_advance(&s[k], &p, 4, 1e-12, NULL), COIN_OK);
                check_near(coin_energy(&s[k], &p), E, 1e-12 * E);
            }
            const double turn = 2 * HALF_PI * sqrt(1 + 1 / p.inertia_X);
            check_near(s[0].phi - s[1].phi, 2 * turn, 100 * off);
            check_near(s[0].theta, s[1].theta, 100 * off);
            check_near(s[0].wX, s[1].wX, 100 * off);
        }
}
