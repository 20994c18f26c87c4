/* SPDX-License-Identifier: MIT */
/* An orbit beside steps: what n frames in a time T cost each way, to an error
 * of WANTED, on scene generic, whose natural unit of time is 1.
 *     bench_orbit          CSV */
#include "clock.h"
#include "scene.h"
#include "textbook.h"

#include <stdio.h>

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

static unsigned long steps_in(double t, double h)
{
    const double n = ceil(t / h - 1e-9);
    return n < 1 ? 1 : (unsigned long)n;
}

/* Each moves a coin by so many frames of t each. */
typedef void frames(coin_state *s, double t, double setting, unsigned long n);

static void by_orbit(coin_state *s, double t, double unused, unsigned long n)
{
    (void)unused;
    for (unsigned long i = 1; i <= n; ++i)
        coin_orbit_at(&orbit, (double)i * t, s);
}

static void by_rk8(coin_state *s, double t, double h, unsigned long n)
{
    const unsigned long steps = steps_in(t, h);
    while (n-- > 0)
        coin_run(s, &c.p, COIN_RK8, t / (double)steps, steps, NULL);
}

static void by_textbook(coin_state *s, double t, double h, unsigned long n)
{
    const unsigned long steps = steps_in(t, h);
    while (n-- > 0)
        textbook_run(s, &c.p, t / (double)steps, steps);
}

static void by_advance(coin_state *s, double t, double tol, unsigned long n)
{
    const unsigned long legs = steps_in(t, LEG);
    for (n *= legs; n-- > 0;)
        coin_advance(s, &c.p, t / (double)legs, tol, NULL);
}

/* The ladder of settings begins at first and goes down by by. */
static const struct way {
    const char *name;
    frames *go;
    double first, by;
} ways[] = {
    {"orbit", by_orbit, 1, 1},
    {"rk8", by_rk8, 1, 0.7071067811865475},
    {"coin_advance", by_advance, 1e-4, 0.31622776601683794},
    {"textbook RK4", by_textbook, 0.25, 0.7071067811865475},
};
/* Powers of ten of T and n; each varies where the other is USUAL. */
enum { WAYS = sizeof ways / sizeof *ways, DECADES = 7, USUAL = 2 };

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

static void costs(const struct way *w)
{
    double setting = w->first;
    for (int i = 0; i < DECADES && setting > 0; ++i) {
        const double T = pow(10, i);
        if (w->by < 1) /* a step is no longer than those that were tried */
            setting = setting_for(w, T, fmin(setting, T / 8));
        for (int j = 0; j < DECADES && setting > 0; ++j) {
            const double n = pow(10, j);
            if (i == USUAL || j == USUAL)
                printf("%s,%g,%g,%.4g,%.3g\n", w->name, T, n, setting,
                       cost_of(w, T / n, setting, n) +
                           (w == ways ? cost_of_init() : 0));
        }
        fflush(stdout);
    }
}

int main(void)
{
    scene_load(&c, "generic", 20);
    if (coin_orbit_init(&orbit, &c.row[0].s, &c.p) != COIN_OK)
        return 1;
    puts("way,T,n,setting,ns");
    for (int k = 0; k < WAYS; ++k)
        costs(&ways[k]);
    return 0;
}
