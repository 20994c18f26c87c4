/* SPDX-License-Identifier: MIT */
/* The force along a motion as a power series of tau, against the force of
 * states on the way. */
#include "support/check.h"
#include "support/random.h"

#include "cone_by_series.h"
#include "extrapolation.h"
#include "sundman.h"

#include <math.h>

enum { LAST = COIN_PRIV_JOINED };

/* A run, its rate, and what is left of it after a part of a natural step. */
struct stretch {
    coin_priv_run run;
    double unit;
};

static struct stretch stretch_from(const coin_params *p, const coin_state *s)
{
    struct stretch w;
    check_status(coin_priv_check(s, p, &w.run.b), COIN_OK);
    coin_priv_run_unlimited(&w.run, s);
    w.unit = coin_priv_sundman_tau(&w.run.b, &w.run.g.y, 1);
    return w;
}

static struct stretch random_stretch(struct random *r)
{
    const coin_params p = random_coin(r);
    const coin_state s = random_state(r, &p, 1.5);
    return stretch_from(&p, &s);
}

/* Of any thin body, with rates of any size, as near to flat as 1e-3. */
static struct stretch wide_stretch(struct random *r)
{
    const double IX = pow(10, random_between(r, -3, 1));
    coin_params p;
    check_status(coin_params_body(&p, 1, 1, 1, IX,
                                  IX * pow(10, random_between(r, -3, 0.3))),
                 COIN_OK);
    coin_state s = random_state(r, &p, 1.57);
    s.wX *= pow(10, random_between(r, -4, 1));
    s.wY *= pow(10, random_between(r, -3, 1));
    s.wZ *= pow(10, random_between(r, -3, 1));
    return stretch_from(&p, &s);
}

static coin_priv_run after(const struct stretch *w, double x)
{
    coin_priv_run r = w->run;
    check(x == 0 || coin_priv_extrapolate(&r, x * w->unit));
    return r;
}

struct four {
    double of[4];
};

/* cos theta, and that times the force of coin_reaction() over M a, in the unit
 * of the series. */
static struct four truth(const struct stretch *w, coin_priv_run *r)
{
    coin_priv_read_lean(&r->g);
    const coin_state s = coin_priv_run_state(r);
    const coin_priv_body *b = &r->b;
    const coin_params p = {b->M, b->a, b->g_a * b->a, b->IX, b->IZ, {0, 0, 0}};
    coin_force f;
    check_status(coin_reaction(&s, &p, &f), COIN_OK);
    const double c = cos(s.theta);
    const double by = c * w->unit * w->unit / (b->M * b->a);
    const struct four is = {{
        by * (f.R[0] * cos(s.phi) - f.R[2] * sin(s.phi)),
        by * (f.R[0] * sin(s.phi) + f.R[2] * cos(s.phi)),
        by * f.R[1],
        c,
    }};
    return is;
}

/* Of the series at an end. */
static double sum(const coin_priv_ends *terms, int end, double x)
{
    double value = 0;
    for (int k = COIN_PRIV_FORCE_TERMS - 1; k >= 0; --k)
        value = value * x + terms[k].at[end];
    return value;
}

static double size_of(const struct four *f)
{
    return fabs(f->of[0]) + fabs(f->of[1]) + fabs(f->of[2]);
}

/* The next term is of the order x^7, its factor a few. */
static void the_series_give_the_force_further_on(void **unused)
{
    (void)unused;
    struct random r = random_begin(191);
    const double x[] = {0, 0.01, 0.02, -0.02};
    for (int n = 0; n < 300; ++n) {
        const struct stretch w = random_stretch(&r);
        const struct stretch other = random_stretch(&r);
        const int end = n % 2;
        const coin_priv_variables *y = &w.run.g.y, *y2 = &other.run.g.y;
        coin_priv_force_series f;
        coin_priv_force_series_of(&f, &w.run.b, end ? y2 : y, end ? y : y2,
                                  w.unit, COIN_PRIV_FORCE_TERMS);
        for (int i = 0; i < 4; ++i) {
            coin_priv_run to = after(&w, x[i]);
            const struct four want = truth(&w, &to);
            const double bound =
                size_of(&want) * (100 * U / want.of[3] + 1e3 * pow(x[i], 6));
            check_near(sum(f.X, end, x[i]), want.of[0], bound);
            check_near(sum(f.h, end, x[i]), want.of[1], bound);
            check_near(sum(f.normal, end, x[i]), want.of[2], bound);
            check_near(sum(f.cth, end, x[i]), want.of[3],
                       40 * U + pow(x[i], 6));
        }
    }
}

/* The first and second derivatives of a component at both ends. */
static double changes(const coin_priv_ends *terms)
{
    double sum = 0;
    for (int k = 1; k <= 2; ++k)
        sum += fabs(terms[k].at[0]) + fabs(terms[k].at[1]);
    return sum;
}

/* The curves over a stretch of h strides err by less than (h/reach)^(2 terms)
 * of the changes of the force at its ends, as cone_by_series.c rests on it; and
 * by rounding. */
static void joined_within(const struct stretch *w, double h, int terms,
                          double reach)
{
    const int degree = COIN_PRIV_DEGREE(terms);
    const double part = pow(h / reach, 2 * terms);
    coin_priv_run end = after(w, h);
    coin_priv_run begin = w->run;
    const struct four first = truth(w, &begin), last = truth(w, &end);
    coin_priv_force_series f;
    coin_priv_force_series_of(&f, &w->run.b, &w->run.g.y, &end.g.y, w->unit,
                              terms);
    double curve[4][LAST + 1];
    coin_priv_join(curve[0], f.X, h, 1, terms);
    coin_priv_join(curve[1], f.h, h, 1, terms);
    coin_priv_join(curve[2], f.normal, h, 1, terms);
    coin_priv_join(curve[3], f.cth, h, 1, terms);
    const double change = changes(f.X) + changes(f.h) + changes(f.normal);
    const double size = size_of(&first) + size_of(&last);
    const double cths = first.of[3] + last.of[3];
    for (double x = 0; x <= 1; x += 0.125) {
        coin_priv_run to = after(w, h * x);
        const struct four want = truth(w, &to);
        for (int i = 0; i < 4; ++i)
            check_near(
                coin_priv_bernstein_value(curve[i], degree, x), want.of[i],
                i < 3 ? part * change + 1e-12 * size : (part + 1e-12) * cths);
    }
}

static void two_series_join_to_one_curve(void **unused)
{
    (void)unused;
    const int count = tries_asked(250);
    struct random r = random_begin(192);
    for (int n = 0; n < count; ++n) {
        const struct stretch w = n % 2 ? random_stretch(&r) : wide_stretch(&r);
        for (double h = 0.2; h < 1.45; h += 0.2) {
            joined_within(&w, h, COIN_PRIV_FORCE_TERMS, COIN_PRIV_REACH);
            joined_within(&w, h, COIN_PRIV_FORCE_SOME, COIN_PRIV_SOME_REACH);
            joined_within(&w, h, COIN_PRIV_FORCE_FEW, COIN_PRIV_FEW_REACH);
        }
    }
}

/* Newton's method is given two iterations, or three for all terms. */
static void tau_within(coin_priv_stretch *w, double tau, double h, int terms,
                       double reach)
{
    const double rest = terms == COIN_PRIV_FORCE_TERMS ? 1e-13 : 1e-9;
    coin_priv_stretch_know(w, terms);
    check_near(w->tau, tau, fabs(tau) * (pow(h / reach, 2 * terms) + rest));
}

/* The tau of a stretch is found from its time, by a guess that is as far off as
 * the step in t, of a stretch that ends with one, makes it. */
static void the_tau_of_a_stretch_is_that_of_its_time(void **unused)
{
    (void)unused;
    struct random r = random_begin(193);
    for (int n = 0; n < 1000; ++n) {
        const struct stretch of = random_stretch(&r);
        const double h = random_between(&r, 0.01, 1.2);
        const double tau = h * of.unit * (n % 2 ? 1 : -1);
        const double guess = tau * (1 + random_between(&r, -3e-3, 3e-3));
        coin_priv_stretch w;
        coin_priv_run end = of.run;
        check(coin_priv_extrapolate(&end, tau));
        w.from = of.run;
        w.to = end.g.y;
        w.unit = of.unit;
        w.tau = guess;
        w.t = end.g.added.t;
        tau_within(&w, tau, h, COIN_PRIV_FORCE_FEW, COIN_PRIV_FEW_REACH);
        tau_within(&w, tau, h, COIN_PRIV_FORCE_SOME, COIN_PRIV_SOME_REACH);
        tau_within(&w, tau, h, COIN_PRIV_FORCE_TERMS, COIN_PRIV_REACH);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(the_series_give_the_force_further_on),
        TEST(two_series_join_to_one_curve),
        TEST(the_tau_of_a_stretch_is_that_of_its_time),
    };
    return RUN_TESTS(tests);
}
