/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "move.h"

/* An event is where a function of the variables becomes negative. */
typedef double event(const coin_priv_moving *g, const double *y);

/* The places within a step at which the function is computed.  A dip between
 * them is looked for by parabolas, REFINED times.  Of 6,000 calls in which F/N
 * passes mu_static by 1e-5 to 1e-2 of it, 56 miss that; with half of PLACES 78,
 * with twice of it 52, with half of REFINED 68.  Twice the places cost 29 %
 * more (make tuning). */
#define PLACES 8
#define REFINED 4

/* A force counts as outside the cone of friction from this part of its terms
 * on, so that it is still outside where the state is rounded: theta by the part
 * ROUNDED/cos(theta) of cos(theta).  With a hundred times OUTSIDE, moments at
 * which slips begin err 6 to 20 times as much at 1e-9; a hundredth of it and of
 * ROUNDED errs the same (make tuning). */
#define OUTSIDE 1e-12
#define ROUNDED 1e-15

/* An event is located to LOCATED tol of the step: far below tol.  A
 * tenth or ten times of it changes neither cost nor errors (make tuning). */
#define LOCATED 1e-3

static double above_flat(const coin_priv_moving *g, const double *y)
{
    return y[COIN_PRIV_C] - g->law.flat;
}

static double above_nearly_flat(const coin_priv_moving *g, const double *y)
{
    (void)g;
    return y[COIN_PRIV_C] - COIN_PRIV_NEARLY;
}

static double within_cone(const coin_priv_moving *g, const double *y)
{
    return coin_priv_contact_margin(y, &g->law, g->mode) + OUTSIDE +
           ROUNDED / y[COIN_PRIV_C];
}

static double can_hold(const coin_priv_moving *g, const double *y)
{
    return coin_priv_hold_margin(y, &g->law, g->mode, g->tol);
}

/* The function of an event, by the part of the step. */
struct looked_for {
    event *of;
    coin_priv_moving *g;
};

static double value(const void *event_of, double x)
{
    const struct looked_for *const e = (const struct looked_for *)event_of;
    double y[COIN_PRIV_WIDE];
    coin_priv_within(y, &e->g->step, x);
    coin_priv_normalize_pairs(y); /* as the step does that ends there */
    return e->of(e->g, y);
}

/* Where a parabola through three places is lowest; 2 if it has no least. */
static double lowest(const coin_priv_place p[3])
{
    const double a = p[1].x - p[0].x, b = p[2].x - p[1].x;
    const double before = (p[1].at - p[0].at) / a;
    const double after = (p[2].at - p[1].at) / b;
    const double bend = (after - before) / (a + b);
    return bend > 0 ? p[1].x - (before + bend * a) / (2 * bend) : 2;
}

/* Looks for a dip of the function below 0 between the first and the last of
 * three places, not negative at the first two: 1 and *dip if there is one.  The
 * parabola is taken REFINED times, each time through nearer places. */
static int find_dip(coin_priv_place *dip, const struct looked_for *e,
                    const coin_priv_place from[3])
{
    coin_priv_place p[3] = {from[0], from[1], from[2]};
    for (int i = 0; i < REFINED; ++i) {
        const double x = lowest(p);
        if (!((x - p[0].x) * (p[2].x - x) * fabs(x - p[1].x) > 0))
            return 0;
        const coin_priv_place at = {x, value(e, x)};
        *dip = at;
        if (at.at < 0)
            return 1;
        if (at.at < p[1].at) {
            p[x < p[1].x ? 2 : 0] = p[1];
            p[1] = at;
        } else {
            p[x < p[1].x ? 0 : 2] = at;
        }
    }
    return 0;
}

/* The first place in the step at which the function becomes negative; 2 if
 * there is none.  It is 2 also if the function is negative at the start: the
 * margin is, of a slipping coin which the table no longer presses, but which
 * would fall back at once (coin_priv_leaves()). */
static double first_zero(event *of, coin_priv_moving *g)
{
    const struct looked_for e = {of, g};
    const double width = LOCATED * g->tol + 4 * DBL_EPSILON;
    coin_priv_place p[PLACES + 1], dip;
    p[0].x = 0;
    p[0].at = value(&e, 0);
    if (p[0].at < 0)
        return 2;
    for (int k = 1; k <= PLACES; ++k) {
        p[k].x = (double)k / PLACES;
        p[k].at = value(&e, p[k].x);
        if (k > 1 && find_dip(&dip, &e, &p[k - 2]))
            return coin_priv_root(
                value, &e, p[dip.x < p[k - 1].x ? k - 2 : k - 1], dip, width);
        if (p[k].at < 0)
            return coin_priv_root(value, &e, p[k - 1], p[k], width);
    }
    return 2;
}

/* Whether cos theta is taken to stay above a limit.  From 1 to 4 times the
 * limit no motion of make tuning depends on it. */
static int stays_above(const coin_priv_dop853 *w, double limit)
{
    return coin_priv_lesser(w->y[COIN_PRIV_C], w->end[COIN_PRIV_C]) > 2 * limit;
}

/* Whether the force surely stays within the cone of friction: it may dip
 * between the ends by an eighth of its second derivative, which is taken to be
 * at most stride^2, and by what they differ.  None of 773,680 steps of random
 * launches leaves the cone farther.  A quarter costs 14 % more; with a
 * sixteenth 7 more slips of make tuning are missed. */
static int stays_within(const coin_priv_moving *g, double stride)
{
    const coin_priv_dop853 *w = &g->step;
    if (g->law.keeps_rolling)
        return 1;
    const double m0 = g->margin;
    const double m1 = coin_priv_contact_margin(w->end, &g->law, g->mode);
    const double least = m0 < m1 ? m0 : m1;
    return least > fabs(m1 - m0) + stride * stride / 8;
}

int coin_priv_first_event(double *cut, coin_priv_moving *g, double stride)
{
    double x = 2;
    if (!stays_above(&g->step, g->law.flat))
        x = first_zero(above_flat, g);
    if (g->stop & COIN_NEARLY_FLAT &&
        !stays_above(&g->step, COIN_PRIV_NEARLY)) {
        const double at = first_zero(above_nearly_flat, g);
        x = coin_priv_lesser(at, x);
    }
    if (!stays_within(g, stride)) {
        const double at = first_zero(within_cone, g);
        x = coin_priv_lesser(at, x);
    }
    if (g->mode & COIN_PRIV_HELD) {
        const double at = first_zero(can_hold, g);
        x = coin_priv_lesser(at, x);
    }
    if (x > 1)
        return 0;
    coin_priv_within(cut, &g->step, x);
    return 1;
}
