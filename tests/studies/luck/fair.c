/* SPDX-License-Identifier: MIT */
/* A US quarter that a hand throws on a table: does it forget with which side it
 * began?  It is fair if it begins with either side as often: tails follow heads
 * by symmetry, and a row claims that.
 *
 * The hand lets go 0.3 to 0.5 m above the table with either side up, within 0.2
 * rad of flat, at 1.5 to 2.5 m/s upward and up to 0.3 m/s along.  The coin
 * turns 15 to 40 times a second about an axis in its plane, and by up to 20
 * rad/s about its own: so the angle of precession is 67 degrees or more.  A
 * gentle hand lets go lower and slower. */
#include "luck.h"

#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979324
#define TOL 1e-6

struct hand {
    int *heads, *same; /* of each toss: as it ended */
    unsigned draw;     /* others for each hand */
    double low, high;  /* height of the centre, m */
    double up;         /* times the speeds */
    double turn;       /* times the rates of turning */
    double restitution, mu;
};

static double drawn(const struct hand *h, int i, unsigned k, double low,
                    double high)
{
    return luck_random(i, 16 * h->draw + k, low, high);
}

static coin_body thrown(const struct hand *h, int i)
{
    const double about = drawn(h, i, 0, 0, 2 * PI);
    const double side = drawn(h, i, 10, 0, 1) < 0.5 ? -1 : 1; /* heads: -1 */
    const double W = 2 * PI * drawn(h, i, 1, 15, 40) * h->turn;
    const coin_body b = {
        .s = {.theta = side * (LUCK_FLAT - drawn(h, i, 2, 0, 0.2)),
              .phi = drawn(h, i, 3, -PI, PI),
              .psi = drawn(h, i, 4, -PI, PI),
              .wX = W * cos(about),
              .wY = W * sin(about),
              .wZ = drawn(h, i, 5, -20, 20) * h->turn},
        .y = drawn(h, i, 6, h->low, h->high),
        .vx = drawn(h, i, 7, -0.3, 0.3),
        .vy = drawn(h, i, 8, 1.5, 2.5) * h->up,
        .vz = drawn(h, i, 9, -0.3, 0.3)};
    return b;
}

static coin_table table_of(const struct hand *h, const coin_params *p)
{
    coin_table table = {.mu_static = 1.2 * h->mu,
                        .mu_kinetic = h->mu,
                        .restitution = h->restitution};
    table.losses.dry = 5e-3 * p->mass * p->gravity * p->radius;
    table.losses.flat = 1e-3;
    return table;
}

static void toss(void *of, int i)
{
    const struct hand *h = of;
    const coin_params p = luck_quarter();
    const coin_table table = table_of(h, &p);
    const coin_body b = thrown(h, i);
    h->heads[i] = luck_toss(b, &p, &table, TOL).heads;
    h->same[i] = h->heads[i] == (b.s.theta < 0);
}

static int sum(const int *holds, int n)
{
    int all = 0;
    for (int i = 0; i < n; ++i)
        all += holds[i];
    return all;
}

/* How many of n show the side with which they began. */
static int same_of(struct luck *l, struct hand *h, int n, const char *what,
                   double x)
{
    ++h->draw;
    luck_each(n, toss, h);
    luck_share(l, "heads", x, h->restitution, sum(h->heads, n), n, 0.5);
    luck_share(l, what, x, h->restitution, sum(h->same, n), n, (double)NAN);
    return sum(h->same, n);
}

static void hands(struct luck *l, struct hand *h, int n)
{
    static const double restitutions[] = {0, 0.3, 0.5, 0.7};
    for (int k = 0; k < 4; ++k) {
        h->restitution = restitutions[k];
        same_of(l, h, n, "same side of a hand by friction", h->mu);
    }
    h->restitution = 0.5;
    for (h->mu = 0.1; h->mu < 0.5; h->mu *= 2)
        same_of(l, h, n, "same side of a hand by friction", h->mu);
    h->mu = 0.3;
}

/* With so many times the height and the energy of a hand. */
static void gentle(struct luck *l, struct hand *h, int n)
{
    const double a = luck_quarter().radius;
    for (double part = 1. / 256; part <= 1; part *= 2) {
        h->low = 0.3 * part + a / 2;
        h->high = 0.5 * part + a / 2;
        h->up = h->turn = sqrt(part);
        const int got = same_of(l, h, n, "same side of a gentle hand", part);
        if (part < 1. / 200)
            luck_claim(l, got > 0.8 * n, "a gentle hand remembers");
    }
}

void luck_study(struct luck *l)
{
    if (l->map)
        return;
    const int n = luck_count(l, 10000, 200);
    int *ends = malloc(2 * (size_t)n * sizeof *ends);
    struct hand h = {ends, ends + n, 0, 0.3, 0.5, 1, 1, 0.5, 0.3};
    if (!ends)
        exit(1);
    hands(l, &h, n);
    gentle(l, &h, n);
    free(ends);
}
