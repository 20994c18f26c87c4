/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"
#include "support/random.h"

#include <math.h>
#include <stdio.h>

/* A start that never turns round: spinning, with a nutation. */
static const coin_state spun = {.theta = 1.25, .wX = 0.05, .wY = 1.125};

/* The scenes of tests/reference/losses. */
static const struct {
    const char *name;
    double inner;
    coin_losses l;
    coin_state start;
} scenes[] = {
    {"alpha_generic",
     0,
     {.damping = 0.05},
     {.theta = 0.5, .wX = 0.1, .wY = 0.8, .wZ = 1.2}},
    {"dry_spin", 0, {.dry = 0.002}, {.theta = 1.25, .wX = 0.05, .wY = 1.125}},
    {"visc_spin",
     0,
     {.viscous = 0.0005},
     {.theta = 1.25, .wX = 0.05, .wY = 1.125}},
    {"layer_spin",
     0,
     {.layer = 0.00025},
     {.theta = 1.25, .wX = 0.05, .wY = 1.125}},
    {"mixed_ring",
     0.5,
     {0.01, 0.004, 0.002, 0.001, 0.0005, 0, 0.01, 0},
     {.theta = 0.3, .wY = 0.25, .wZ = 1}},
};

enum { SCENE_COUNT = sizeof scenes / sizeof *scenes };

/* Losses, state and time of natural units in others: mass M, length L, time T.
 */
static coin_losses losses_in(const coin_losses *l, double M, double L, double T)
{
    const double torque = M * L * L / (T * T);
    const coin_losses r = {
        l->damping,
        l->dry * torque,
        l->viscous * torque * T,
        l->layer * torque * T * sqrt(T),
        l->gap * torque * T,
        l->rolling * torque,
        l->spin * torque * T,
        l->soft / T,
    };
    return r;
}

static coin_state state_in(const coin_state *s, double L, double T)
{
    const coin_state r = {s->theta, s->phi,    s->psi,    s->x * L,
                          s->z * L, s->wX / T, s->wY / T, s->wZ / T};
    return r;
}

static int32_t settle(coin_state *s, const coin_params *p, const coin_losses *l,
                      double tol, double *when)
{
    return coin_settle(s, p, l, 1e6 * natural_time(p), tol, when);
}

/* ----------------------------------------------------------- the reference */
/* In what units, the error at a row of a scene. */
static double row_error(int i, const struct table *t, size_t row, double tol,
                        const double unit[3])
{
    const double M = unit[0], L = unit[1], T = unit[2];
    coin_params p;
    check_status(coin_params_ring(&p, M, L, L * scenes[i].inner, L / (T * T)),
                 COIN_OK);
    const coin_losses l = losses_in(&scenes[i].l, M, L, T);
    coin_state s = state_in(&scenes[i].start, L, T),
               want = state_in_row(t, row);
    want = state_in(&want, L, T);
    double reached;
    const double time = table_at(t, row, "t") * T;
    check_status(coin_settle(&s, &p, &l, time, tol, &reached), COIN_OK);
    check(reached == time);
    return states_apart(&s, &want, &p);
}

/* Near flat the motion amplifies what was before as 1/cos theta. */
static void every_row_of_the_reference_is_met_in_any_units(void **unused)
{
    (void)unused;
    const double units[][3] = {{1, 1, 1}, {0.00567, 0.01213, 0.0351}};
    for (int i = 0; i < SCENE_COUNT; ++i) {
        struct table t;
        char file[64];
        snprintf(file, sizeof file, "losses/%s.csv", scenes[i].name);
        table_load(&t, file);
        for (size_t row = 0; row < t.rows; ++row)
            for (int u = 0; u < 2; ++u) {
                const double time = table_at(&t, row, "t");
                const double c = table_at(&t, row, "cos_theta");
                const double sharp = row_error(i, &t, row, 1e-11, units[u]);
                check_note("%s, row %zu, units %d", scenes[i].name, row, u);
                check_within(sharp, 0, (1e-11 * time + 1e-13) / sqrt(c));
                check_within(row_error(i, &t, row, 1e-6, units[u]), 0,
                             (1e-6 * time + 1e-6) / sqrt(c));
            }
    }
}

static void the_time_of_rest_is_right_to_12_digits(void **unused)
{
    (void)unused;
    struct table t;
    table_load(&t, "losses/rest_times.csv");
    check(t.rows == 2);
    for (size_t row = 0; row < t.rows; ++row) {
        const coin_params p = disc();
        const coin_losses l = {.viscous = table_at(&t, row, "viscous"),
                               .layer = table_at(&t, row, "layer")};
        const double want = table_at(&t, row, "t_rest");
        for (double tol = 1e-12; tol < 1e-5; tol *= 100) {
            coin_state s = spun;
            double when;
            check_note("row %zu, tol %g", row, tol);
            check_status(settle(&s, &p, &l, tol, &when), COIN_RESTS);
            check_near(when, want, want * (tol + 1e-12));
            check_near(s.wX, table_at(&t, row, "wX"), 4 * tol + 1e-12);
            check_near(s.wZ, table_at(&t, row, "wZ"), 4 * tol + 1e-12);
            check(s.wY == 0 && s.theta > 1.57079632679489);
        }
    }
}

/* ------------------------------------------------------------ exact oracles */
static void upright_the_laws_are_closed_forms(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const double t = 7, K = 1.5, IX = 0.25;
    const struct {
        coin_losses l;
        coin_state start, end;
    } cases[] = {
        {{.dry = 0.01, .soft = 1e-8},
         {.wZ = 2},
         {.psi = 2 * t - 0.01 * t * t / (2 * K), .wZ = 2 - 0.01 * t / K}},
        {{.rolling = 0.01, .soft = 1e-8},
         {.wZ = -2},
         {.psi = -2 * t + 0.01 * t * t / (2 * K), .wZ = -2 + 0.01 * t / K}},
        {{.viscous = 0.01},
         {.wZ = 2},
         {.psi = 2 * K / 0.01 * (1 - exp(-0.01 * t / K)),
          .wZ = 2 * exp(-0.01 * t / K)}},
        {{.gap = 0.01},
         {.wZ = 2},
         {.psi = 2 * K / 0.01 * (1 - exp(-0.01 * t / K)),
          .wZ = 2 * exp(-0.01 * t / K)}},
        {{.layer = 0.01},
         {.wZ = 4},
         {.psi = 4 * t / (1 + 0.01 * t / K), .wZ = 0}},
        {{.damping = 0.05},
         {.wZ = 2},
         {.psi = log(1 + 0.1 * t) / 0.05, .wZ = 2 / (1 + 0.1 * t)}},
        {{.spin = 0.01},
         {.wY = 2},
         {.phi = 2 * IX / 0.01 * (1 - exp(-0.01 * t / IX)),
          .wY = 2 * exp(-0.01 * t / IX)}},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coin_state s = cases[i].start, want = cases[i].end;
        if (cases[i].l.layer > 0) { /* d(1/sqrt wZ)/dt = layer/(2 K) */
            const double a = 0.01 / (2 * K), r = 0.5 + a * t;
            want.wZ = 1 / (r * r);
            want.psi = (1 / 0.5 - 1 / r) / a;
        }
        want.x = -want.psi;
        check_note("case %zu", i);
        check_status(coin_settle(&s, &p, &cases[i].l, t, 1e-12, NULL), COIN_OK);
        check_within(states_apart(&s, &want, &p), 0, 1e-11);
        check(s.theta == 0 && s.wX == 0);
    }
}

/* Dry friction takes its torque times the angle rolled, however it is rolled.
 * While the contact is held nothing more is lost. */
static void dry_friction_allows_a_number_of_turns(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.dry = 0.002, .soft = 0x1p-30};
    coin_state s = spun;
    const double E = coin_energy(&s, &p);
    check_status(settle(&s, &p, &l, 1e-11, NULL), COIN_RESTS);
    check_near(E - coin_energy(&s, &p), 0.002 * s.psi, 1e-9);
    check_within(s.psi, 220, 230);
}

/* Where it lies at last the face turns backward, by the same for each law of
 * contour friction: (5/9) e0^(3/2) to leading order in the lean e0. */
static void the_face_turns_backward_at_the_end_by_any_law(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses laws[] = {
        {.dry = 2e-4}, {.viscous = 2e-5}, {.layer = 2e-5}, {.gap = 2e-6}};
    for (int i = 0; i < 4; ++i) {
        const double e0 = 0.1;
        coin_state s;
        check_status(coin_steady_spin(&s, &p, 1.5707963267948966 - e0),
                     COIN_OK);
        check_status(settle(&s, &p, &laws[i], 1e-8, NULL), COIN_RESTS);
        check_note("law %d", i);
        check_near(s.wZ / (5.0 / 9 * e0 * sqrt(e0)), 1, 0.05);
    }
}

/* Eq. (74): the time to rest of small losses from a small angle. */
static void the_times_to_rest_are_those_of_the_laws(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const double e = 0.02;
    const struct {
        coin_losses l;
        double time;
    } laws[] = {
        {{.dry = 2e-6}, e * sqrt(e) / (2 * 2e-6)},
        {{.viscous = 1e-7}, 3 * e * e / (16 * 1e-7)},
        {{.layer = 1e-7}, e * e * sqrt(sqrt(e)) / (8.48528 * 1e-7)},
        {{.gap = 1e-9}, e * e * e / (8 * 1e-9)},
        {{.rolling = 1e-3}, 1.5 * sqrt(e) / 1e-3},
        {{.damping = 1e-3}, 1.5 * sqrt(e) / 1e-3},
    };
    for (size_t i = 0; i < sizeof laws / sizeof *laws; ++i) {
        coin_state s;
        double when;
        check_status(coin_steady_spin(&s, &p, 1.5707963267948966 - e), COIN_OK);
        check_status(settle(&s, &p, &laws[i].l, 1e-5, &when), COIN_RESTS);
        check_note("law %zu", i);
        check_near(when / laws[i].time, 1, laws[i].l.rolling > 0 ? 0.08 : 0.02);
    }
}

/* A flat coin accelerates by g a/J: what is left of its weight is I_X/J. */
static void in_the_last_fall_a_fifth_of_the_weight_is_left(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.dry = 0.002};
    coin_state s = spun;
    coin_force f;
    check_status(settle(&s, &p, &l, 1e-6, NULL), COIN_RESTS);
    check_status(coin_losses_reaction(&s, &p, &l, &f), COIN_OK);
    check_near(f.normal, 0.2, 1e-12);
}

/* The shift by the softening is of second order in it. */
static void the_softening_shifts_rest_by_its_square(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    double when[4];
    for (int i = 0; i < 4; ++i) {
        const double soft[] = {1, 0.125, 0.015625, 0x1p-20};
        const coin_losses l = {.dry = 0.002, .soft = soft[i]};
        coin_state s = spun;
        check_status(settle(&s, &p, &l, 1e-11, &when[i]), COIN_RESTS);
    }
    check_within((when[0] - when[3]) / (when[1] - when[3]), 40, 90);
    check_within((when[1] - when[3]) / (when[2] - when[3]), 50, 80);
}

/* --------------------------------------------------------- energy and error */
/* The integral of the power along the way, by Gauss and Legendre, in panels as
 * short as the coin is fast. */
static void the_energy_lost_is_the_integral_of_the_power(void **unused)
{
    (void)unused;
    const double x[4] = {0.1834346424956498, 0.5255324099163290,
                         0.7966664774136267, 0.9602898564975363};
    const double w[4] = {0.3626837833783620, 0.3137066458778873,
                         0.2223810344533745, 0.1012285362903763};
    for (int i = 1; i < SCENE_COUNT; ++i) {
        coin_params p;
        const coin_losses *l = &scenes[i].l;
        coin_state s = scenes[i].start;
        check_status(coin_params_ring(&p, 1, 1, scenes[i].inner, 1), COIN_OK);
        const double E0 = coin_energy(&s, &p);
        double W = 0, when;
        coin_state end = s;
        check_status(settle(&end, &p, l, 1e-13, &when), COIN_RESTS);
        int32_t status = COIN_OK;
        while (status == COIN_OK && cos(s.theta) > (l->dry > 0 ? 0.03 : 2e-3)) {
            const double h =
                0.15 * cos(s.theta) / (fabs(s.wX) + fabs(s.wY) + cos(s.theta));
            double done = 0, sum = 0;
            for (int k = 0; k < 8; ++k) {
                const int j = k < 4 ? 3 - k : k - 4;
                const double at = h * (1 + (k < 4 ? -x[j] : x[j])) / 2;
                coin_settle(&s, &p, l, at - done, 1e-13, NULL);
                sum += w[j] * coin_losses_power(&s, &p, l);
                done = at;
            }
            W += h / 2 * sum;
            status = coin_settle(&s, &p, l, h - done, 1e-13, NULL);
        }
        check_note("%s", scenes[i].name);
        check_near((E0 - coin_energy(&s, &p)) / W, 1, 1e-11);
    }
}

static coin_losses random_losses(struct random *r, const coin_params *p,
                                 double most)
{
    double *member;
    coin_losses l = {0};
    for (int i = 0; i < 7; ++i) {
        member = (double *)&l + i;
        if (random_between(r, 0, 1) < 0.4)
            *member = most * exp(random_between(r, -8, 0));
    }
    if (!(l.damping + l.dry + l.viscous + l.layer + l.gap + l.rolling > 0))
        l.dry = most * exp(random_between(r, -4, 0));
    const double T = natural_time(p);
    return losses_in(&l, p->mass, p->radius, T);
}

static void of_random_launches_99_of_100_err_by_less_than_tol(void **unused)
{
    (void)unused;
    const double tols[] = {1e-3, 1e-6, 1e-9, 1e-11};
    for (int k = 0; k < 4; ++k) {
        struct random r = random_begin(151);
        int within = 0;
        for (int i = 0; i < 200; ++i) {
            const coin_params p = random_coin(&r);
            const coin_losses l = random_losses(&r, &p, 0.03);
            const coin_state start = random_state(&r, &p, 1.57);
            const double T = natural_time(&p), tol = tols[k];
            coin_state s = start, exact = start;
            double when, right;
            const int32_t status = coin_settle(&s, &p, &l, 4 * T, tol, &when);
            check_status(coin_settle(&exact, &p, &l, 4 * T, 1e-13, &right),
                         status);
            const double error = status == COIN_RESTS
                                     ? fabs(when - right) / T
                                     : path_apart(&s, &exact, &p);
            within += error <= 4 * tol;
            check_within(error, 0, 40 * tol);
        }
        check_within(within, 198, 200);
    }
}

/* By frames, by halves or in one call. */
static void how_often_it_is_called_does_not_matter(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses laws[] = {{.dry = 0.002},
                                {.viscous = 0.0005},
                                {.gap = 2e-5},
                                {.damping = 0.01},
                                {.rolling = 0.01, .spin = 0.01}};
    for (int i = 0; i < 5; ++i) {
        coin_state whole = spun, parts = spun;
        double when, sum = 0, reached;
        check_status(settle(&whole, &p, &laws[i], 1e-11, &when), COIN_RESTS);
        int32_t status;
        int calls = 0;
        do {
            status = coin_settle(&parts, &p, &laws[i], 0.475, 1e-11, &reached);
            sum += reached;
            check(status == COIN_RESTS ||
                  (status == COIN_OK && reached == 0.475));
        } while (status == COIN_OK && ++calls < 1000);
        check_note("law %d, %d calls", i, calls);
        check_near(sum, when, 1e-9 * when);
        check_near(parts.wX, whole.wX, 1e-7);
        check_near(parts.wZ, whole.wZ, 1e-7);
    }
}

static void violent_launches_come_to_rest_and_gain_no_energy(void **unused)
{
    (void)unused;
    struct random r = random_begin(152);
    for (int i = 0; i < 150; ++i) {
        const coin_params p = random_coin(&r);
        const coin_losses l = random_losses(&r, &p, 1);
        coin_state s = random_state(&r, &p, 1.57);
        const double T = natural_time(&p);
        double E = coin_energy(&s, &p);
        int32_t status = COIN_OK;
        for (int k = 0; k < 20 && status == COIN_OK; ++k) {
            status = coin_settle(&s, &p, &l, T, 1e-6, NULL);
            const double now = coin_energy(&s, &p);
            check_within(now, 0, E * (1 + 1e-7) + 1e-15 * p.mass);
            E = now;
        }
        check(status == COIN_OK || status == COIN_RESTS);
    }
}

/* ------------------------------------------------------------------- at rest
 */
static void a_coin_at_rest_stays_there(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.dry = 0.002}, none = {0};
    coin_state s = spun;
    double reached = 7;
    check_status(settle(&s, &p, &l, 1e-6, NULL), COIN_RESTS);
    check_status(coin_state_check(&s, &p), COIN_OK);
    check(s.theta == 1.5707963267948963 && s.wY == 0 && s.wX > 0);
    const coin_state flat = s;
    check_status(coin_settle(&s, &p, &l, 0, 1e-6, &reached), COIN_RESTS);
    check(reached == 0);
    reached = 7;
    check_status(coin_settle(&s, &p, &none, 5, 1e-6, &reached), COIN_RESTS);
    check(reached == 0);
    check_same(&s, &flat, sizeof s);
    check_status(coin_settle(&s, &p, &l, 5, 1e-6, NULL), COIN_RESTS);
    check_same(&s, &flat, sizeof s);
    check(coin_losses_power(&s, &p, &l) >= 0);
}

/* The same lean is no rest if the coin rises or turns. */
static void a_coin_that_leaves_the_table_does_not_rest(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.damping = 0.01};
    const coin_state starts[] = {
        {.theta = -1.5707963267948963, .wX = 0.5},
        {.theta = 1.5707963267948963, .wX = 0.5, .wY = 0.5, .wZ = 0.2},
    };
    for (int i = 0; i < 2; ++i) {
        coin_state s = starts[i];
        check_note("start %d", i);
        check_status(coin_settle(&s, &p, &l, 0.1, 1e-8, NULL), COIN_OK);
        check_within(cos(s.theta), 0.02, 0.1);
    }
}

/* Without a stop, and too close for a pass to be told from a fall. */
static void a_pass_closer_than_a_double_can_tell_is_a_fall(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.damping = 0.1};
    coin_state s = {.theta = 1.56, .wX = 0.1, .wZ = 1e-30};
    double when;
    check_status(coin_settle(&s, &p, &l, 5, 1e-8, &when), COIN_RESTS);
    const double e = 1.5707963267948966 - 1.56;
    check_near(when, (sqrt(0.01 + 1.6 * e) - 0.1) / 0.8, 1e-4);
    check(s.wY == 0 && s.wX > 0.1);
}

static void a_coin_that_stands_stays_standing(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.damping = 0.1, .spin = 0.1};
    const coin_state stands = {.phi = 1, .x = 2};
    coin_state s = stands;
    check_status(coin_settle(&s, &p, &l, 100, 1e-8, NULL), COIN_OK);
    check(s.theta == 0 && s.wX == 0 && s.wY == 0 && s.wZ == 0);
    check_near(s.phi, 1, U);
    check_near(s.x, 2, 2 * U);
}

/* So fast about the vertical that the whole fall is more than one step. */
static void a_fast_turn_is_held_later(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.dry = 3};
    const double e = 0.04, turn = 40;
    coin_state s = {.theta = 1.5707963267948966 - e,
                    .wY = turn * sin(e),
                    .wZ = -turn * cos(e)};
    const double E = coin_energy(&s, &p);
    double when;
    check_status(coin_settle(&s, &p, &l, 5, 1e-8, &when), COIN_RESTS);
    check_within(when, 0.01, 0.2);
    check_near(s.psi, 0, 1e-3);
    check_near(coin_energy(&s, &p) / E, 1, 1e-5);
    check_near(s.wZ / -turn, 1, 2e-3);
}

/* Each falls as it is held, at once: in the plane, or turning about the
 * vertical, or rising at first. */
static void a_stopped_contact_near_flat_is_held(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.dry = 0.1, .spin = 0.2};
    for (int side = -1; side <= 1; side += 2)
        for (int k = 0; k < 3; ++k)
            for (double turn = 0; turn < 1; turn += 0.3) {
                const double e = 0.03, v[] = {0, 0.1, -0.05};
                coin_state s = {.theta = side * (1.5707963267948966 - e),
                                .phi = 1,
                                .wX = side * v[k],
                                .wY = turn * sin(e),
                                .wZ = -side * turn * cos(e)};
                const coin_state start = s;
                const double E = coin_energy(&s, &p);
                double when = 0, sum = 0, reached;
                check_note("side %d, v %g, turn %g", side, v[k], turn);
                check_status(coin_settle(&s, &p, &l, 9, 1e-8, &when),
                             COIN_RESTS);
                /* With the acceleration of the flat coin. */
                const double A = 0.8;
                const double fall = (sqrt(v[k] * v[k] + 2 * A * e) - v[k]) / A;
                check_near(when, fall, 0.02 * fall);
                check(s.psi == start.psi && s.wY == 0 && side * s.wX > 0);
                /* Of the energy only the pivoting takes its part. */
                const double K = 1.5;
                check_near(E - coin_energy(&s, &p),
                           K / 2 * turn * turn * (1 - exp(-2 * 0.2 * when / K)),
                           1e-4 * turn + 1e-12);
                check_near(s.phi - 1, turn * when, 0.1 * turn * when + 1e-15);
                /* The point of contact stays. */
                check_near(s.x, start.x + side * (sin(s.phi) - cos(e) * sin(1)),
                           1e-7);
                coin_state by = start;
                int32_t status;
                do {
                    status =
                        coin_settle(&by, &p, &l, when / 7.5, 1e-8, &reached);
                    sum += reached;
                } while (status == COIN_OK);
                check_status(status, COIN_RESTS);
                check_near(sum, when, 1e-12);
                check_near(by.wZ, s.wZ, 1e-12);
            }
}

/* Held by too weak a friction a contact does not stay. */
static void a_contact_that_cannot_be_held_rolls_on(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.dry = 1e-9};
    const double e = 0.03, turn = 2;
    coin_state s = {.theta = 1.5707963267948966 - e,
                    .wX = -0.1,
                    .wY = turn * sin(e),
                    .wZ = -turn * cos(e)};
    check_status(coin_settle(&s, &p, &l, 1, 1e-8, NULL), COIN_OK);
    check(fabs(s.psi) > 1e-6);
}

static void a_symmetric_fall_is_an_ideal_one(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.damping = 0.1, .dry = 0.1, .viscous = 0.1};
    coin_state s = {.theta = 0.3}, ideal = s;
    double when, right;
    check_status(coin_settle(&s, &p, &l, 99, 1e-10, &when), COIN_RESTS);
    check_status(coin_advance(&ideal, &p, 99, 1e-10, &right), COIN_EFLAT);
    check_near(when, right, 1e-9);
    check_near(s.wX, ideal.wX, 1e-9);
}

/* ----------------------------------------------------------- without losses */
static void without_losses_it_is_coin_advance(void **unused)
{
    (void)unused;
    const coin_losses none = {.soft = 0.5};
    struct random r = random_begin(153);
    for (int i = 0; i < 100; ++i) {
        const coin_params p = random_coin(&r);
        coin_state a = random_state(&r, &p, 1.57), b = a;
        double reached, right;
        const double t = 9 * natural_time(&p);
        check_status(coin_settle(&a, &p, &none, t, 1e-7, &reached), COIN_OK);
        check_status(coin_advance(&b, &p, t, 1e-7, &right), COIN_OK);
        check_same(&a, &b, sizeof a);
        check(reached == right);
    }
    const coin_params p = disc();
    coin_state a = {.theta = 0.3}, b = a;
    double reached, right;
    check_status(coin_settle(&a, &p, &none, 9, 1e-7, &reached), COIN_RESTS);
    check_status(coin_advance(&b, &p, 9, 1e-7, &right), COIN_EFLAT);
    check_same(&a, &b, sizeof a);
    check(reached == right);
}

static void no_time_changes_nothing(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.dry = 0.1};
    const coin_state before = {0.5, -0.0, 2e9, 1e300, -0.0, 0.1, -0.0, 1.2};
    coin_state s = before;
    double reached = 7;
    check_status(coin_settle(&s, &p, &l, 0, 1e-6, &reached), COIN_OK);
    check_same(&s, &before, sizeof s);
    check(reached == 0);
}

/* ---------------------------------------------------------------- symmetries
 */
static void in_units_a_power_of_two_apart_every_bit_is_the_same(void **unused)
{
    (void)unused;
    struct random r = random_begin(154);
    for (int i = 0; i < 20; ++i) {
        const double L = ldexp(1, (int)random_between(&r, -30, 30));
        const double T = ldexp(1, 2 * (int)random_between(&r, -20, 20));
        coin_params p, q;
        check_status(coin_params_ring(&p, 1, 1, 0.5, 1), COIN_OK);
        check_status(coin_params_ring(&q, 4, L, L / 2, L / (T * T)), COIN_OK);
        const coin_losses l = random_losses(&r, &p, 0.5);
        const coin_losses m = losses_in(&l, 4, L, T);
        coin_state s = random_state(&r, &p, 1.57);
        coin_state t = state_in(&s, L, T);
        double a, b;
        const int32_t status = coin_settle(&s, &p, &l, 5, 1e-8, &a);
        check_status(coin_settle(&t, &q, &m, 5 * T, 1e-8, &b), status);
        s = state_in(&s, L, T);
        check_same(&t, &s, sizeof s);
        check(b == a * T);
    }
}

static void mirrored_every_bit_is_the_same(void **unused)
{
    (void)unused;
    struct random r = random_begin(155);
    for (int i = 0; i < 20; ++i) {
        const coin_params p = ring(0.5);
        const coin_losses l = random_losses(&r, &p, 0.5);
        coin_state s = random_state(&r, &p, 1.57);
        coin_state m = {-s.theta, s.phi, -s.psi, -s.x,
                        -s.z,     -s.wX, s.wY,   -s.wZ};
        const int32_t status = coin_settle(&s, &p, &l, 5, 1e-8, NULL);
        check_status(coin_settle(&m, &p, &l, 5, 1e-8, NULL), status);
        check(m.theta == -s.theta && m.phi == s.phi && m.psi == -s.psi);
        check(m.x == -s.x && m.z == -s.z && m.wX == -s.wX);
        check(m.wY == s.wY && m.wZ == -s.wZ);
    }
}

/* ------------------------------------------------------------------ statuses
 */
static void a_heading_out_of_range_ends_the_way(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.spin = 1e-9};
    coin_state s = {.phi = 0x1p31 - 100, .wY = 10};
    double reached = 7;
    check_status(coin_settle(&s, &p, &l, 20, 1e-6, &reached), COIN_ESTEP);
    check_status(coin_state_check(&s, &p), COIN_OK);
    check_within(reached, 9.8, 10);
    check_near(s.phi, 0x1p31 - 100 + 10 * reached, 1e-3);
}

static void a_call_takes_2_20_steps_and_the_next_goes_on(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.spin = 1e-12};
    const double wY = 1e4, way = 1e3;
    coin_state s = {.wY = wY};
    double reached;
    check_status(coin_settle(&s, &p, &l, way, 1e-2, &reached), COIN_ESTEP);
    check_within(reached, 10, way / 2);
    check_near(s.phi, wY * reached, 1e-2 * reached);
    const double before = reached;
    check_status(coin_settle(&s, &p, &l, 1, 1e-2, &reached), COIN_OK);
    check_near(s.phi, wY * (before + 1), 1e-2 * before);
}

/* The path ends where x is beyond all doubles. */
static void a_path_that_overflows_is_none(void **unused)
{
    (void)unused;
    coin_params big;
    check_status(coin_params_body(&big, 1e-290, 1e290, 1, 2.5e289, 5e289),
                 COIN_OK);
    const coin_losses l = {.damping = 1e-12};
    coin_state s = {.x = 1.7976931348623155e308, .wZ = -1e-12};
    const coin_state before = s;
    double reached = 7;
    check_status(coin_settle(&s, &big, &l, 1e16, 1e-2, &reached), COIN_ESTEP);
    check(reached == 0);
    check_same(&s, &before, sizeof s);
}

static void the_usual_errors_touch_nothing(void **unused)
{
    (void)unused;
    const coin_params good = disc();
    coin_params bad = good;
    bad.radius = -1;
    const coin_losses fine = {.dry = 0.1}, wrong = {.dry = -1};
    const coin_state start = spun, flat = {.theta = 2, .wY = 1};
    const struct {
        coin_state s;
        const coin_params *p;
        const coin_losses *l;
        double t, tol;
        int32_t want;
    } cases[] = {
        {flat, &bad, &wrong, NAN, 0, COIN_EARG},
        {flat, &bad, &wrong, NAN, 0.99e-13, COIN_EARG},
        {flat, &bad, &wrong, NAN, 1.01e-2, COIN_EARG},
        {flat, &bad, &wrong, NAN, NAN, COIN_EARG},
        {flat, NULL, &wrong, NAN, 1e-6, COIN_EARG},
        {flat, &bad, NULL, NAN, 1e-6, COIN_EARG},
        {flat, &bad, &fine, NAN, 1e-6, COIN_EPARAMS},
        {flat, &good, &wrong, NAN, 1e-6, COIN_EPARAMS},
        {flat, &good, &fine, NAN, 1e-6, COIN_ESTATE},
        {start, &good, &fine, NAN, 1e-6, COIN_ESTEP},
        {start, &good, &fine, -1e-300, 1e-6, COIN_ESTEP},
        {start, &good, &fine, INFINITY, 1e-6, COIN_ESTEP},
        {start, &good, &fine, 1.01e15, 1e-6, COIN_ESTEP},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; ++i) {
        coin_state s = cases[i].s;
        double reached = 7;
        check_note("case %zu", i);
        check_status(coin_settle(&s, cases[i].p, cases[i].l, cases[i].t,
                                 cases[i].tol, &reached),
                     cases[i].want);
        check_same(&s, &cases[i].s, sizeof s);
        check(reached == 7);
    }
    check_status(coin_settle(NULL, &good, &fine, 1, 1e-6, NULL), COIN_EARG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(every_row_of_the_reference_is_met_in_any_units),
        TEST(the_time_of_rest_is_right_to_12_digits),
        TEST(upright_the_laws_are_closed_forms),
        TEST(dry_friction_allows_a_number_of_turns),
        TEST(the_face_turns_backward_at_the_end_by_any_law),
        TEST(the_times_to_rest_are_those_of_the_laws),
        TEST(in_the_last_fall_a_fifth_of_the_weight_is_left),
        TEST(the_softening_shifts_rest_by_its_square),
        TEST(the_energy_lost_is_the_integral_of_the_power),
        TEST(of_random_launches_99_of_100_err_by_less_than_tol),
        TEST(how_often_it_is_called_does_not_matter),
        TEST(violent_launches_come_to_rest_and_gain_no_energy),
        TEST(a_coin_at_rest_stays_there),
        TEST(a_coin_that_leaves_the_table_does_not_rest),
        TEST(a_pass_closer_than_a_double_can_tell_is_a_fall),
        TEST(a_coin_that_stands_stays_standing),
        TEST(a_fast_turn_is_held_later),
        TEST(a_stopped_contact_near_flat_is_held),
        TEST(a_contact_that_cannot_be_held_rolls_on),
        TEST(a_symmetric_fall_is_an_ideal_one),
        TEST(without_losses_it_is_coin_advance),
        TEST(no_time_changes_nothing),
        TEST(in_units_a_power_of_two_apart_every_bit_is_the_same),
        TEST(mirrored_every_bit_is_the_same),
        TEST(a_heading_out_of_range_ends_the_way),
        TEST(a_call_takes_2_20_steps_and_the_next_goes_on),
        TEST(a_path_that_overflows_is_none),
        TEST(the_usual_errors_touch_nothing),
    };
    return RUN_TESTS(tests);
}
