/* SPDX-License-Identifier: MIT */
/* A coin that bounces: it is let go with heads up and its face horizontal, and
 * turns about a diameter.  How well must its height be known for the side that
 * ends up?
 *
 * Of random starts, the share is counted whose neighbour, let go eps higher,
 * ends with the other side: f(eps).  Where the borders between heads and tails
 * are smooth f goes as eps; a slope below 1 is the codimension of a fractal
 * border (McDonald, Grebogi, Ott and Yorke, Physica D 17 (1985) 125). */
#include "luck.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Of the motion on the table between bounces. */
#define TOL 1e-9

enum { DECADES = 8 }; /* eps from 1e-2 to 1e-9 */

static const double bounces[] = {0, 0.2, 0.4, 0.5, 0.6, 0.7, 0.8};
enum { BOUNCES = sizeof bounces / sizeof *bounces };

static struct luck_end end_of(double restitution, double height, double spin,
                              double tol)
{
    const coin_params p = luck_disc();
    const coin_table table = luck_table(restitution);
    return luck_toss(luck_flat(height, spin), &p, &table, tol);
}

static struct luck_end cell(const void *of, double height, double spin)
{
    return end_of(*(const double *)of, height, spin, 1e-6);
}

/* -------------------------------------------------------------- neighbours */
struct pairs {
    unsigned char *others; /* a bit for each eps whose neighbour differs */
    int *impacts;
    double restitution, low, high;
};

static void pair(void *of, int i)
{
    struct pairs *q = of;
    const double height = luck_random(i, 0, q->low, q->high);
    const double spin = luck_random(i, 1, 0, 8);
    const struct luck_end end = end_of(q->restitution, height, spin, TOL);
    q->others[i] = 0;
    q->impacts[i] = end.impacts;
    for (int k = 0; k < DECADES; ++k) {
        const double near = height + pow(10, -2 - k);
        const int other =
            end_of(q->restitution, near, spin, TOL).heads != end.heads;
        q->others[i] |= (unsigned char)(other << k);
    }
}

static int unlike(const struct pairs *q, int n, int k)
{
    int all = 0;
    for (int i = 0; i < n; ++i)
        all += q->others[i] >> k & 1;
    return all;
}

/* The slope of log f over log eps by weighted least squares, and its standard
 * error, where f is below a fifth and 10 neighbours or more differ. */
static double slope(const struct pairs *q, int n, double *error)
{
    double w = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (int k = 0; k < DECADES; ++k) {
        const double got = unlike(q, n, k);
        if (got < 10 || got > n / 5.0)
            continue;
        w += got;
        x += got * (-2 - k);
        xx += got * (-2 - k) * (-2 - k);
        y += got * log10(got);
        xy += got * (-2 - k) * log10(got);
    }
    const double spread = w * xx - x * x;
    *error = sqrt(w / spread) / log(10);
    return (w * xy - x * y) / spread;
}

static double mean_impacts(const struct pairs *q, int n)
{
    double all = 0;
    for (int i = 0; i < n; ++i)
        all += q->impacts[i];
    return all / n;
}

static void neighbours(struct luck *l, struct pairs *q, int n)
{
    double error;
    luck_each(n, pair, q);
    for (int k = 0; k < DECADES; ++k)
        luck_share(l, "neighbour ends otherwise", q->restitution,
                   pow(10, -2 - k), unlike(q, n, k), n, (double)NAN);
    const double found = slope(q, n, &error);
    if (isfinite(error))
        luck_number("slope", q->restitution, q->high, found, error, n);
    luck_number("impacts", q->restitution, q->high, mean_impacts(q, n), 0, n);
}

/* Whether a count is what is expected, or more, but for chance. */
static int at_least(double got, double expected)
{
    return got > expected - 3.9 * sqrt(got + expected + 1);
}

/* Without a bounce the borders are smooth: an eps of a tenth makes a tenth of
 * the neighbours differ.  With 0.8 it makes more than a third of them differ.
 */
static void by_restitution(struct luck *l, struct pairs *q, int n)
{
    double last = 0;
    for (int k = 0; k < BOUNCES; ++k) {
        q->restitution = bounces[k];
        neighbours(l, q, n);
        const double wide = unlike(q, n, 0), near = unlike(q, n, 1);
        luck_claim(l, at_least(near, last), "more dust with restitution");
        if (k == 0)
            luck_claim(l,
                       at_least(near, wide / 10) && at_least(wide / 10, near),
                       "smooth borders without restitution");
        if (k == BOUNCES - 1)
            luck_claim(l, near > wide / 3 && wide > n / 4.0, "dust at 0.8");
        last = near;
    }
}

/* By height, at a restitution of 0.5. */
static void by_height(struct luck *l, struct pairs *q, int n)
{
    q->restitution = 0.5;
    for (q->low = 0; q->low < 80; q->low = q->high) {
        q->high = q->low > 0 ? 2 * q->low : 2.5;
        luck_each(n, pair, q);
        luck_share(l, "neighbour at 1e-3 by height", q->low, q->high,
                   unlike(q, n, 1), n, (double)NAN);
        luck_share(l, "neighbour at 1e-6 by height", q->low, q->high,
                   unlike(q, n, 4), n, (double)NAN);
    }
}

static void maps(void)
{
    static const double shown[4] = {0, 0.3, 0.5, 0.8};
    for (int k = 0; k < 4; ++k) {
        char title[64];
        snprintf(title, sizeof title, "spin, sqrt(g/a), at restitution %g",
                 shown[k]);
        const struct luck_map m = {title, 300, 200,  0,        20,
                                   0,     8,   cell, &shown[k]};
        luck_draw(&m);
    }
}

void luck_study(struct luck *l)
{
    if (l->map) {
        maps();
        return;
    }
    const int n = luck_count(l, 100000, 1000);
    struct pairs q = {malloc((size_t)n), malloc((size_t)n * sizeof(int)), 0, 0,
                      20};
    if (!q.others || !q.impacts)
        exit(1);
    by_restitution(l, &q, n);
    by_height(l, &q, n / 4);
    free(q.others);
    free(q.impacts);
}
