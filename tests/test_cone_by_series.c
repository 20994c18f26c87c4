/* SPDX-License-Identifier: MIT */
/* Where the polynomials of lib/real/cone_by_series.c exclude an event within a
 * stretch of motion, the motion itself has none. */
#include "support/check.h"
#include "support/random.h"

#include "event.h"
#include "extrapolation.h"
#include "sundman.h"

#include <math.h>

enum { SAMPLES = 64 };

/* A stretch of so many strides, and the largest F/N found on it; infinite where
 * the coin would lift off. */
struct sample {
    coin_params p;
    coin_priv_stretch w;
    double ratio, at; /* at: 0 to 1 */
};

static double ratio_of(const coin_priv_force_series *f)
{
    const double A = f->X[0].at[1], B = f->h[0].at[1], N = f->normal[0].at[1];
    return N > 0 ? sqrt(A * A + B * B) / N : (double)INFINITY;
}

/* F/N at x of a stretch, which then ends there. */
static double ratio_at(coin_priv_stretch *w, double x)
{
    coin_priv_run to = w->from;
    check(x == 0 || coin_priv_extrapolate(&to, x * w->tau));
    w->to = to.g.y;
    coin_priv_stretch_know(w, 1);
    return ratio_of(&w->force);
}

static struct sample sample_of(struct random *r, double stride)
{
    struct sample m;
    coin_priv_stretch *const w = &m.w;
    m.p = random_coin(r);
    const coin_state s = random_state(r, &m.p, 1.3);
    check_status(coin_priv_check(&s, &m.p, &w->from.b), COIN_OK);
    coin_priv_run_from(&w->from, &s, COIN_RK4, 0);
    w->unit = coin_priv_sundman_tau(&w->from.b, &w->from.g.y, 1);
    w->tau = stride * w->unit;
    w->t = 0;
    m.ratio = 0;
    for (int i = 0; i <= SAMPLES; ++i) {
        const double x = (double)i / SAMPLES, ratio = ratio_at(w, x);
        if (ratio > m.ratio) {
            m.ratio = ratio;
            m.at = x;
        }
    }
    return m;
}

static coin_priv_search search_of(double mu)
{
    const coin_priv_search f = {
        NULL, mu, mu > 1 ? 1 / mu : 1, mu > 1 ? 1 : mu, 1e-9, COIN_SLIPS};
    return f;
}

static int is_cleared(struct sample *m, double stride, int terms, double mu)
{
    const coin_priv_search f = search_of(mu);
    coin_priv_stretch_know(&m->w, terms);
    return coin_priv_is_clear(&f, &m->w.force, stride, stride);
}

/* A coefficient below the largest F/N is never cleared, by however little. */
static void what_is_cleared_holds_no_bit(void **unused)
{
    (void)unused;
    struct random r = random_begin(211);
    for (int n = 0; n < 2000; ++n) {
        const double stride = random_between(&r, 0.3, 1.5);
        struct sample m = sample_of(&r, stride);
        const double mu = fmin(m.ratio, 1e6) * (1 - 1e-9);
        check(!is_cleared(&m, stride, COIN_PRIV_FORCE_FEW, mu));
        check(!is_cleared(&m, stride, COIN_PRIV_FORCE_SOME, mu));
        check(!is_cleared(&m, stride, COIN_PRIV_FORCE_TERMS, mu));
    }
}

/* A force of 1 along the vertical, and a derivative of another component that
 * is not 0 at one end.  The stretch is as long as the reach, so that each
 * component may err by that derivative.  Where mu = 1, the force has to lie 2.5
 * times that from the edge of the cone. */
static void each_change_at_each_end_counts(void **unused)
{
    (void)unused;
    const coin_priv_search f = search_of(1);
    const double stride = COIN_PRIV_FEW_REACH;
    for (int i = 0; i < 4; ++i) {
        coin_priv_force_series at = {.terms = COIN_PRIV_FORCE_FEW};
        double *const change = &at.X[1 + i / 2].at[i % 2];
        at.normal[0].at[0] = at.normal[0].at[1] = 1;
        *change = 0.3;
        check(coin_priv_is_clear(&f, &at, stride, stride));
        *change = 0.45;
        check(!coin_priv_is_clear(&f, &at, stride, stride));
    }
}

/* Whether one that is larger by 2 % is cleared; -1 where the coin nearly lifts
 * off. */
static int clears(struct random *r, double stride, int terms)
{
    struct sample m = sample_of(r, stride);
    return m.ratio > 1 ? -1 : is_cleared(&m, stride, terms, 1.02 * m.ratio);
}

/* By all terms over a stride, by some over a half, by few over a fifth. */
static void most_of_what_holds_no_bit_is_cleared(void **unused)
{
    (void)unused;
    const int count = tries_asked(300);
    struct random r = random_begin(212);
    int all[3] = {0, 0, 0}, some[3] = {0, 0, 0}, few[3] = {0, 0, 0};
    for (int n = 0; n < count; ++n) {
        ++all[1 + clears(&r, 1, COIN_PRIV_FORCE_TERMS)];
        ++some[1 + clears(&r, 0.5, COIN_PRIV_FORCE_SOME)];
        ++few[1 + clears(&r, 0.2, COIN_PRIV_FORCE_FEW)];
    }
    check(all[2] > count / 10 && all[1] < 0.02 * all[2]);
    check(some[2] > count / 10 && some[1] < 0.02 * some[2]);
    check(few[2] > count / 10 && few[1] < 0.02 * few[2]);
}

/* Around the largest sample, by sections. */
static void refine_peak(struct sample *m)
{
    double low = m->at - 1.0 / SAMPLES, high = m->at + 1.0 / SAMPLES;
    for (int i = 0; i < 40; ++i) {
        const double a = low + 0.382 * (high - low);
        const double b = low + 0.618 * (high - low);
        if (ratio_at(&m->w, a) < ratio_at(&m->w, b))
            low = a;
        else
            high = b;
    }
    m->at = (low + high) / 2;
    m->ratio = fmax(m->ratio, ratio_at(&m->w, m->at));
}

/* The first event of the stretch, whose begin is the end of one before. */
static int first_event(coin_priv_moment *out, const coin_priv_search *f,
                       coin_priv_stretch *w)
{
    (void)ratio_at(w, 1);
    const coin_priv_variables end = w->to;
    (void)ratio_at(w, 0);
    w->to = end;
    return coin_priv_first_event(out, f, w);
}

/* Of the motion within one step, however long, 1e-6 of mu is enough. */
static void the_briefest_excursion_within_a_step_is_found(void **unused)
{
    (void)unused;
    const int count = tries_asked(80);
    struct random r = random_begin(20);
    for (int n = 0; n < count;) {
        struct sample m = sample_of(&r, random_between(&r, 0.5, 1.5));
        if (m.ratio < 0.05 || m.ratio > 100 || m.at < 0.05 || m.at > 0.95)
            continue;
        refine_peak(&m);
        coin_priv_search f = search_of(m.ratio / (1 + 1e-6));
        coin_priv_moment got;
        f.p = &m.p;
        f.tol *= natural_time(&m.p);
        check(first_event(&got, &f, &m.w));
        check(got.bits == COIN_SLIPS);
        f = search_of(m.ratio * (1 + 1e-6));
        f.p = &m.p;
        check(!first_event(&got, &f, &m.w));
        ++n;
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(what_is_cleared_holds_no_bit),
        TEST(each_change_at_each_end_counts),
        TEST(most_of_what_holds_no_bit_is_cleared),
        TEST(the_briefest_excursion_within_a_step_is_found),
    };
    return RUN_TESTS(tests);
}
