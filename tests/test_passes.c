/* SPDX-License-Identifier: MIT */
/* coin_advance() past the table and out of the doubles; and what it costs. */
#include "support/check.h"
#include "support/coins.h"
#include "support/far.h"
#include "support/methods.h"
#include "support/random.h"

#include <math.h>
#include <string.h>

/* coin_advance() once more, with its steps counted. */
#include "extrapolation.h"
#include "sundman.h"

static unsigned long counted;

static int counted_step(coin_priv_run *r, double tau, double *error)
{
    ++counted;
    return coin_priv_extrapolate(r, tau, error);
}

double counted_tau(const coin_priv_constants *b, const coin_priv_variables *y,
                   double stride);
int counted_accept(coin_priv_run *r, const coin_priv_variables *y,
                   const coin_priv_pose *adds);
int counted_step(coin_priv_run *r, double tau, double *error);
void counted_read_lean(coin_priv_progress *g);
int32_t counted_advance(coin_state *s, const coin_params *p, double t,
                        double tol, double *reached);

#define coin_priv_extrapolate(r, tau, e) counted_step(r, tau, e)
#define coin_advance counted_advance
#include "advance.c"
#undef coin_priv_extrapolate
#undef coin_advance

#define HALF_PI 1.5707963267948966

/* How many steps a call takes. */
static double steps_of(coin_state s, const coin_params *p, double t, double tol)
{
    counted = 0;
    check_status(counted_advance(&s, p, t, tol, NULL), COIN_OK);
    return (double)counted;
}

/* A step is as the fourteenth root of tol: 10^(8/14) = 3.73. */
TEST(eight_decades_of_tol_cost_four_times_the_steps)
{
    const coin_params p = ring(0.3);
    const coin_state s = {.theta = 0.5, .wX = 0.1, .wY = 0.8, .wZ = 1.2};
    const double few = steps_of(s, &p, 100, 1e-5);
    check_within(few, 90, 125);
    check_within(steps_of(s, &p, 100, 1e-13) / few, 3.2, 3.9);
}

/* From up to a step away the series of Eq. (54) lands at once as a rule, and
 * seldom after more than two steps; with a wrong sign or first coefficient it
 * takes 1.57 and more. */
TEST(landing_takes_a_step_or_two)
{
    enum { TRIED = 16000 };
    struct random r = random_begin(86);
    const double tol = 1e-12;
    const double stride = 3 * pow(tol, 1.0 / 14);
    double sum = 0;
    for (int i = 0; i < TRIED; ++i) {
        const coin_params p = ring(random_between(&r, 0, 1));
        const coin_state s = random_state(&r, &p, 1.5);
        coin_priv_constants b;
        b = coin_priv_constants_of(&p);
        const coin_priv_variables y = coin_priv_variables_of(&s);
        const double tau = coin_priv_sundman_tau(&b, &y, stride);
        const double t = random_between(&r, -1, 1) * tau * y.cth;
        sum += steps_of(s, &p, t, tol);
    }
    check_within(sum / TRIED, 0.77, 0.82);
}

/* ---------------------------------------------------- nearly flat passes */
/* A row of passes.csv: the coin after a pass and back. */
struct pass {
    coin_params p;
    coin_state start, want, s;
    double rates, d;
};

static struct pass pass_at(const struct table *t, size_t row, double tol)
{
    const double rates = table_at(t, row, "s");
    const coin_state start = {.theta = 0.3, .wY = rates, .wZ = rates};
    struct pass c = {
        .p = ring(table_at(t, row, "b")),
        .start = start,
        .want = state_in_row(t, row),
        .s = start,
        .rates = rates,
        .d = table_at(t, row, "d"),
    };
    check_note("b = %g, wY = wZ = %g", table_at(t, row, "b"), rates);
    check_status(coin_advance(&c.s, &c.p, table_at(t, row, "t"), tol, NULL),
                 COIN_OK);
    return c;
}

/* The distance of the pass, down to 1e-13, makes no difference. */
TEST(each_pass_of_the_ladder_is_that_of_the_reference)
{
    struct table t;
    table_load(&t, "passes.csv");
    check(t.rows == 39);
    for (size_t row = 0; row < t.rows; ++row) {
        const struct pass c = pass_at(&t, row, 1e-12);
        check_within(states_apart(&c.s, &c.want, &c.p), 0, 2e-13);
    }
}

static const coin_params bodies[] = {
    {1, 1, 1, 0.25, 0.5, 0, {0, 0}}, /* a disc */
    {1, 1, 1, 0.3125, 0.625, 0, {0, 0}}, {1, 1, 1, 0.4525, 0.905, 0, {0, 0}},
    {1, 1, 1, 0.5, 1, 0, {0, 0}},     /* a hoop */
    {1, 1, 1, 0.25, 0.01, 0, {0, 0}}, /* an axle with a thin rim */
    {1, 1, 1, 0.02, 0.03, 0, {0, 0}}, /* all weight in the middle */
    {1, 1, 1, 3, 5, 0, {0, 0}},       /* all weight far beyond the rim */
};

enum { COMPACT = 5, BODIES = sizeof bodies / sizeof *bodies };

/* How long a body falls from rest at 0.3. */
static double fall_time(const coin_params *p)
{
    coin_state s = {.theta = 0.3};
    double t;
    check_status(coin_advance(&s, p, 99, 1e-12, &t), COIN_EFLAT);
    return t;
}

/* Each decade that the pass is nearer costs as much as the last: in tau the
 * distance falls and grows as an exponential of the rate by which steps are
 * measured, so that both ways take 2 ln(10)/stride = 3 steps. */
TEST(a_pass_costs_little_and_keeps_the_energy)
{
    for (int i = 0; i < BODIES; ++i) {
        const coin_params *p = &bodies[i];
        const double period = 2 * fall_time(p);
        double before = 0;
        for (int k = 2; k <= 13; ++k) {
            const double rates = pow(10, -k);
            const coin_state start = {.theta = 0.3, .wY = rates, .wZ = rates};
            const double E = coin_energy(&start, p);
            const double steps = steps_of(start, p, period, 1e-9);
            coin_state s = start;
            check_status(coin_advance(&s, p, period, 1e-9, NULL), COIN_OK);
            check_note("body %d, wY = wZ = %g", i, rates);
            check_within(steps / period, 1.5, i == COMPACT ? 40 : 24);
            check_near(coin_energy(&s, p), E, 1e-9 * E);
            if (k > 2)
                check_within(steps - before, 0, 8);
            before = steps;
        }
    }
}

/* Eq. (51) for any body, whatever I_Z, with the sign of the momentum; the next
 * term is some d ln(1/d), with d as the momentum.  psi turns by the same. */
TEST(every_body_turns_by_its_own_angle_either_way)
{
    for (int i = 0; i < BODIES; ++i) {
        const coin_params *p = &bodies[i];
        const double root = sqrt(1 + 1 / p->inertia_X);
        const double period = 2 * fall_time(p);
        for (double s = 1e-3; s > 1e-13; s /= 10)
            for (int side = -1; side <= 1; side += 2) {
                coin_state c = {.theta = 0.3, .wY = side * s, .wZ = side * s};
                check_status(coin_advance(&c, p, period, 1e-12, NULL), COIN_OK);
                const double more = side * c.phi - 2 * HALF_PI * root;
                check_note("body %d, wY = wZ = %g", i, side * s);
                check_within(more / (s * log(1 / s)), 0.1, 10);
                check_near(side * c.psi, 2 * HALF_PI * root,
                           10 * s * log(1 / s));
            }
    }
}

/* The limits of docs/physics.md, "The nearly flat pass", by their digits. */
TEST(the_angles_are_those_of_physics_md)
{
    const double angles[] = {7.02481473104, 6.43834904961, 5.62857751528,
                             5.4413980927};
    for (int i = 0; i < 4; ++i) {
        coin_state c = {.theta = 0.3, .wY = 1e-13, .wZ = 1e-13};
        const double t = 2 * fall_time(&bodies[i]);
        check_status(coin_advance(&c, &bodies[i], t, 1e-12, NULL), COIN_OK);
        check_note("body %d", i);
        check_near(c.phi, angles[i], 2e-11);
    }
}

/* Landing in the midst of it: as long before as after the middle, the coin
 * leans alike, and has turned by as much less than half as more.  The heading
 * there turns by 3/d in a unit of time, of which 64 u are lost. */
TEST(landings_within_a_pass_are_right)
{
    struct random r = random_begin(84);
    struct table t;
    table_load(&t, "passes.csv");
    for (size_t row = 0; row < 5; ++row)
        for (int i = 0; i < 20; ++i) {
            const struct pass c = pass_at(&t, row, 1e-13);
            const double middle = table_at(&t, row, "t") / 2;
            const double off = c.d * pow(10, random_between(&r, -2, 1));
            const double bound = 1e-12 + 64 * U * 3 / c.d;
            coin_state a = c.start, b = c.start;
            check_note("row %zu, %g from the middle", row, off);
            check_status(coin_advance(&a, &c.p, middle - off, 1e-13, NULL),
                         COIN_OK);
            check_status(coin_advance(&b, &c.p, middle + off, 1e-13, NULL),
                         COIN_OK);
            check_near(a.theta, b.theta, 1e-14);
            check_near(a.wX, -b.wX, bound);
            check_near(a.phi + b.phi, c.want.phi, bound);
        }
}

/* The edge between passes and falls: 1e-30 rad. */
TEST(nearer_than_1e_30_is_flat)
{
    const coin_params p = ring(0);
    for (double tol = 1e-13; tol < 1e-1; tol *= 1e11) {
        coin_state s = {.theta = 0.3, .wY = 1e-29, .wZ = 1e-29};
        check_note("tol = %g", tol);
        check_status(coin_advance(&s, &p, 3, tol, NULL), COIN_OK);
        const coin_state nearer = {.theta = 0.3, .wY = 1e-31, .wZ = 1e-31};
        s = nearer;
        check_status(coin_advance(&s, &p, 3, tol, NULL), COIN_EFLAT);
        check_status(coin_state_check(&s, &p), COIN_OK);
    }
}

/* 11 steps of dt fit before x and z leave their range. */
TEST(a_place_out_of_range_is_not_reached)
{
    coin_params p;
    double dt;
    const coin_state edge = far_coin(&p, 0, &dt);
    for (int n = 1; n < 1000; n = 3 * n + 1) {
        coin_state s = edge;
        double reached = 7;
        const int32_t status = coin_advance(&s, &p, n * dt, 1e-6, &reached);
        check_note("%d steps of half a radius", n);
        check_status(status, n < 11 ? COIN_OK : COIN_ERANGE);
        check_status(coin_state_check(&s, &p), COIN_OK);
        if (n < 11)
            check(reached == n * dt);
        else
            check_within(reached, 6 * dt, 11.4 * dt);
    }
}
