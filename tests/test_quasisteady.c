/* SPDX-License-Identifier: MIT */
#include "support/check.h"
#include "support/coins.h"
#include "support/methods.h"
#include "support/random.h"

#include <math.h>
#include <string.h>

#define HALF_PI 1.5707963267948966

enum { LAWS = 6 };

static const char *const law_names[LAWS] = {"damping", "dry", "viscous",
                                            "layer",   "gap", "rolling"};

static coin_losses law(int i, double m)
{
    coin_losses l = {0};
    double *const members[LAWS] = {&l.damping, &l.dry, &l.viscous,
                                   &l.layer,   &l.gap, &l.rolling};
    *members[i] = m;
    return l;
}

static coin_state spin(const coin_params *p, double angle)
{
    coin_state s;
    check_status(coin_steady_spin(&s, p, HALF_PI - angle), COIN_OK);
    return s;
}

/* -------------------------------------------------------- against the steps */
/* The largest differences to coin_settle() from the same slow start, at eight
 * times from t on: the start leaves a swing of its own. */
struct apart {
    double lean, rates, phases, path;
};

static void widen(double *most, double a, double b)
{
    *most = fmax(*most, fabs(a - b));
}

static struct apart apart(const coin_state *s, const coin_params *p,
                          const coin_losses *l, double t)
{
    coin_state slow, full;
    struct apart d = {0, 0, 0, 0};
    check_status(coin_quasisteady_at(s, p, l, 0, &full), COIN_OK);
    check_status(coin_settle(&full, p, l, t, 1e-11, NULL), COIN_OK);
    for (int i = 0; i < 8; ++i) {
        check_status(coin_quasisteady_at(s, p, l, t + 0.3 * i, &slow), COIN_OK);
        widen(&d.lean, slow.theta, full.theta);
        widen(&d.rates, slow.wY, full.wY);
        widen(&d.rates, slow.wZ, full.wZ);
        widen(&d.phases, slow.phi, full.phi);
        widen(&d.phases, slow.psi, full.psi);
        widen(&d.path, slow.x, full.x);
        widen(&d.path, slow.z, full.z);
        check_status(coin_settle(&full, p, l, 0.3, 1e-11, NULL), COIN_OK);
    }
    return d;
}

/* A quarter of the loss: a sixteenth of the error in lean, a quarter in
 * phases. */
static void in_mid_life_lean_errs_as_the_square_and_phases_as_the_loss(
    void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const double m[LAWS] = {2e-3, 1e-4, 4e-5, 2e-5, 4e-6, 2e-3};
    for (int i = 0; i < LAWS; ++i) {
        const coin_state s = spin(&p, 0.2);
        const coin_losses l = law(i, m[i]), part = law(i, m[i] / 4);
        const double t = coin_time_to_rest(&s, &p, &l) / 3;
        const struct apart a = apart(&s, &p, &l, t);
        const struct apart b = apart(&s, &p, &part, 4 * t);
        check_note("%s", law_names[i]);
        check_within(a.lean, 0, 1e-5);
        check_within(a.phases / b.phases, 3.4, 4.6);
        check_within(a.lean / b.lean, 8, 32);
        check_within(a.rates, 0, 1e-4);
    }
}

static void on_a_circle_the_path_errs_as_the_loss(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    coin_state s = circle(&p, 0.4, 1, 1);
    s.x = 3;
    s.phi = 2;
    const coin_losses l = law(2, 1e-3), half = law(2, 5e-4);
    const struct apart a = apart(&s, &p, &l, 80), b = apart(&s, &p, &half, 160);
    check_within(a.path, 1e-3, 0.1);
    check_within(a.path / b.path, 1.4, 2.8);
    check_within(a.lean / b.lean, 2.5, 6);
    check_within(a.phases, 0, 1e-3);
}

/* The closed law of a coin that rolls upright, and its path. */
static void a_straight_roll_slows_by_the_closed_laws(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const double K = 1.5, m = 1e-3, t = 300;
    coin_state s, out;
    check_status(coin_steady_roll(&s, &p, 2), COIN_OK);
    s.phi = 1;
    const coin_losses l = law(2, m);
    check_status(coin_quasisteady_at(&s, &p, &l, t, &out), COIN_OK);
    const double way = 2 * K / m * (1 - exp(-m * t / K));
    check_near(out.wZ, 2 * exp(-m * t / K), 1e-10);
    check_near(out.psi, way, 1e-8);
    check_near(out.x, -way * cos(1), 1e-8);
    check_near(out.z, way * sin(1), 1e-8);
    check(out.theta == 0 && out.wX == 0 && out.phi == 1);
}

static void an_upright_spin_slows_by_the_closed_law(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    coin_state s, out;
    check_status(coin_steady_upright_spin(&s, &p, 5), COIN_OK);
    const coin_losses l = {.spin = 1e-3};
    check_status(coin_quasisteady_at(&s, &p, &l, 200, &out), COIN_OK);
    check_near(out.wY, 5 * exp(-1e-3 * 200 / 0.25), 1e-10);
    check_near(out.phi, 5 * 250 * (1 - exp(-1e-3 * 200 / 0.25)), 1e-7);
}

/* ----------------------------------------------------------- the time to rest
 */
static void the_time_to_rest_errs_less_than_the_laws_of_the_header(
    void **unused)
{
    (void)unused;
    const coin_params p = disc();
    /* A loss of each kind, and what the time then errs by, relative. */
    const struct {
        double m, error;
    } at[LAWS] = {{2e-3, 4e-5}, {2e-4, 2e-4}, {2e-5, 1e-3},
                  {1e-5, 3e-3}, {1e-6, 3e-3}, {2e-3, 8e-3}};
    for (int i = 0; i < LAWS; ++i) {
        const coin_losses l = law(i, at[i].m);
        const coin_state s = spin(&p, 0.1);
        coin_state full;
        double when;
        check_status(coin_quasisteady_at(&s, &p, &l, 0, &full), COIN_OK);
        check_status(coin_settle(&full, &p, &l, 1e6, 1e-7, &when), COIN_RESTS);
        check_note("%s", law_names[i]);
        check_near(coin_time_to_rest(&s, &p, &l) / when, 1, at[i].error);
    }
}

/* By (76) rolling makes a swing of m of the angle grow to all of it where m^0.4
 * of the time is left. */
static void with_rolling_a_start_without_the_slow_wX_errs_as_m_to_0_4(
    void **unused)
{
    (void)unused;
    const coin_params p = disc();
    for (double m = 1e-2; m > 1e-5; m /= 10) {
        const coin_losses l = {.rolling = m};
        const coin_state start = spin(&p, 0.1);
        coin_state s = start;
        double when;
        check_status(coin_settle(&s, &p, &l, 1e6, 1e-5, &when), COIN_RESTS);
        const double error = coin_time_to_rest(&start, &p, &l) / when - 1;
        check_within(error / pow(m, 0.4), 0.8, 1.1);
    }
}

/* From small angles it is Eq. (75). */
static void near_flat_it_is_the_closed_law_of_the_end(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const double m = 1e-9;
    for (double e = 1e-3; e > 1e-5; e /= 50) {
        const double laws[LAWS] = {
            1.5 * sqrt(e) / m,    e * sqrt(e) / (2 * m),
            3 * e * e / (16 * m), e * e * sqrt(sqrt(e)) / (6 * sqrt(2) * m),
            e * e * e / (8 * m),  1.5 * sqrt(e) / m,
        };
        const coin_state s = spin(&p, e);
        for (int i = 0; i < LAWS; ++i) {
            const coin_losses l = law(i, m);
            check_note("%s from %g", law_names[i], e);
            check_near(coin_time_to_rest(&s, &p, &l) / laws[i], 1, 3 * e);
        }
    }
    /* The time goes with the root of the angle, to the end. */
    const coin_losses rolling = {.rolling = 1e-4};
    const coin_state s = spin(&p, 1e-8);
    check_near(coin_time_to_rest(&s, &p, &rolling), 1.5, 1e-6);
}

static void past_the_end_the_coin_lies_flat(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = law(1, 1e-3);
    for (int side = -1; side <= 1; side += 2) {
        coin_state s = spin(&p, 0.2), out;
        s.theta *= side;
        const double T = coin_time_to_rest(&s, &p, &l);
        check_status(coin_quasisteady_at(&s, &p, &l, T * 1.0001, &out),
                     COIN_RESTS);
        check_status(coin_state_check(&out, &p), COIN_OK);
        check(side * out.theta == 1.5707963267948963);
        check(out.wX == 0 && out.wY == 0);
        /* (5/9) e^(3/2), to leading order in e. */
        check_near(out.wZ, side * 5.0 / 9 * 0.2 * sqrt(0.2), 0.005);
        check_status(coin_quasisteady_at(&s, &p, &l, T * 0.9999, &out),
                     COIN_OK);
        check_within(side * out.theta, 1.56, 1.570796);
        check(side * out.wX > 0);
    }
}

static void the_time_to_rest_falls_by_the_time_that_passes(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const coin_losses l = {.dry = 1e-4, .viscous = 1e-5, .spin = 1e-4};
    const coin_state s = circle(&p, 0.5, 1.2, 1);
    const double T = coin_time_to_rest(&s, &p, &l);
    check_within(T, 1e3, 1e6);
    for (double part = 0; part < 0.95; part += 0.2) {
        coin_state at;
        check_status(coin_quasisteady_at(&s, &p, &l, part * T, &at), COIN_OK);
        check_near(coin_time_to_rest(&at, &p, &l), (1 - part) * T, 1e-5 * T);
    }
}

/* A step that ends near rest has to be cut to land on the time asked. */
static void the_lean_changes_by_its_rate_up_to_the_end(void **unused)
{
    (void)unused;
    const coin_params p = disc();
    const double m[LAWS] = {1e-2, 1e-3, 1e-4, 1e-4, 6e-4, 1e-2};
    for (int i = 0; i < LAWS; ++i) {
        const coin_losses l = law(i, m[i]);
        const coin_state s = spin(&p, 0.187);
        const double T = coin_time_to_rest(&s, &p, &l);
        for (double left = 0.5; left > 1e-3; left *= 0.6) {
            const double t = (1 - left) * T, d = 1e-3 * left * T;
            coin_state before, at, after;
            check_status(coin_quasisteady_at(&s, &p, &l, t - d, &before),
                         COIN_OK);
            check_status(coin_quasisteady_at(&s, &p, &l, t, &at), COIN_OK);
            check_status(coin_quasisteady_at(&s, &p, &l, t + d, &after),
                         COIN_OK);
            check_note("%s, %g left", law_names[i], left);
            check_near((after.theta - before.theta) / (2 * d * at.wX), 1, 1e-5);
        }
    }
}

/* --------------------------------------------------------------------- fits */
static void fitted_losses_take_the_time_asked(void **unused)
{
    (void)unused;
    struct random r = random_begin(161);
    for (int i = 0; i < 40; ++i) {
        const coin_params p = random_coin(&r);
        const double T = natural_time(&p);
        const double torque = p.mass * p.gravity * p.radius;
        coin_losses l = {.damping = random_between(&r, 0, 1),
                         .dry = torque * random_between(&r, 0, 1),
                         .viscous = torque * T * random_between(&r, 0, 1),
                         .soft = 1e-3 / T};
        const coin_losses before = l;
        const coin_state s = spin(&p, random_between(&r, 0.1, 0.6));
        const double time = T * random_between(&r, 100, 1000);
        check_status(coin_losses_fit(&l, &s, &p, time), COIN_OK);
        check_near(coin_time_to_rest(&s, &p, &l) / time, 1, 1e-8);
        check(l.soft == before.soft);
        check_near(l.dry * before.viscous / (before.dry * l.viscous), 1, 8 * U);
        check_near(l.dry * before.damping / (before.dry * l.damping), 1, 8 * U);
    }
}

/* What a game asks: eight seconds, and then the steps take that long. */
static void a_quarter_fitted_to_8_s_rests_after_8_s(void **unused)
{
    (void)unused;
    coin_params p;
    check_status(coin_params_disc(&p, 0.00567, 0.01213, 9.80665), COIN_OK);
    coin_losses l = {.dry = 1};
    coin_state s = spin(&p, 0.5235987755982988);
    double when;
    check_status(coin_losses_fit(&l, &s, &p, 8), COIN_OK);
    check_status(coin_settle(&s, &p, &l, 20, 1e-6, &when), COIN_RESTS);
    check_near(when, 8, 0.01);
    check_near(l.dry / (p.mass * p.gravity * p.radius), 8.5e-4, 2e-5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(in_mid_life_lean_errs_as_the_square_and_phases_as_the_loss),
        TEST(on_a_circle_the_path_errs_as_the_loss),
        TEST(a_straight_roll_slows_by_the_closed_laws),
        TEST(an_upright_spin_slows_by_the_closed_law),
        TEST(the_time_to_rest_errs_less_than_the_laws_of_the_header),
        TEST(with_rolling_a_start_without_the_slow_wX_errs_as_m_to_0_4),
        TEST(near_flat_it_is_the_closed_law_of_the_end),
        TEST(past_the_end_the_coin_lies_flat),
        TEST(the_time_to_rest_falls_by_the_time_that_passes),
        TEST(the_lean_changes_by_its_rate_up_to_the_end),
        TEST(fitted_losses_take_the_time_asked),
        TEST(a_quarter_fitted_to_8_s_rests_after_8_s),
    };
    return RUN_TESTS(tests);
}
