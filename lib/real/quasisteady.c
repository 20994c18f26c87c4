/* SPDX-License-Identifier: MIT */
/* A coin with small losses moves slowly along the steady motions, Eq. (39).
 * Its slow motion has smooth equations, (74), and no step has to resolve a
 * swing or a turn. */
#include "../motion/pinned.h"

#include "../motion/rest.h"
#include "../motion/state.h"

#include "gbs.h"
#include "losses.h"
#include "steady_near.h"

/* The part of the angle from flat up to which a swing is small. */
#define SWING 0.1

/* The error that a step may have, relative or absolute; and the lengths of the
 * first step along the arc, and of the shortest one over ROOT.  Where a shorter
 * one would be needed, the steady motion becomes unstable. */
#define ERROR 1e-12
#define FIRST 0.05
#define SHORTEST 1e-6
/* The most steps, those refused included: 0.2 s.  Some 30 lead to rest. */
#define TRIES_MAX 32768

#define NEWTONS_MAX 40 /* the most iterations of shorten_to_time() */

/* A step may lessen ROOT, sqrt(cos theta), by the part PART.  Below END times
 * the ROOT of the start the time left is taken as ROOT over its rate. */
#define PART 0.7
#define END 1e-5

#define NO_ROLL 1e-14 /* a roll below this part of its terms is rounding */

/* Where ROOT decreases by less than this per length of arc, PART is unused. */
#define NEVER 1e-30

/* The longest time that is followed and the fastest rate, in natural units.  No
 * product overflows with them. */
#define LONGEST 1e150
#define FASTEST 1e40

/* A trial has failed where sine and root, each at most 1, add to more. */
#define RUNAWAY 4.0

/* If the heading changes by more than this from one point of the path to the
 * next, the path between them is computed from its curvature at both, else from
 * its length. */
#define TURN 1.0

/* 1 over the largest factor of coin_losses_fit().  The product of this factor
 * and COIN_PRIV_LOSS_MOST does not overflow. */
#define FACTOR_LEAST 1e-240

/* The variables, in natural units: sine of the lean and root of its cosine; the
 * rates; the time; heading, roll and length of the path. */
enum { STH, ROOT, WY, WZ, TIME, PHI, PSI, WAY, VARIABLES };

struct quasisteady {
    coin_priv_body b;
    coin_priv_losses l;
    double w0;    /* 1 over the natural unit of time */
    double least; /* the least growth of the arc in a natural unit of time */
};

/* d/dt in natural units. */
struct rates {
    double dtheta, dwY, dwZ; /* NaN where the steady motion is not stable */
};

static struct rates rates_of(const double *y, const struct quasisteady *q)
{
    const coin_priv_body *b = &q->b;
    const double s = y[STH], c = y[ROOT] * y[ROOT], w0 = q->w0;
    const coin_priv_variables at = {0, w0 * y[WY], w0 * y[WZ], s, c,
                                    0, 0,          0,          1};
    const coin_priv_slowing slow = coin_priv_slowing_of(&q->l, &at);
    const double wY = y[WY], wZ = y[WZ], T = s / c;
    const double torque_Y = slow.wY / (c * w0 * w0);   /* over I_X */
    const double torque_Z = slow.wZ / (c * w0 * w0);   /* over K */
    const double F_Y = 2 * b->IX * T * wY + b->K * wZ; /* (74) */
    const double F_Z = b->K * wY;
    const double F_th = b->IX * wY * wY / (c * c) - b->m * c;
    /* -J lambda^2: > 0 while the steady motion is stable. */
    const double room = F_th + F_Y * (wY * T + b->k1 * wZ) + F_Z * b->k2 * wY;
    const double dtheta = isgreater(room, 0) /* (74) */
                              ? -(F_Y * torque_Y + F_Z * torque_Z) / room
                              : (double)NAN;
    const struct rates d = {
        dtheta, (wY * T + b->k1 * wZ) * dtheta + torque_Y, /* (74) */
        b->k2 * wY * dtheta + torque_Z,                    /* (74) */
    };
    return d;
}

/* Derivatives by the length of the arc of the motion in the space of ROOT and
 * the rates.  A step then takes a long time where the motion changes slowly,
 * and a short one where the end is near.  q->least times the time is added to
 * this length, so that it grows by at least 1 until a given time.  Otherwise a
 * coin with pivoting friction, which approaches a circle without losses, would
 * never reach that time. */
static void slopes(double *dy, const double *y, const void *problem)
{
    /* A trial of a step that is far too long must not overflow. */
    if (!isless(fabs(y[STH]) + fabs(y[ROOT]), RUNAWAY)) {
        for (int i = 0; i < VARIABLES; ++i)
            dy[i] = (double)NAN;
        return;
    }
    const struct rates d = rates_of(y, (const struct quasisteady *)problem);
    const double s = y[STH], root = y[ROOT], c = root * root;
    const double droot = -s * d.dtheta / (2 * root);
    const double arc2 = droot * droot + d.dwY * d.dwY / (1 + y[WY] * y[WY]) +
                        d.dwZ * d.dwZ / (1 + y[WZ] * y[WZ]);
    const double least = ((const struct quasisteady *)problem)->least;
    const double dt = 1 / (least + sqrt(arc2));
    dy[STH] = c * d.dtheta * dt;
    dy[ROOT] = droot * dt;
    dy[WY] = d.dwY * dt;
    dy[WZ] = d.dwZ * dt;
    dy[TIME] = dt;
    dy[PHI] = y[WY] / c * dt;
    dy[PSI] = (y[WZ] + y[WY] * s / c) * dt;
    dy[WAY] = y[WZ] * dt;
}

/* A coin on its way through steady motions. */
struct passing {
    struct quasisteady q;
    double y[VARIABLES];
    double x, z; /* of the centre, in radii, from the start */
};

/* Adds the centre's path from the variables before to those now.  It is NaN
 * once the heading has left its range. */
static void draw(struct passing *g, const double *before)
{
    const double *y = g->y;
    if (!(fabs(y[PHI]) + fabs(before[PHI]) <= 2 * COIN_PRIV_ANGLE_MAX)) {
        g->x = g->z = (double)NAN;
        return;
    }
    const double turn = y[PHI] - before[PHI];
    if (fabs(turn) < TURN) {
        const double half = turn / 2;
        const double sinc = half == 0 ? 1 : coin_priv_sincos(half).s / half;
        const double way = (y[WAY] - before[WAY]) * sinc;
        const coin_priv_sc along = coin_priv_sincos(before[PHI] + half);
        g->x -= way * along.c;
        g->z += way * along.s;
        return;
    }
    for (int end = 0; end < 2; ++end) {
        const double *at = end ? y : before;
        const double radius = at[WZ] * at[ROOT] * at[ROOT] / at[WY];
        const coin_priv_sc to = coin_priv_sincos(at[PHI]);
        g->x += (end ? -radius : radius) * to.s;
        g->z += (end ? -radius : radius) * to.c;
    }
}

/* Begins at the steady motion next to *s, or returns COIN_EDOMAIN. */
static int32_t begin(struct passing *g, const coin_state *s,
                     const coin_params *p)
{
    coin_state near = *s;
    double lambda2 = 0;
    const int32_t status = coin_priv_steady_near(&near, &g->q.b);
    if (status != COIN_OK)
        return status;
    (void)coin_stability(&near, p, &lambda2);
    const coin_priv_sc th = coin_priv_sincos(near.theta);
    const coin_priv_sc from_flat = {th.c, fabs(th.s)};
    const double most = SWING * coin_priv_angle(from_flat);
    const double lean = fabs(s->theta - near.theta);
    const double fastest2 = -lambda2 * (most + lean) * (most - lean);
    if (!(s->wX * s->wX < fastest2)) /* > 0 only where lambda^2 < 0 */
        return COIN_EDOMAIN;
    const double w0 = g->q.w0 = sqrt(g->q.b.g_a);
    if (!(fabs(near.wY) + fabs(near.wZ) <= FASTEST * w0))
        return COIN_EDOMAIN;
    const double y[VARIABLES] = {th.s, sqrt(th.c), near.wY / w0, near.wZ / w0,
                                 0,    s->phi,     s->psi,       0};
    for (int i = 0; i < VARIABLES; ++i)
        g->y[i] = y[i];
    g->x = g->z = 0;
    return COIN_OK;
}

/* The longest step from here towards flat. */
static double longest(const struct passing *g)
{
    double d[VARIABLES];
    slopes(d, g->y, &g->q);
    return isless(d[ROOT], -NEVER) ? -PART * g->y[ROOT] / d[ROOT]
                                   : (double)INFINITY;
}

/* Shortens a step h from the variables before so that it ends at the time t, to
 * rounding: by Newton's method, or by halving where that would leave the step.
 * Near the end the time hardly grows with the arc. */
static void shorten_to_time(double *y, const double *before,
                            const struct quasisteady *q, double h, double t)
{
    double least = 0, most = h;
    for (int i = 0; i < NEWTONS_MAX; ++i) {
        double d[VARIABLES];
        const double off = y[TIME] - t; /* may be NaN */
        if (islessequal(fabs(off), 4 * DBL_EPSILON * t))
            break;
        *(islessequal(off, 0) ? &least : &most) = h;
        slopes(d, y, q);
        h -= off / d[TIME];
        if (!(isgreater(h, least) && isless(h, most)))
            h = (least + most) / 2;
        for (int k = 0; k < VARIABLES; ++k)
            y[k] = before[k];
        (void)coin_priv_gbs(y, VARIABLES, slopes, q, h);
    }
    y[TIME] = t;
}

/* Goes on to the time t, at most LONGEST: COIN_OK, or COIN_RESTS and the time
 * then, or COIN_EDOMAIN where the motion becomes unstable, or after too many
 * steps. */
static int32_t pass(struct passing *g, double t)
{
    double h = FIRST;
    const double end = END * g->y[ROOT];
    g->q.least = 1 / (t + DBL_MIN); /* t may be 0 */
    for (int tries = 0; g->y[ROOT] > end && g->y[TIME] < t; ++tries) {
        double next[VARIABLES], before[VARIABLES];
        const double most = longest(g);
        if (tries == TRIES_MAX)
            return COIN_EDOMAIN;
        h = h < most ? h : most;
        for (int k = 0; k < VARIABLES; ++k)
            next[k] = before[k] = g->y[k];
        const double error = coin_priv_gbs(next, VARIABLES, slopes, &g->q, h);
        if (!islessequal(error, ERROR)) {
            h /= 2;
            if (h < SHORTEST * g->y[ROOT])
                return COIN_EDOMAIN;
            continue;
        }
        if (next[TIME] > t)
            shorten_to_time(next, before, &g->q, h, t);
        for (int k = 0; k < VARIABLES; ++k)
            g->y[k] = next[k];
        draw(g, before);
        h *= error < ERROR / 1000 ? 1.5 : 1;
    }
    if (!(g->y[TIME] < t))
        return COIN_OK;
    double d[VARIABLES];
    slopes(d, g->y, &g->q);
    g->y[TIME] += -g->y[ROOT] * d[TIME] / d[ROOT];
    return COIN_RESTS;
}

/* theta of its pair, at most the last lean. */
static double lean_of(double sth, double cth)
{
    const coin_priv_sc pair = {sth, cth};
    const double theta = coin_priv_angle(pair), most = COIN_PRIV_LAST_LEAN;
    return theta > most ? most : theta < -most ? -most : theta;
}

/* The state now. */
static coin_state state_of(const struct passing *g, const coin_state *s,
                           int rests)
{
    const double *y = g->y, w0 = g->q.w0, a = g->q.b.a;
    const double side = y[STH] < 0 ? -1 : 1, root = rests ? 0 : y[ROOT];
    const coin_state at = {
        lean_of(rests ? side : y[STH], root * root),
        y[PHI],
        y[PSI],
        s->x + a * g->x,
        s->z + a * g->z,
        rests ? 0 : w0 * rates_of(y, &g->q).dtheta,
        rests ? 0 : w0 * y[WY],
        w0 * y[WZ],
    };
    return at;
}

static int32_t check(struct quasisteady *q, const coin_state *s,
                     const coin_params *p, const coin_losses *l)
{
    if (!s || !p || !l)
        return COIN_EARG;
    if (coin_losses_check(l, p) != COIN_OK)
        return COIN_EPARAMS;
    const int32_t status = coin_priv_check(s, p, &q->b);
    if (status == COIN_OK)
        (void)coin_priv_losses_of(&q->l, l, &q->b);
    return status;
}

/* Whether the losses stop a coin in steady motion: one acts that is no pivoting
 * friction, and the contact moves, or pivoting friction will make it move. */
static int stops(const struct passing *g)
{
    const coin_priv_losses *l = &g->q.l;
    const double *y = g->y, c = y[ROOT] * y[ROOT];
    const double terms = fabs(c * y[WZ]) + fabs(y[STH] * y[WY]);
    const double u = coin_priv_roll_speed(y[WY], y[WZ], y[STH], c);
    return l->solid + l->fluid + l->damping > 0 &&
           (fabs(u) > NO_ROLL * terms || l->spin > 0);
}

static int32_t time_to_rest(double *time, const coin_state *s,
                            const coin_params *p, const coin_losses *l)
{
    struct passing g;
    int32_t status = check(&g.q, s, p, l);
    if (status != COIN_OK)
        return status;
    *time = 0;
    if (coin_priv_lies_flat(s))
        return COIN_RESTS;
    status = begin(&g, s, p);
    if (status != COIN_OK)
        return status;
    *time = (double)INFINITY;
    if (!stops(&g))
        return COIN_RESTS;
    status = pass(&g, LONGEST);
    *time = g.y[TIME] / g.q.w0;
    return status == COIN_OK ? COIN_EDOMAIN : status;
}

double coin_time_to_rest(const coin_state *s, const coin_params *p,
                         const coin_losses *l)
{
    double time;
    return time_to_rest(&time, s, p, l) == COIN_RESTS ? time : (double)NAN;
}

int32_t coin_losses_fit(coin_losses *l, const coin_state *s,
                        const coin_params *p, double time)
{
    double now;
    if (!(time > 0 && time - time == 0))
        return COIN_EARG;
    int32_t status = time_to_rest(&now, s, p, l);
    if (status < 0)
        return status;
    if (!(now > 0 && now * FACTOR_LEAST < time))
        return COIN_EDOMAIN;
    /* All slopes of the slow motion are proportional to the losses. */
    const double factor = now / time;
    double all[] = {l->damping, l->dry,     l->viscous, l->layer,
                    l->gap,     l->rolling, l->spin};
    int lost = 0; /* whether one becomes subnormal */
    for (int i = 0; i < 7; ++i) {
        lost |= all[i] > 0 && all[i] * factor < DBL_MIN;
        all[i] *= factor;
    }
    const coin_losses scaled = {all[0], all[1], all[2], all[3],
                                all[4], all[5], all[6], l->soft};
    if (lost || coin_losses_check(&scaled, p) != COIN_OK)
        return COIN_EDOMAIN;
    *l = scaled;
    return COIN_OK;
}

int32_t coin_quasisteady_at(const coin_state *s, const coin_params *p,
                            const coin_losses *l, double t, coin_state *out)
{
    struct passing g;
    int32_t status = out ? check(&g.q, s, p, l) : COIN_EARG;
    if (status == COIN_OK && !(t >= 0 && t - t == 0))
        status = COIN_ESTEP;
    if (status != COIN_OK)
        return status;
    coin_state at = *s;
    if (coin_priv_lies_flat(s)) {
        at.wX = 0;
        *out = at;
        return COIN_RESTS;
    }
    status = begin(&g, s, p);
    if (status != COIN_OK)
        return status;
    if (!(stops(&g) || g.q.l.spin > 0)) {
        (void)coin_priv_steady_near(&at, &g.q.b);
        return coin_steady_at(&at, p, t, out);
    }
    /* By LONGEST a coin that does not rest has left the range of angles. */
    status = pass(&g, t < LONGEST / g.q.w0 ? t * g.q.w0 : LONGEST);
    if (status < 0)
        return status;
    at = state_of(&g, s, status == COIN_RESTS);
    if (coin_priv_check_members(&at) != COIN_OK)
        return COIN_ESTEP;
    *out = at;
    return status;
}
