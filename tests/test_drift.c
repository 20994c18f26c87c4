/* SPDX-License-Identifier: MIT */
/* The exact drift of the symplectic methods: its reach, and its series. */
#include "support/check.h"
#include "support/coins.h"
#include "support/random.h"
#include "support/table.h"

#include "legendre.h"
#include "methods.h"
#include "params.h"

#include <math.h>

/* ----------------------------------------------------------- the refusal */
/* The largest dt, to a part in 1e9, whose step is not refused; refused ones
 * leave the state alone. */
static double largest_step(const coin_state *at, const coin_params *p,
                           int32_t method)
{
    double good = 0, bad = 3 / fastest_rate(at, p);
    while (bad - good > 1e-9 * bad) {
        const double dt = (good + bad) / 2;
        coin_state s = *at;
        const int32_t status = coin_run(&s, p, method, dt, 1, NULL);
        if (status < 0) {
            check_status(status, COIN_ESTEP);
            check_same(&s, at, sizeof s);
        }
        *(status < 0 ? &bad : &good) = dt;
    }
    return good;
}

/* The part of the series' reach that the first drift of a step uses, for wY =
 * wZ = 0: the kick before it is gravity's over h/2 or h/6. */
static double reach_used(const coin_state *at, const coin_priv_constants *b,
                         int32_t method, double dt)
{
    const int two = method == COIN_SYMPLECTIC2;
    const double s = sin(at->theta), c = cos(at->theta);
    const double wX = at->wX + (two ? dt / 2 : dt / 6) * b->GJ * s;
    const double e = sin(at->theta + (two ? dt : dt / 2) * wX) - s;
    return fabs(e) * (1 + fabs(s)) / (c * c) / COIN_PRIV_SERIES_REACH;
}

/* On the way up, so that the first drift is the longest. */
TEST(a_drift_is_refused_where_its_series_ends)
{
    coin_params p;
    coin_priv_constants b;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    b = coin_priv_constants_of(&p);
    const coin_state starts[] = {
        {.theta = 1.5, .phi = 1, .psi = 2, .x = 3, .z = 4, .wX = -2},
        {.theta = -1.57, .wX = 3},
        {.theta = 1.57, .wX = -5},
    };
    for (size_t i = 0; i < sizeof starts / sizeof *starts; ++i)
        for (int32_t k = COIN_SYMPLECTIC2; k <= COIN_SYMPLECTIC4; ++k) {
            const double dt = largest_step(&starts[i], &p, k);
            check_note("start %zu, method %d: dt = %g", i, (int)k, dt);
            check_near(reach_used(&starts[i], &b, k, dt), 1, 1e-6);
        }
}

/* Down to the table, by a kick or by both drifts, and beyond: steps of all
 * sizes are refused, or end above it. */
TEST(no_step_leads_through_the_table)
{
    const double flat = 1.5707963267948966;
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    const coin_state starts[] = {
        {.theta = 1.5, .wX = 1},
        {.theta = flat - 0.05, .wX = 0.1},
        {.theta = flat - 0.05, .wX = -0.06},
        {.theta = 0.05 - flat, .wX = -0.1},
    };
    for (size_t k = 0; k < sizeof starts / sizeof *starts; ++k)
        for (int i = 1; i < 4000; ++i) {
            const int32_t method = COIN_SYMPLECTIC2 + i % 2;
            const double dt = i * 5e-4;
            coin_state s = starts[k];
            const int32_t status = coin_run(&s, &p, method, dt, 1, NULL);
            check_note("start %zu, method %d: dt = %g", k, (int)method, dt);
            check_status(coin_state_check(&s, &p), COIN_OK);
            if (dt > 0.4)
                check_status(status, COIN_ESTEP);
            if (status == COIN_ESTEP)
                check_same(&s, &starts[k], sizeof s);
        }
}

/* However near to the table: the limit of full accuracy is where the drift has
 * used nearly all of its reach. */
TEST(no_step_of_full_accuracy_is_refused)
{
    struct random r = random_begin(72);
    for (int i = 0; i < 2000; ++i) {
        const coin_params p = random_coin(&r);
        coin_state s = random_state(&r, &p, 1);
        const double side = s.theta < 0 ? -1 : 1;
        s.theta = side * (1.5707963 - pow(10, random_between(&r, -7, 0)));
        for (int32_t k = COIN_SYMPLECTIC2; k <= COIN_SYMPLECTIC4; ++k) {
            const double most = coin_priv_reaches[k].coarse;
            double dt = (i % 2 ? most : -most) / fastest_rate(&s, &p);
            coin_state end = s;
            check_status(coin_advance(&end, &p, dt, 1e-9, NULL), COIN_OK);
            dt *=
                fmin(1, fastest_rate(&s, &p) / fastest_rate(&end, &p)) * 0.999;
            check_status(coin_run(&s, &p, k, dt, 1, NULL), COIN_OK);
        }
    }
}

/* 113 bits; long double has 64, and under valgrind 53. */
__extension__ typedef __float128 quad;

/* ----------------------------------------------- the series of the drift */
struct pair {
    quad p, wZ;
};

/* The power series of coin_priv_legendre_central() in quad: sums of all
 * t_n u^n, n = n0, n0 + 2, ... */
static quad power_series(quad kap, quad u, int n0, int shift)
{
    quad term = n0 ? u : 1, sum = term;
    for (int n = n0; n < 240; n += 2) {
        term *= u * u * (n * (n + shift) + kap) / ((quad)(n + 1) * (n + 2));
        sum += term;
    }
    return sum;
}

/* The pair carried from u to v, by way of u = 0. */
static struct pair carried(struct pair at, quad k1, quad k2, quad u, quad v)
{
    const quad kap = k1 * k2;
    const quad KY = power_series(kap, u, 0, 1) * at.p -
                    k1 * power_series(kap, u, 1, -1) * at.wZ;
    const quad KZ = power_series(kap, u, 0, -1) * at.wZ -
                    k2 * power_series(kap, u, 1, 1) * at.p;
    const struct pair end = {
        KY * power_series(kap, v, 0, -1) +
            k1 * KZ * power_series(kap, v, 1, -1),
        KZ * power_series(kap, v, 0, 1) + k2 * KY * power_series(kap, v, 1, 1),
    };
    return end;
}

/* The pair at u + e, of which that at u is given. */
static void shift(double *p, double *wZ, double k1, double k2, double u,
                  double c2, double e)
{
    double dp, dwZ;
    coin_priv_legendre_change(&dp, &dwZ, *p, *wZ, k1, k2, u, c2, e);
    *p += dp;
    *wZ += dwZ;
}

/* How far the drift's series is from that, over so much of 1 - u^2, in u of the
 * terms of the change, with the last sum's rounding taken off. */
static double series_error(struct random *r, double reach)
{
    const double k1 = 2 * pow(10, random_between(r, -6, 0));
    const double k2 = random_between(r, 0.2, 0.95);
    const double u = random_between(r, -0.7, 0.7), c2 = fma(-u, u, 1);
    const double e = reach * c2 / (1 + fabs(u)) * (r->drawn++ % 2 ? 1 : -1);
    double p = random_between(r, -1, 1), wZ = random_between(r, -1, 1);
    const struct pair at = {p, wZ};
    const struct pair want = carried(at, k1, k2, u, (quad)u + e);
    const double p_terms = fabs(k1 * e) * (fabs(wZ) + fabs(k2 * p * e / c2));
    const double w_terms =
        fabs(e / c2) * (fabs(k2 * p) + fabs(e * k1 * k2 * wZ));
    shift(&p, &wZ, k1, k2, u, c2, e);
    check_note("k1 = %.17g, k2 = %.17g, u = %.17g, e = %.17g", k1, k2, u, e);
    const double p_off = fabs((double)(p - want.p)) - U * fabs(p);
    const double w_off = fabs((double)(wZ - want.wZ)) - U * fabs(wZ);
    return fmax(p_off / p_terms, w_off / w_terms) / U;
}

TEST(the_drift_s_series_is_good_to_rounding)
{
    const int count = tries_asked(120);
    struct random r = random_begin(73);
    double worst = 0, beyond = 0;
    for (int i = 0; i < count; ++i) {
        const double part = random_between(&r, 0, COIN_PRIV_SERIES_REACH);
        worst = fmax(worst, series_error(&r, part));
        worst = fmax(worst, series_error(&r, COIN_PRIV_SERIES_REACH));
    }
    for (int i = 0; i < 100; ++i)
        beyond = fmax(beyond, series_error(&r, 2 * COIN_PRIV_SERIES_REACH));
    check_note("random bodies and leans");
    check_within(worst, 0, 12);
    /* The reach is no larger than the series needs. */
    check(beyond > 1000);
}

/* Both basis solutions, from a row of special.csv to the next. */
static void carry_a_row(const struct table *t, size_t row)
{
    const double b = table_at(t, row, "b"), k1 = 2, k2 = 2 / (3 + b * b);
    const double end = table_at(t, row + 1, "u");
    double u = table_at(t, row, "u");
    double p = table_at(t, row, "Pe"), wZ = k2 * table_at(t, row, "Wo");
    double q = k1 * table_at(t, row, "Po"), vZ = table_at(t, row, "We");
    int shifts = 0;
    for (double next; u < end; u = next, ++shifts) {
        const double c2 = fma(-u, u, 1);
        next = fmin(u + COIN_PRIV_SERIES_REACH * c2 / (1 + u), end);
        shift(&p, &wZ, k1, k2, u, c2, next - u);
        shift(&q, &vZ, k1, k2, u, c2, next - u);
    }
    /* 2 u in each shift, and 4 u for k2 and the table. */
    const double bound = (2 * shifts + 4) * U;
    check_note("b = %g, from u = %g to %g", b, table_at(t, row, "u"), end);
    check_near(p / table_at(t, row + 1, "Pe"), 1, bound);
    check_near(wZ / (k2 * table_at(t, row + 1, "Wo")), 1, bound);
    check_near(q / (k1 * table_at(t, row + 1, "Po")), 1, bound);
    check_near(vZ / table_at(t, row + 1, "We"), 1, bound);
}

TEST(the_series_carries_the_reference_down_to_the_table)
{
    struct table t;
    int seen = 0;
    table_load(&t, "special.csv");
    for (size_t i = 0; i + 1 < t.rows; ++i)
        if (table_at(&t, i, "u") > 0 &&
            table_at(&t, i + 1, "u") > table_at(&t, i, "u")) {
            carry_a_row(&t, i);
            ++seen;
        }
    check(seen == 36);
}
