/* SPDX-License-Identifier: MIT */
/* A three-sided coin: how often does a thick coin land on its edge?  It is a
 * uniform cylinder with sharp rims, on a rigid table.  h is its thickness over
 * its diameter, and radius, mass and gravity are 1.
 *
 * A toss is followed until its energy is too low to turn over a rim.  One that
 * still rolls on its side then can no longer fall over, and counts as edge.
 *
 * The static rule: each pose is as likely, and the coin drops without turning,
 * bouncing or slipping.  Then it ends on the side above which its centre comes
 * down: the edge has the part h/sqrt(1 + h^2) of the circumscribed sphere. */
#include "luck.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define PI 3.14159265358979324
#define TOL 1e-6

static const double thickness[] = {0.092, 0.2,  0.3, 0.4,  0.5,
                                   0.577, 0.65, 0.7, 0.75, 0.85};
#define THICKNESSES ((int)(sizeof thickness / sizeof *thickness))

struct scene {
    int *faces; /* of each toss, as it ended */
    coin_params p;
    coin_table table;
    double height, turn, along; /* 0 for a drop of the static rule */
    unsigned draw;              /* others for each point */
};

static double drawn(const struct scene *s, int i, unsigned k, double low,
                    double high)
{
    return luck_random(i, 16 * s->draw + k, low, high);
}

/* Any pose; the centre is `height` above that of a coin that balances on a rim,
 * within a quarter. */
static coin_body let_go(const struct scene *s, int i)
{
    const double w = s->turn, v = s->along;
    const coin_body b = {.s = {.theta = asin(drawn(s, i, 0, -1, 1)),
                               .phi = drawn(s, i, 1, -PI, PI),
                               .psi = drawn(s, i, 2, -PI, PI),
                               .wX = drawn(s, i, 3, -w, w),
                               .wY = drawn(s, i, 4, -w, w),
                               .wZ = drawn(s, i, 5, -w, w)},
                         .y = hypot(1, s->p.thickness / 2) +
                              s->height * drawn(s, i, 6, 0.75, 1.25),
                         .vx = drawn(s, i, 7, -v, v),
                         .vz = drawn(s, i, 8, -v, v)};
    return b;
}

static void toss(void *of, int i)
{
    struct scene *s = of;
    coin_body b = let_go(s, i);
    int32_t status = 0;
    while (!(status & (COIN_DECIDED | COIN_RESTS))) {
        status =
            coin_move(&b, &s->p, &s->table, INFINITY, TOL, COIN_DECIDED, NULL);
        if (status < 0) {
            fprintf(stderr, "toss %d: %s\n", i, coin_status_string(status));
            exit(1);
        }
    }
    s->faces[i] = coin_body_face(&b, &s->p);
}

static int count(const int *of, int n, int what)
{
    int all = 0;
    for (int i = 0; i < n; ++i)
        all += of[i] == what;
    return all;
}

/* The share on the edge of a coin of this h.  Those that are not show heads as
 * often as tails, by symmetry. */
static double edges(struct luck *l, struct scene *s, int n, const char *what,
                    double h, double expected)
{
    coin_params_cylinder(&s->p, 1, 1, 2 * h, 1);
    ++s->draw;
    luck_each(n, toss, s);
    const int edge = count(s->faces, n, COIN_EDGE);
    const double mu = s->table.mu_kinetic;
    luck_share(l, what, h, mu, edge, n, expected);
    luck_share(l, "heads of the others", h, mu, count(s->faces, n, COIN_HEADS),
               n - edge, 0.5);
    return (double)edge / n;
}

static void statics(struct luck *l, struct scene *s, int n)
{
    static const double h[] = {0.2, 0.354, 0.577};
    s->table.mu_static = INFINITY;
    s->table.mu_kinetic = 1;
    s->height = s->turn = s->along = 0;
    for (int k = 0; k < 3; ++k)
        edges(l, s, n, "static rule", h[k], h[k] / hypot(1, h[k]));
}

/* The share against thickness, and where it passes a third. */
static void curve(struct luck *l, struct scene *s, int n, const char *what)
{
    double before = 0;
    for (int k = 0; k < THICKNESSES; ++k) {
        const double h = thickness[k];
        const double now = edges(l, s, n, what, h, (double)NAN);
        if (before < 1. / 3 && now >= 1. / 3) {
            const double slope = (now - before) / (h - thickness[k - 1]);
            luck_number("a third on its edge", s->table.mu_kinetic,
                        s->table.losses.angular, h - (now - 1. / 3) / slope,
                        sqrt(2. / 9 / n) / slope, n);
        }
        before = now;
    }
}

static void tosses(struct luck *l, struct scene *s, int n, const char *what)
{
    s->height = 10;
    s->turn = 5;
    s->along = 1;
    s->table.restitution = 0.5;
    for (int tenths = 1; tenths <= 3; ++tenths) {
        s->table.mu_kinetic = tenths / 10.;
        s->table.mu_static = 1.1 * s->table.mu_kinetic;
        curve(l, s, n, what);
    }
}

void luck_study(struct luck *l)
{
    if (l->map)
        return;
    const int n = luck_count(l, 4000, 100);
    const int drops = luck_count(l, 10000, 1000);
    int *ends = malloc((size_t)drops * sizeof *ends);
    struct scene s = {.faces = ends,
                      .table = {.losses = {.dry = 2e-3, .spin = 0.02}}};
    if (!ends)
        exit(1);
    statics(l, &s, drops);
    tosses(l, &s, n, "dry");
    s.table.losses.dry = 0;
    s.table.losses.angular = 0.02;
    tosses(l, &s, n, "angular");
    free(ends);
}
