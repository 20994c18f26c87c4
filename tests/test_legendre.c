/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/random.h"
#include "support/table.h"

#include "legendre.h"

#include <math.h>

/* Claimed in the header, relative or of the terms. */
#define CLAIMED 1e-15

/* kap = 4/(3 + b^2) has three roundings here: what an error of 3 u in it moves
 * a value by, from the value at kap (1 + MOVED). */
#define MOVED 0x1p-26

static double effect(double moved, double value)
{
    return fabs(moved - value) / MOVED * 3 * U;
}

/* Value against file, relative to `terms`. */
static void compare(double got, double moved, double want, double terms)
{
    check_near(got, want, CLAIMED * terms + effect(moved, got));
}

static double kappa(const struct table *t, size_t row)
{
    const double b = table_at(t, row, "b");
    return 4 / (3 + b * b);
}

TEST(the_power_series_is_the_reference_s)
{
    struct table t;
    size_t seen = 0;
    table_load(&t, "special.csv");
    for (size_t i = 0; i < t.rows; ++i) {
        const double u = table_at(&t, i, "u"), kap = kappa(&t, i);
        if (fabs(u) > 0.7)
            continue;
        const coin_priv_central c = coin_priv_legendre_central(kap, u);
        const coin_priv_central m =
            coin_priv_legendre_central(kap * (1 + MOVED), u);
        const double Pe = table_at(&t, i, "Pe"), Po = table_at(&t, i, "Po");
        const double We = table_at(&t, i, "We"), Wo = table_at(&t, i, "Wo");
        check_note("b = %g, u = %.17g", table_at(&t, i, "b"), u);
        compare(c.Pe, m.Pe, Pe, fabs(Pe));
        compare(c.Po, m.Po, Po, fabs(Po));
        compare(c.We, m.We, We, fabs(We));
        compare(c.Wo, m.Wo, Wo, fabs(Wo));
        ++seen;
    }
    check(seen >= 16);
}

static void flat_row(const struct table *t, size_t i, double v)
{
    const double kap = kappa(t, i);
    const coin_priv_flat f = coin_priv_legendre_flat(kap, v, log(v));
    const coin_priv_flat m =
        coin_priv_legendre_flat(kap * (1 + MOVED), v, log(v));
    const double R = table_at(t, i, "R"), S = table_at(t, i, "S");
    const double PR = table_at(t, i, "PR"), PS = table_at(t, i, "PS");
    const double ln = log(v);
    /* S = R ln v + sum and PS = PR ln v - 2 (1 - v) (R + sum'). */
    const double S_terms = fabs(R * ln) + fabs(S - R * ln);
    const double PS_terms = fabs(PR * ln) + fabs(PS - PR * ln);
    check_note("b = %g, v = %.17g", table_at(t, i, "b"), v);
    compare(f.R, m.R, R, fabs(R));
    compare(f.S, m.S, S, S_terms);
    compare(f.PR, m.PR, PR, fabs(PR));
    compare(f.PS, m.PS, PS, PS_terms);
}

/* Where 1 - |u| is exact. */
TEST(the_flat_series_is_the_reference_s)
{
    struct table t;
    size_t seen = 0;
    table_load(&t, "special.csv");
    for (size_t i = 0; i < t.rows; ++i) {
        const double u = fabs(table_at(&t, i, "u"));
        if (u > 0 && u < 0.5)
            continue;
        flat_row(&t, i, (1 - u) / 2);
        ++seen;
    }
    check(seen >= 16);
}

TEST(both_wronskians_hold_for_every_body_and_lean)
{
    struct random r = random_begin(4);
    for (int i = 0; i < 2000; ++i) {
        const double kap = 2 * pow(10, -random_between(&r, 0, 12));
        const double u = random_between(&r, -0.7, 0.7);
        const double v = 0.5 * pow(10, -random_between(&r, 0, 31));
        const coin_priv_central c = coin_priv_legendre_central(kap, u);
        const coin_priv_flat f = coin_priv_legendre_flat(kap, v, log(v));
        check_note("kap = %.17g, u = %.17g, v = %.17g", kap, u, v);
        /* Two factors each within 1e-15 of its terms, and the rounding of the
         * product and the sum. */
        check_near(c.Pe * c.We - kap * c.Po * c.Wo, 1,
                   4 * CLAIMED * (c.Pe * c.We));
        check_near(f.R * f.PS - f.S * f.PR, -2,
                   4 * CLAIMED * (fabs(f.R * f.PS) + fabs(f.S * f.PR)));
    }
}

/* The two bases solve one equation: R((1 - u)/2) = R(1/2) We + PR(1/2)/kap Wo,
 * since at u = 0 the pair is R(1/2), PR(1/2). */
TEST(the_series_continue_each_other)
{
    struct random r = random_begin(5);
    for (int i = 0; i < 500; ++i) {
        const double kap = random_between(&r, 0.05, 2);
        const double u = random_between(&r, 0.3, 0.7);
        const coin_priv_central c = coin_priv_legendre_central(kap, u);
        const coin_priv_flat f = coin_priv_legendre_flat(kap, (1 - u) / 2, 0);
        const coin_priv_flat up = coin_priv_legendre_flat(kap, 0.5, 0);
        const double even = up.R * c.We, odd = up.PR * c.Wo;
        check_note("kap = %.17g, u = %.17g", kap, u);
        check_near(f.R, even + odd, 4 * CLAIMED * (even - odd));
        check_near(f.PR, up.PR * c.Pe + kap * up.R * c.Po,
                   4 * CLAIMED * (kap * up.R * c.Po - up.PR * c.Pe));
    }
}
