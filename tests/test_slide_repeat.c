/* SPDX-License-Identifier: MIT */
/* A coin without losses needs the same friction whenever it has the same lean,
 * so that coin_slide_advance() does not look again at leans where it rolled.
 * It must not miss what happens at other leans. */
#include "support/check.h"
#include "support/random.h"

#include "friction.h"
#include "slide.h"
#include "sundman.h"

#include <math.h>

enum { SAMPLES = 400 };

/* F/N, infinite where the coin would lift off. */
static double ratio_of(const coin_state *s, const coin_params *p)
{
    coin_force f;
    check_status(coin_reaction(s, p, &f), COIN_OK);
    return f.normal > 0 ? f.friction / f.normal : (double)INFINITY;
}

/* A motion that returns: its period, and its state where F/N is largest. */
struct swing {
    coin_params p;
    coin_orbit o;
    double most, at;
    coin_state peak;
};

static int make_swing(struct swing *w, struct random *r)
{
    w->p = random_coin(r);
    const coin_state s = random_state(r, &w->p, 1.2);
    if (coin_orbit_init(&w->o, &s, &w->p) != COIN_OK || !(w->o.period > 0) ||
        w->o.period > 12 * natural_time(&w->p))
        return 0;
    w->most = 0;
    for (int i = 0; i < SAMPLES; ++i) {
        coin_state now;
        const double t = w->o.period * i / SAMPLES;
        check_status(coin_orbit_at(&w->o, t, &now), COIN_OK);
        const double ratio = ratio_of(&now, &w->p);
        if (ratio > w->most) {
            w->most = ratio;
            w->at = t;
            w->peak = now;
        }
    }
    return w->most > 0.05 && w->most < 1;
}

/* Between two positive numbers, evenly in the logarithm. */
static double random_log(struct random *r, double low, double high)
{
    return low * pow(high / low, random_between(r, 0, 1));
}

/* A coefficient that the coin exceeds near the peak alone, and a start after
 * it: the first slip is that of the next time. */
static void a_slip_at_a_turning_point_is_not_missed(void **unused)
{
    (void)unused;
    const int count = tries_asked(600);
    struct random r = random_begin(231);
    int slips = 0;
    for (int n = 0; n < count; ++n) {
        struct swing w;
        if (!make_swing(&w, &r))
            continue;
        const double mu = w.most * (1 - random_log(&r, 1e-4, 0.05));
        const coin_friction f = {mu, 0.9 * mu};
        const double tol = 1e-6, time = natural_time(&w.p);
        coin_state s = w.peak, on;
        coin_slide d;
        double begins = 0;
        for (double t = w.at; ratio_of(&s, &w.p) > mu * (1 - 1e-9);) {
            t += w.o.period / SAMPLES / 8;
            check_status(coin_orbit_at(&w.o, t, &s), COIN_OK);
            if (t > w.at + w.o.period)
                break;
        }
        on = s;
        if (coin_advance_until(&on, &w.p, 2 * w.o.period, 1e-9, mu, COIN_SLIPS,
                               &begins) != COIN_SLIPS ||
            !(begins > 0.01 * time))
            continue;
        check_status(coin_slide_of(&d, &s, &w.p), COIN_OK);
        double reached = 0;
        int32_t status = coin_slide_advance(
            &d, &w.p, &f, NULL, begins + 0.02 * time, tol, &reached);
        check(status == COIN_SLIPS || status == COIN_ELIFT);
        ++slips;
    }
    check(slips > count / 8);
}

/* A step of a coin that needs more friction than there is, as if the coin had
 * swung within the cone before, between two leans. */
static int keeps_rolling(coin_priv_sliding *g, int turns, double low,
                         double high)
{
    static const coin_state s = {.theta = 0.4, .wX = 0.3, .wY = 0.5, .wZ = 1};
    static const coin_friction f = {0.01, 0.009};
    coin_params p;
    check_status(coin_params_disc(&p, 1, 1, 1), COIN_OK);
    check(ratio_of(&s, &p) > 2 * f.mu_static);
    check_status(coin_priv_contact_of(&g->contact, &p, &f, NULL), COIN_OK);
    g->p = p;
    g->lossy = 0;
    g->w.run.b = g->series.from.b = g->contact.b;
    coin_priv_run_unlimited(&g->w.run, &s);
    const double unit = coin_priv_sundman_tau(&g->contact.b, &g->w.run.g.y, 1);
    coin_priv_judge_here(g);
    g->turning_points = turns;
    g->least_sth = low;
    g->most_sth = high;
    g->ended_in_t = 0;
    coin_priv_mark(g);
    check(coin_priv_roll_try(g, unit / 2) == 0);
    return coin_priv_judge_step(g, unit / 2, 1 / unit);
}

static void leans_that_were_not_tested_yet_are_tested(void **unused)
{
    (void)unused;
    static coin_priv_sliding g;
    check(keeps_rolling(&g, 2, -1, 1));
    const double from = g.from.y.sth, to = g.w.run.g.y.sth;
    check(to > from);
    check(keeps_rolling(&g, 2, to, to));
    check(!keeps_rolling(&g, 1, -1, 1));
    check(!keeps_rolling(&g, 2, to + U, 1));
    check(!keeps_rolling(&g, 2, -1, to - U));
    check(g.least_sth == -1 && g.most_sth == to && g.turning_points == 2);
    check(!keeps_rolling(&g, 0, to + U, 1));
    check(g.least_sth == to && g.most_sth == 1 && g.turning_points == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_slip_at_a_turning_point_is_not_missed),
        TEST(leans_that_were_not_tested_yet_are_tested),
    };
    return RUN_TESTS(tests);
}
