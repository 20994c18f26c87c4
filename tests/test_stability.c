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

/* Published with 17 digits: M = a = g = 1. */
TEST(it_is_that_of_the_table_in_physics_md)
{
    const struct {
        double b, theta, wZ;
        int32_t branch;
        double wY, L, R_G, R_C;
    } rows[] = {
        {0, 0.4, 1, 1, 0.25502915874751904725, -1.9508159608836891724,
         3.611590919745546, 4.001009262054196},
        {0, 0.4, 1, -1, -14.446363678982182569, -220.52823835096448022,
         0.06375728968687976, 0.3256610526217707},
        {0, 0.15, 0.5, 1, 0.19728994829327077707, 0.12174263076579063332,
         2.50588305813289, 2.655321190606489},
        {0, 0.15, 0.6, 1, 0.16490078346723897581, -0.13045485817695506881,
         3.597694530538659, 3.747132663012258},
        {0, 1.2, -0.7, 1, 2.271085008089851404, -18.340134928893384971,
         0.1116868929300934, 0.820352193037133},
        {0.5, 0.1, 0.55, 1, 0.11126739391249258543, -0.0168685996978296864,
         4.918352732637079, 5.018186149283907},
        {0.9, 0.15, 0.5, 1, 0.15516184904707534927, -0.029606763177170488335,
         3.186257072884115, 3.335695205357714},
        {1, 0.8, 2, -1, -7.9450970934870651464, -96.618873817923483091,
         0.1753802882832698, 0.5419758026162529},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        const coin_params p = ring(rows[i].b);
        const coin_state s =
            circle(&p, rows[i].theta, rows[i].wZ, rows[i].branch);
        double center, contact;
        check_note("row %zu", i);
        check_status(coin_steady_radii(&s, &p, &center, &contact), COIN_OK);
        /* The table means decimal theta and wZ: rounding them to double, and
         * what cancels in L, leave some 100 u. */
        check_near(s.wY, rows[i].wY, 100 * U * fabs(rows[i].wY));
        check_near(lambda2(&s, &p), rows[i].L, 100 * U * (2 + fabs(rows[i].L)));
        check_near(center, rows[i].R_G, 100 * U * (center + 1));
        check_near(contact, rows[i].R_C, 100 * U * (center + 1));
    }
}

/* ----------------------------------------------- by the equations of motion */
enum { LEAN = 4 };

static void lean_rates(const coin_params *p, const double y[LEAN],
                       double out[LEAN])
{
    const coin_state s = {y[0], 0, 0, 0, 0, y[1], y[2], y[3]};
    coin_state rates;
    check_status(coin_rates(&s, p, &rates), COIN_OK);
    out[0] = rates.theta;
    out[1] = rates.wX;
    out[2] = rates.wY;
    out[3] = rates.wZ;
}

/* Column k of the Jacobian, by central differences. */
static void column(const coin_params *p, const coin_state *s, int k, double h,
                   double A[LEAN][LEAN])
{
    double up[LEAN], down[LEAN];
    double y[LEAN] = {s->theta, s->wX, s->wY, s->wZ};
    const double middle = y[k];
    y[k] = middle + h;
    lean_rates(p, y, up);
    y[k] = middle - h;
    lean_rates(p, y, down);
    for (int i = 0; i < LEAN; ++i)
        A[i][k] = (up[i] - down[i]) / (2 * h);
}

/* The eigenvalues are 0, 0, +-lambda: the trace of A^2 is 2 lambda^2. */
static double half_trace_of_square(double A[LEAN][LEAN])
{
    double trace = 0;
    for (int i = 0; i < LEAN; ++i)
        for (int k = 0; k < LEAN; ++k)
            trace += A[i][k] * A[k][i];
    return trace / 2;
}

TEST(it_is_the_eigenvalue_of_the_jacobian)
{
    struct random r = random_begin(28);
    for (int i = 0; i < 200; ++i) {
        const coin_params p = random_coin(&r);
        const double w = 1 / natural_time(&p);
        const coin_state s =
            circle(&p, random_between(&r, 0.05, 1.2),
                   random_between(&r, -2 * w, 2 * w), i % 2 ? 1 : -1);
        double A[LEAN][LEAN];
        /* Natural units: differences of 1e-5 leave 1e-10 of the curvature
         * and 1e-11 of rounding. */
        column(&p, &s, 0, 1e-5, A);
        for (int k = 1; k < LEAN; ++k)
            column(&p, &s, k, 1e-5 * w, A);
        const double size = w * w + s.wY * s.wY / cos(s.theta) + s.wZ * s.wZ;
        check_near(lambda2(&s, &p), half_trace_of_square(A), 1e-8 * size);
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

/* Between these rates, and only there, the disc's slow circles at this lean
 * are unstable; above 0.325 rad they never are. */
TEST(circles_are_unstable_just_in_the_window_of_physics_md)
{
    const struct {
        double theta, low, high;
    } rows[] = {
        {0.05, 0.0299898990938434, 0.574567225881287},
        {0.1, 0.0610780093563408, 0.566009134698712},
        {0.2, 0.132663480959295, 0.527838000834475},
        {0.3, 0.247719986840611, 0.433312747650401},
    };
    const coin_params p = ring(0);
    for (size_t i = 0; i < 4; ++i) {
        const double theta = rows[i].theta, eps = 1e-9;
        coin_state s = circle(&p, theta, rows[i].low * (1 - eps), 1);
        check_note("theta = %g", theta);
        check(lambda2(&s, &p) < 0);
        s = circle(&p, theta, rows[i].low * (1 + eps), 1);
        check(lambda2(&s, &p) > 0);
        s = circle(&p, theta, rows[i].high * (1 - eps), 1);
        check(lambda2(&s, &p) > 0);
        s = circle(&p, theta, rows[i].high * (1 + eps), 1);
        check(lambda2(&s, &p) < 0);
    }
}

/* The tip of that window. */
TEST(the_last_unstable_lean_is_that_of_physics_md)
{
    const struct {
        double b, theta, wZ;
    } rows[] = {
        {0, 0.32504262801271191077, 0.342211828682567},
        {0.5, 0.32803756243685134635, 0.322688691850534},
        {0.9, 0.33357912543921631275, 0.287486795937401},
        {1, 0.33516908286228184597, 0.277593482616746},
    };
    for (size_t i = 0; i < 4; ++i) {
        const coin_params p = ring(rows[i].b);
        coin_state s = circle(&p, rows[i].theta * (1 - 1e-9), rows[i].wZ, 1);
        check_note("b = %g", rows[i].b);
        check(lambda2(&s, &p) > 0);
        s = circle(&p, rows[i].theta * (1 + 1e-9), rows[i].wZ, 1);
        check(lambda2(&s, &p) < 0);
    }
}
