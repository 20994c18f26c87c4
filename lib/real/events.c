/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/root.h"
#include "move.h"

#include <string.h>

/* An event is where a function of the variables becomes negative. */
typedef double event(const coin_priv_moving *g, const double *y);

/* The places within a step at which the function is computed.  A dip between
 * them is looked for by parabolas, REFINED times.  Measured: PLACES, REFINED in
 * tables.md. */
#define PLACES 8
#define REFINED 4

/* A force counts as outside the cone of friction from this part of its terms
 * on, so that it is still outside where the state is rounded: theta by the part
 * ROUNDED/cos(theta) of cos(theta).  Measured: OUTSIDE, ROUNDED in tables.md.
 */
#define OUTSIDE 1e-12
#define ROUNDED 1e-15

/* An event is located to within LOCATED times tol of the step's length.
 * Measured: LOCATED in tables.md. */
#define LOCATED 1e-3

static double above_flat(const coin_priv_moving *g, const double *y)
{
    return y[COIN_PRIV_C] - g->law.flat;
}

/* On either side of nearly flat, until just beyond it. */
static double this_side(const coin_priv_moving *g, const double *y)
{
    const double above = y[COIN_PRIV_C] - COIN_PRIV_NEARLY_FLAT;
    return (g->was & COIN_NEARLY_FLAT ? -above : above) + COIN_PRIV_BEYOND;
}

/* On this side of upright, of a coin with a thickness. */
static double this_rim(const coin_priv_moving *g, const double *y)
{
    return g->law.eta > 0 ? y[COIN_PRIV_S] : -y[COIN_PRIV_S];
}

/* The speed of a slow slip, with its sign. */
static double slow_speed(const double *y)
{
    const double uX = y[COIN_PRIV_UX], uh = y[COIN_PRIV_UH];
    return sqrt(uX * uX + uh * uh) - 1;
}

/* Until the energy is so far below that of balancing that it is so where the
 * members are rounded too. */
static double undecided(const coin_priv_moving *g, const double *y)
{
    double at[COIN_PRIV_READ];
    coin_priv_coin c;
    memcpy(at, y, sizeof at);
    if (g->slow > 0)
        coin_priv_end_slow(g, at);
    coin_priv_normalize_pair(&at[COIN_PRIV_SPH], &at[COIN_PRIV_CPH]);
    coin_priv_set_contact(&c, at, g->law.eta);
    return coin_priv_undecided(&c, &g->law) + 4 * COIN_PRIV_BEYOND;
}

static double above_rest(const coin_priv_moving *g, const double *y)
{
    (void)g;
    return coin_priv_lesser(coin_priv_upright_speed(y), 1) -
           COIN_PRIV_SLIP_LEAST;
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

/* Whether a slow slip goes on, and is not twice as fast as slow. */
static double stays_slow(const coin_priv_moving *g, const double *y)
{
    const double u = slow_speed(y);
    return coin_priv_lesser(u + LOCATED * g->tol, 2 * g->slow - u);
}

/* The function of an event, by the part of the step. */
struct looked_for {
    event *of;
    coin_priv_moving *g;
};

COIN_PRIV_INLINE double value(const void *event_of, double x)
{
    const struct looked_for *const e = (const struct looked_for *)event_of;
    double y[COIN_PRIV_WIDE];
    coin_priv_read_within(y, &e->g->step, x);
    coin_priv_normalize_pair(&y[COIN_PRIV_S], &y[COIN_PRIV_C]);
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

/* Whether cos theta is taken to stay above a limit.  Measured: stays_above() in
 * tables.md. */
static int stays_above(const coin_priv_dop853 *w, double limit)
{
    return coin_priv_lesser(w->y[COIN_PRIV_C], w->end[COIN_PRIV_C]) > 2 * limit;
}

/* Whether the force surely stays within the cone of friction: it may dip
 * between the ends by an eighth of its second derivative, which is taken to be
 * at most stride^2, and by what they differ.  While the contact is held it is a
 * quarter (test_slide_flat). Measured: stays_within() in tables.md. */
static int stays_within(const coin_priv_moving *g, double stride)
{
    const coin_priv_dop853 *w = &g->step;
    if (g->law.keeps_rolling)
        return 1;
    const double m0 = g->margin;
    const double m1 = coin_priv_contact_margin(w->end, &g->law, g->mode);
    const double least = m0 < m1 ? m0 : m1;
    const double part = g->mode & COIN_PRIV_HELD ? 0.25 : 0.125;
    return least > fabs(m1 - m0) + part * (stride * stride);
}

/* Whether a coin with a thickness may pass upright in the step, by a bound as
 * that of stays_within(). */
static int may_pass_upright(const coin_priv_moving *g, double stride)
{
    if (g->law.eta == 0)
        return 0;
    const double s0 = this_rim(g, g->step.y), s1 = this_rim(g, g->step.end);
    return coin_priv_lesser(s0, s1) <= (fabs(s1 - s0) + stride * stride) / 8;
}

/* Whether a slow slip grows from the start of the step to its end. */
static int grows_slowly(const coin_priv_moving *g)
{
    const double *y = g->step.y, *d = g->step.slope[0];
    const double u0 = slow_speed(y), u1 = slow_speed(g->step.end);
    const double grows =
        y[COIN_PRIV_UX] * d[COIN_PRIV_UX] + y[COIN_PRIV_UH] * d[COIN_PRIV_UH];
    return grows >= 0 && u1 >= u0 && u1 <= 2 * g->slow;
}

/* The events that the step may have. */
static int list_events(event *of[8], const coin_priv_moving *g, double stride)
{
    const coin_priv_dop853 *const w = &g->step;
    int n = 0;
    if (!stays_above(w, g->law.flat))
        of[n++] = above_flat;
    if (g->stop & COIN_NEARLY_FLAT && !stays_above(w, COIN_PRIV_NEARLY_FLAT))
        of[n++] = this_side;
    if (g->law.plain && coin_priv_upright_speed(w->end) < COIN_PRIV_SLIP_LEAST)
        of[n++] = above_rest;
    if (may_pass_upright(g, stride))
        of[n++] = this_rim;
    if (g->stop & COIN_DECIDED && undecided(g, w->end) < 0)
        of[n++] = undecided;
    if (!stays_within(g, stride))
        of[n++] = within_cone;
    if (g->mode & COIN_PRIV_HELD)
        of[n++] = can_hold;
    if (g->slow > 0 && !grows_slowly(g))
        of[n++] = stays_slow;
    return n;
}

int coin_priv_first_event(double *cut, coin_priv_moving *g, double stride)
{
    event *of[8];
    double x = 2;
    const int n = list_events(of, g, stride);
    for (int i = 0; i < n; ++i) {
        const double at = first_zero(of[i], g);
        x = coin_priv_lesser(at, x);
    }
    if (x > 1)
        return 0;
    coin_priv_within(cut, &g->step, x);
    return 1;
}
