/* SPDX-License-Identifier: MIT */
/* coin_wobble_at() at far times, against wobbles.csv, by the law of coin.h. */
#include "support/check.h"
#include "support/table.h"

#include <math.h>

static struct table t;

static double at(size_t row, const char *column)
{
    return table_at(&t, row, column);
}

/* What the law reads, M = a = g = 1. */
struct law {
    double E, d, W;
};

static struct law law_of(const coin_state *steady, const coin_params *p,
                         const coin_state *start, double time)
{
    coin_state near;
    double L, own;
    check_status(coin_stability(steady, p, &L), COIN_OK);
    check_status(coin_steady_near(start, p, &near), COIN_OK);
    check_status(coin_stability(&near, p, &own), COIN_OK);
    check(L < 0 && own < 0);
    const double rate = sqrt(-L), apart = near.theta - steady->theta;
    const double c = cos(steady->theta), turn = fabs(near.wY / cos(near.theta));
    const double reach =
        fabs(apart) + hypot(start->theta - near.theta, start->wX / rate);
    const double rates =
        fmax(fmax(fabs(start->wX), fabs(start->wY - steady->wY)),
             fabs(start->wZ - steady->wZ));
    const double A = fmax(fmax(reach, start->theta - steady->theta), rates) / c;
    const double n = fmin(turn, fabs(turn - rate));
    struct law l;
    l.W = sqrt((start->wX * start->wX + start->wY * start->wY) /
                   pow(cos(start->theta), 2) +
               start->wZ * start->wZ + 1 / cos(start->theta));
    l.E = 4 * (A * A + 1e-14) * (1 + time * l.W) * fmax(1, l.W * l.W / -L);
    l.d = fmin(time, 1 / n);
    return l;
}

/* The largest error of x and z, and of the other members: rates in parts of W.
 */
struct errors {
    double path, rest;
    struct law l;
};

static struct errors errors_in(size_t row)
{
    coin_params p;
    check_status(coin_params_ring(&p, 1, 1, at(row, "inner"), 1), COIN_OK);
    const coin_state steady = {at(row, "theta0"), 0, 0, 0, 0, 0, at(row, "wY0"),
                               at(row, "wZ0")};
    const coin_state start = {
        at(row, "theta1"), 0, 0, 0, 0, at(row, "wX1"), at(row, "wY1"),
        at(row, "wZ1")};
    const double time = at(row, "t");
    struct errors e = {0, 0, law_of(&steady, &p, &start, time)};
    coin_state s;
    check_status(coin_wobble_at(&steady, &p, &start, time, &s), COIN_OK);
    const double off[] = {
        s.theta - at(row, "theta"),     s.phi - at(row, "phi"),
        s.psi - at(row, "psi"),         (s.wX - at(row, "wX")) / e.l.W,
        (s.wY - at(row, "wY")) / e.l.W, (s.wZ - at(row, "wZ")) / e.l.W,
    };
    for (int i = 0; i < 6; ++i)
        e.rest = fmax(e.rest, fabs(off[i]));
    e.path = fmax(fabs(s.x - at(row, "x")), fabs(s.z - at(row, "z")));
    return e;
}

/* The bound of coin.h holds.  It is not empty: the largest error is at least a
 * thousandth of it. */
static void errors_grow_as_the_law_says(void **unused)
{
    (void)unused;
    table_load(&t, "wobbles.csv");
    for (size_t row = 0; row < t.rows; ++row) {
        const struct errors e = errors_in(row);
        const double path = e.path / (e.l.E * (1 + e.l.W * e.l.d));
        check_note("row %zu, E = %g", row, e.l.E);
        check(e.l.E < 1);
        check_within(fmax(path, e.rest / e.l.E), 0.001, 1);
    }
}

/* Beside a straight roll ten times the time makes a hundred times the error of
 * x and z, which E alone does not bound. */
static void beside_a_roll_x_and_z_err_as_t_squared(void **unused)
{
    (void)unused;
    table_load(&t, "wobbles.csv");
    check(at(0, "wY0") == 0 && at(1, "t") == 10 * at(0, "t"));
    const struct errors e = errors_in(1);
    check_within(e.path / errors_in(0).path, 80, 120);
    check(e.path > e.l.E);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(errors_grow_as_the_law_says),
        TEST(beside_a_roll_x_and_z_err_as_t_squared),
    };
    return RUN_TESTS(tests);
}
