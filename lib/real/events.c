/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "move.h"

/* An event is where a function of the variables becomes negative. */
typedef double event(const coin_priv_moving *g, const double *y);

/* The places within a step at which the function is computed.  A dip between
 * them is looked for by parabolas, REFINED times unless the first shows that
 * the function stays above SHALLOW of what it changes by. */
#define PLACES 8
#define REFINED 4
#define SHALLOW 0.1

/* A force counts as outside the cone of friction from this part of its terms
 * on, so that it is still outside where the state is rounded: theta by the part
 * ROUNDED/cos(theta) of cos(theta). */
#define OUTSIDE 1e-12
#define ROUNDED 1e-15

/* An event is located to this part of tol, and of the step. */
#define LOCATED 1e-3

/* The most trials of locate(). */
#define TRIALS 60

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

/* A place in a step, and the function there. */
struct place {
    double x, at;
};

static double value(event *of, coin_priv_moving *g, double *y, double x)
{
    coin_priv_within(y, &g->step, x);
    coin_priv_normalize_pairs(y); /* as the step does that ends there */
    return of(g, y);
}

/* A place just after the event, which lies between a, where the function is not
 * negative, and b, where it is.  By the method of Illinois. */
static double locate(event *of, coin_priv_moving *g, struct place a,
                     struct place b)
{
    const double width = LOCATED * g->tol + 4 * DBL_EPSILON;
    double y[COIN_PRIV_WIDE];
    int before = 0;
    for (int i = 0; i < TRIALS && b.x - a.x > width; ++i) {
        double x = a.x + (b.x - a.x) * (a.at / (a.at - b.at));
        x = i % 4 == 3 ? (a.x + b.x) / 2 : x;
        x = x < a.x + width / 2 ? a.x + width / 2 : x;
        x = x > b.x - width / 2 ? b.x - width / 2 : x;
        const double at = value(of, g, y, x);
        const int side = at < 0 ? -1 : 1;
        const struct place c = {x, at};
        if (side < 0) {
            a.at *= before == side ? 0.5 : 1;
            b = c;
        } else {
            b.at *= before == side ? 0.5 : 1;
            a = c;
        }
        before = side;
    }
    return b.x;
}

/* The lowest place of a parabola through three, in the middle of which the
 * function is lowest, or near to it. */
static double lowest(const struct place p[3])
{
    const double a = p[1].x - p[0].x, b = p[2].x - p[1].x;
    const double before = (p[1].at - p[0].at) / a;
    const double after = (p[2].at - p[1].at) / b;
    const double bend = (after - before) / (a + b);
    return bend > 0 ? p[1].x - (before + bend * a) / (2 * bend) : 2;
}

/* Looks for a dip of the function below 0 between the first and the last of
 * three places, at which it is not negative: 1 and *dip if there is one.  The
 * parabola is taken REFINED times, each time through nearer places. */
static int find_dip(struct place *dip, event *of, coin_priv_moving *g,
                    const struct place from[3])
{
    struct place p[3] = {from[0], from[1], from[2]};
    double y[COIN_PRIV_WIDE];
    for (int i = 0; i < REFINED; ++i) {
        const double x = lowest(p);
        if (!(x > p[0].x && x < p[2].x) || x == p[1].x)
            return 0;
        const struct place at = {x, value(of, g, y, x)};
        *dip = at;
        if (at.at < 0)
            return 1;
        if (i == 0 && at.at > SHALLOW * (fabs(from[0].at - at.at) +
                                         fabs(from[2].at - at.at)))
            return 0;
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
 * there is none. */
static double first_zero(event *of, coin_priv_moving *g)
{
    struct place p[PLACES + 1], dip;
    double y[COIN_PRIV_WIDE];
    for (int k = 0; k <= PLACES; ++k) {
        p[k].x = (double)k / PLACES;
        p[k].at = value(of, g, y, p[k].x);
        if (k > 1 && p[k - 2].at >= 0 && p[k - 1].at >= 0 &&
            find_dip(&dip, of, g, &p[k - 2]))
            return locate(of, g, p[dip.x < p[k - 1].x ? k - 2 : k - 1], dip);
        if (k > 0 && p[k - 1].at >= 0 && p[k].at < 0)
            return locate(of, g, p[k - 1], p[k]);
    }
    return 2;
}

/* Whether cos theta surely stays above a limit. */
static int stays_above(const coin_priv_dop853 *w, double limit)
{
    const double c0 = w->y[COIN_PRIV_C], c1 = w->end[COIN_PRIV_C];
    const double fall = w->y[COIN_PRIV_S] * w->y[COIN_PRIV_WX];
    const double later = w->end[COIN_PRIV_S] * w->end[COIN_PRIV_WX];
    const double least = c0 < c1 ? c0 : c1;
    return least > 2 * limit || (least > limit && !(fall > 0 && later < 0));
}

/* Whether the force surely stays within the cone of friction: it may dip
 * between the ends by an eighth of its second derivative, which is taken to be
 * at most 2 stride^2. */
static int stays_within(const coin_priv_moving *g, double stride)
{
    const coin_priv_dop853 *w = &g->step;
    if (g->law.held_down)
        return 1;
    const double m0 = g->margin;
    const double m1 = coin_priv_contact_margin(w->end, &g->law, g->mode);
    const double least = m0 < m1 ? m0 : m1;
    return least > 4 * fabs(m1 - m0) + 0.25 * stride * stride;
}

int coin_priv_first_event(double *cut, coin_priv_moving *g, double stride)
{
    double x = 2;
    if (!stays_above(&g->step, g->law.flat))
        x = first_zero(above_flat, g);
    if (g->stop & COIN_NEARLY_FLAT &&
        !stays_above(&g->step, COIN_PRIV_NEARLY)) {
        const double at = first_zero(above_nearly_flat, g);
        x = at < x ? at : x;
    }
    if (!stays_within(g, stride)) {
        const double at = first_zero(within_cone, g);
        x = at < x ? at : x;
    }
    if (x > 1)
        return 0;
    coin_priv_within(cut, &g->step, x);
    return 1;
}
