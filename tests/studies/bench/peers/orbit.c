/* SPDX-License-Identifier: MIT */
/* An orbit beside steps: what n frames in a time T cost each way, to an error
 * of WANTED, on scene generic, whose natural unit of time is 1.  CSV. */
#include "../clock.h"
#include "../textbook.h"
#include "rates.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <stdio.h>
#include <string.h>

/* What all the way may err by, in radians and radii. */
#define WANTED 1e-9

/* A setting is not tried that takes longer for a way; a cost is measured over
 * the first frames, as many as take so long, and multiplied. */
#define PATIENCE 2e9 /* ns */
#define WINDOW 2e6

/* coin_advance() is asked for no more at once than it does in a call. */
#define LEG 1000.0

static scene c;
static coin_orbit orbit;
static struct peer_body body;

static int gsl_rates(double t, const double y[], double d[], void *unused)
{
    (void)t;
    (void)unused;
    peer_rates(&body, y, d);
    return GSL_SUCCESS;
}

static unsigned long steps_in(double t, double h)
{
    const double n = ceil(t / h - 1e-9);
    return n < 1 ? 1 : (unsigned long)n;
}

static void by_run(coin_state *s, int32_t method, double t, double h)
{
    const unsigned long n = steps_in(t, h);
    coin_run(s, &c.p, method, t / (double)n, n, NULL);
}

static void by_rk4(coin_state *s, double t, double h, unsigned long frames)
{
    while (frames-- > 0)
        by_run(s, COIN_RK4, t, h);
}

static void by_rk8(coin_state *s, double t, double h, unsigned long frames)
{
    while (frames-- > 0)
        by_run(s, COIN_RK8, t, h);
}

static void by_textbook(coin_state *s, double t, double h, unsigned long frames)
{
    const unsigned long n = steps_in(t, h);
    while (frames-- > 0)
        textbook_run(s, &c.p, t / (double)n, n);
}

static void by_advance(coin_state *s, double t, double tol,
                       unsigned long frames)
{
    const unsigned long legs = steps_in(t, LEG);
    for (frames *= legs; frames-- > 0;)
        coin_advance(s, &c.p, t / (double)legs, tol, NULL);
}

static void by_gsl(coin_state *s, double t, double tol, unsigned long frames)
{
    gsl_odeiv2_system system = {gsl_rates, NULL, 8, NULL};
    gsl_odeiv2_driver *d = gsl_odeiv2_driver_alloc_y_new(
        &system, gsl_odeiv2_step_rk8pd, 1e-3, tol, tol);
    double now = 0, y[8];
    memcpy(y, s, sizeof y); /* theta phi psi x z wX wY wZ, as in coin_state */
    for (unsigned long i = 1; i <= frames; ++i)
        if (gsl_odeiv2_driver_apply(d, &now, (double)i * t, y) != GSL_SUCCESS)
            y[0] = NAN;
    memcpy(s, y, sizeof y);
    gsl_odeiv2_driver_free(d);
}

static void by_orbit(coin_state *s, double t, double unused,
                     unsigned long frames)
{
    (void)unused;
    for (unsigned long i = 1; i <= frames; ++i)
        coin_orbit_at(&orbit, (double)i * t, s);
}

/* The ladder of settings begins at first and goes down by by. */
static const struct way {
    const char *name;
    void (*go)(coin_state *s, double t, double setting, unsigned long frames);
    double first, by;
} ways[] = {
    {"orbit", by_orbit, 1, 1},
    {"rk4", by_rk4, 0.25, 0.7071067811865475},
    {"rk8", by_rk8, 1, 0.7071067811865475},
    {"coin_advance", by_advance, 1e-4, 0.31622776601683794},
    {"textbook RK4", by_textbook, 0.25, 0.7071067811865475},
    {"GSL rk8pd", by_gsl, 1e-4, 0.31622776601683794},
};
enum { WAYS = sizeof ways / sizeof *ways, DECADES = 7 };

/* The largest error at eight times up to T; what that costs [ns]. */
static double error_of(const struct way *w, double T, double setting,
                       double *ns)
{
    coin_state s = c.row[0].s, truth;
    double worst = 0;
    const double begin = clock_ns();
    for (int i = 1; i <= 8; ++i) {
        w->go(&s, T / 8, setting, 1);
        coin_orbit_at(&orbit, T * i / 8, &truth);
        const double e = scene_error(&c, &s, &truth, 0);
        worst = e <= worst ? worst : e;
    }
    *ns = clock_ns() - begin;
    return worst;
}

/* The first setting from *from on with which a way errs by no more than WANTED
 * all the way to T; 0 if it takes too long, or never comes so near. */
static double setting_for(const struct way *w, double T, double from)
{
    double ns = 0;
    for (double at = from; ns < PATIENCE && at >= 1e-14; at *= w->by)
        if (error_of(w, T, at, &ns) <= WANTED)
            return at;
    return 0;
}

static double cost_of(const struct way *w, double t, double setting, double n)
{
    double least = INFINITY;
    const double tare = clock_cost();
    for (unsigned long m = 1; least == INFINITY; m *= 4) {
        double ns = 0;
        m = (double)m < n ? m : (unsigned long)n;
        for (int again = 0; again < 9 && ns < 4 * WINDOW; ++again) {
            coin_state s = c.row[0].s;
            const double begin = clock_ns();
            w->go(&s, t, setting, m);
            const double took = clock_ns() - begin - tare;
            ns = fmin(took, again == 0 ? took : ns);
        }
        if (ns > WINDOW || (double)m >= n)
            least = ns * n / (double)m;
    }
    return least;
}

static double cost_of_init(void)
{
    double least = INFINITY;
    for (int i = 0; i < 8; ++i) {
        const double begin = clock_ns();
        coin_orbit_init(&orbit, &c.row[0].s, &c.p);
        least = fmin(least, clock_ns() - begin);
    }
    return least - clock_cost();
}

static void costs(void)
{
    puts("way,T,n,setting,ns");
    for (int k = 0; k < WAYS; ++k) {
        double setting = ways[k].first;
        for (int i = 0; i < DECADES && setting > 0; ++i) {
            const double T = pow(10, i);
            if (k > 0) /* a step is no longer than those that were tried */
                setting = setting_for(&ways[k], T, fmin(setting, T / 8));
            for (int j = 0; j < DECADES && setting > 0; ++j) {
                const double n = pow(10, j);
                printf("%s,%g,%g,%.4g,%.3g\n", ways[k].name, T, n, setting,
                       cost_of(&ways[k], T / n, setting, n) +
                           (k == 0 ? cost_of_init() : 0));
            }
            fflush(stdout);
        }
    }
}

int main(void)
{
    gsl_set_error_handler_off();
    scene_load(&c, "generic", 20);
    body = peer_body_of(&c);
    if (coin_orbit_init(&orbit, &c.row[0].s, &c.p) != COIN_OK)
        return 1;
    costs();
    return 0;
}
