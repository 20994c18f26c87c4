/* SPDX-License-Identifier: MIT */
/* A coin that is caught in the air, at the height at which it was let go: which
 * side is up?
 *
 * Keller, Am. Math. Monthly 93 (1986) 191: it turns about a diameter, and the
 * side is that of cos(w t), t = 2 u/g.  Diaconis, Holmes and Montgomery, SIAM
 * Rev. 49 (2007) 211: its axis goes round the angular momentum, at an angle psi
 * from it; if every part of a turn is as likely, the share that shows the side
 * with which it began is 1/2 + asin(cot(psi)^2)/pi, or 1 below 45 degrees. */
#include "luck.h"

#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979324

/* Where no table is near, for so long. */
static int heads_after(coin_body b, double t)
{
    const coin_params p = luck_disc();
    const coin_table table = {0};
    b.y = 1e4;
    return coin_move(&b, &p, &table, t, 1e-9, 0, NULL) >= 0 && b.s.theta < 0;
}

/* ------------------------------------------------------------------ Keller */
/* It rises by `height` radii, and turns with `spin`. */
static double turned(double height, double spin)
{
    return 2 * sqrt(2 * height) * spin;
}

static int keller_heads(double height, double spin)
{
    coin_body b = luck_flat(0, spin);
    b.vy = sqrt(2 * height);
    return heads_after(b, 2 * b.vy);
}

static struct luck_end keller_cell(const void *of, double height, double spin)
{
    const int heads = keller_heads(height, spin);
    const int turns = (int)(turned(height, spin) / PI);
    const struct luck_end end = {heads, turns % 2 == !heads ? turns : turns + 1,
                                 0};
    (void)of;
    return end;
}

struct cells {
    int *holds;
    double spin;
};

static void keller_one(void *of, int i)
{
    const double height = luck_random(i, 0, 0, 40);
    const double spin = luck_random(i, 1, 0, 16);
    struct cells *c = of;
    c->holds[i] = keller_heads(height, spin) == (cos(turned(height, spin)) > 0);
}

/* A hand whose height and spin are within a tenth of these. */
static void keller_hand(void *of, int i)
{
    struct cells *c = of;
    c->holds[i] = keller_heads(luck_random(i, 2, 0.95, 1.05) * 20,
                               luck_random(i, 3, 0.95, 1.05) * c->spin);
}

static int sum(const int *holds, int n)
{
    int all = 0;
    for (int i = 0; i < n; ++i)
        all += holds[i];
    return all;
}

static void keller(struct luck *l, int *holds, int n)
{
    struct cells c = {holds, 0};
    luck_each(n, keller_one, &c);
    luck_share(l, "the side of cos(w t)", 0, 0, sum(holds, n), n, 1);
    for (c.spin = 1; c.spin < 200; c.spin *= 4) {
        luck_each(n, keller_hand, &c);
        luck_share(l, "heads of a hand", 20, c.spin, sum(holds, n), n,
                   c.spin > 200 / 4 ? 0.5 : (double)NAN);
    }
}

/* --------------------------------------------------------------- same side */
static double law(double psi)
{
    const double cot = cos(psi) / sin(psi);
    return psi <= PI / 4 ? 1 : 0.5 + asin(cot * cot) / PI;
}

struct cone {
    int *same;
    unsigned draw; /* others for each angle */
    double psi;
};

/* Heads up and horizontal, with an angular momentum psi from the axis; caught
 * after 10 to 20 rounds of the axis, every part of one as likely. */
static void same_one(void *of, int i)
{
    struct cone *c = of;
    const coin_params p = luck_disc();
    const double l = luck_random(i, c->draw, 20, 60); /* L/I_X */
    coin_body b = luck_flat(0, l * sin(c->psi));
    b.s.wZ = l * cos(c->psi) * p.inertia_X / p.inertia_Z;
    c->same[i] =
        heads_after(b, 2 * PI / l * luck_random(i, c->draw + 1, 10, 20));
}

static void same_side(struct luck *l, int *same, int n)
{
    static const double degrees[] = {30, 40, 44, 46, 48,    50,    52, 55, 60,
                                     65, 70, 75, 78, 79.95, 80.99, 83, 86, 90};
    struct cone c = {same, 4, 0};
    for (size_t k = 0; k < sizeof degrees / sizeof *degrees; ++k) {
        c.psi = degrees[k] * PI / 180;
        c.draw += 2;
        luck_each(n, same_one, &c);
        luck_share(l, "same side", degrees[k], 0, sum(same, n), n, law(c.psi));
    }
}

void luck_study(struct luck *l)
{
    static const struct luck_map map = {
        "spin, sqrt(g/a)", 560, 360, 0, 40, 0, 16, keller_cell, NULL};
    if (l->map) {
        luck_draw(&map);
        return;
    }
    const int n = luck_count(l, 1000000, 20000);
    int *holds = malloc((size_t)n * sizeof *holds);
    if (!holds)
        exit(1);
    keller(l, holds, n);
    same_side(l, holds, n);
    free(holds);
}
