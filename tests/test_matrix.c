/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/floats.h"
#include "support/random.h"

#include <coinf.h>

#include <math.h>
#include <string.h>

enum { ROWS = 4, TRIED = 500 };

/* The unit matrix, by columns. */
static void unit(long double m[16])
{
    for (int i = 0; i < 16; ++i)
        m[i] = i % 5 == 0;
}

/* m times a turn by an angle about axis 0, 1 or 2. */
static void turn(long double m[16], int axis, double angle)
{
    const int to = (axis + 1) % 3, from = (axis + 2) % 3;
    const long double s = sinl((long double)angle),
                      c = cosl((long double)angle);
    for (int row = 0; row < 3; ++row) {
        long double *const a = &m[ROWS * to + row], *const b =
                                                        &m[ROWS * from + row];
        const long double at = *a, bt = *b;
        *a = c * at + s * bt;
        *b = c * bt - s * at;
    }
}

/* By psi about z, by theta about x, by phi about y, all fixed: the product of
 * the three, in 64 bits. */
static void pose(long double m[16], const coin_state *s, double radius)
{
    unit(m);
    turn(m, 1, s->phi);
    turn(m, 0, s->theta);
    turn(m, 2, s->psi);
    m[12] = s->x;
    m[13] = radius * cosl((long double)s->theta);
    m[14] = s->z;
}

TEST(the_matrix_is_the_product_of_three_turns)
{
    struct random r = random_begin(161);
    for (int n = 0; n < TRIED; ++n) {
        const coin_params p = random_coin(&r);
        const coin_state s = random_state(&r, &p, 1.57);
        double m[16];
        long double want[16];
        check_status(coin_matrix(&s, &p, m), COIN_OK);
        pose(want, &s, p.radius);
        for (int i = 0; i < 12; ++i)
            check_near(m[i], (double)want[i], 9 * U);
        check_near(m[13], (double)want[13], 5 * U * (double)want[13]);
        check(m[12] == s.x && m[14] == s.z);
        check(m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1);
    }
}

TEST(upright_it_is_a_shift_upwards)
{
    const double want[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 3, 2, 4, 1};
    const coin_state s = {0, 0, 0, 3, 4, 5, 6, 7};
    coin_params p;
    double m[16];
    check_status(coin_params_disc(&p, 1, 2, 1), COIN_OK);
    check_status(coin_matrix(&s, &p, m), COIN_OK);
    for (int i = 0; i < 16; ++i)
        check(m[i] == want[i]);
}

TEST(a_matrix_of_floats_is_that_of_the_same_state)
{
    struct random r = random_begin(163);
    for (int n = 0; n < TRIED; ++n) {
        const coin_params p = random_coin(&r);
        const coin_state from = random_state(&r, &p, 1.57);
        const coinf_params fp = floats_params(&p);
        const coinf_state fs = floats_state(&from);
        const coin_state s = doubles_state(&fs);
        float m[16];
        long double want[16];
        check_status(coinf_matrix(&fs, &fp, m), COIN_OK);
        pose(want, &s, fp.radius);
        for (int i = 0; i < 12; ++i)
            check_near(m[i], (double)want[i], 8 * UF);
        check_near(m[13], (double)want[13], 4 * UF * (double)want[13]);
        check(m[12] == fs.x && m[14] == fs.z && m[15] == 1);
    }
}
