/* SPDX-License-Identifier: MIT */
/* Each rim is a point contact with Coulomb's friction.  Where a rim would have
 * to pull, the coin tips over the other one.
 *
 * The variables of a step are wY, wZ and the slip velocity of the middle of the
 * line, uX, uh; the rims slip at uX + h wY and uX - h wY along e_X, and both at
 * uh across. */
#include "../motion/pinned.h"

#include "line.h"

#include <string.h>

/* The rims, as places of an array, and where they lie along e_Z. */
enum { RIMS = 2 };
static const double side[RIMS] = {1, -1};

/* The mode of a step on the line: STICKS << i, the rim i sticks; CREEP << i, it
 * creeps: it slips so slowly that its slip has the direction of its slope; else
 * it slips. */
enum { STICKS = 1, BOTH = 3, CREEP = 4, BOTH_CREEP = 12 };

/* A mode ends beyond PAST, and what rounding makes of the direction of a
 * slip. */
#define PAST 1e-12
#define ROUNDED (16 * DBL_EPSILON)

/* As ESTIMATE and SHORTEST of move.c. */
#define ESTIMATE 2.0
#define SHORTEST 0.03

/* What bounds the length of a step.
 * FIRST: the first step takes at most so many times the time in which the
 * motion changes.  A frame of a roll is then one step. STABLE: a step takes at
 * most so many times the time in which the losses slow the coin: so a rate that
 * is far below tol still decays as it should, until the coin rests. REACH: a
 * slip of the speed u loses at most this part of u in a step. WIDTH: a roll
 * loses at most this part of its rate, or of `soft`, within which dry friction
 * changes. */
#define FIRST 4
#define STABLE 1
#define REACH 0.8
#define WIDTH 0.5

/* A slip slower than STOPS tol ends, if the table can hold it.
 *
 * A rim that begins to slip creeps in its first step: its slip keeps the
 * direction in which it begins.  That step ends before the slip is faster than
 * twice CREEPS tol^(5/8).  The error of the direction then changes the motion
 * by less than tol.
 *
 * A step may err by at most SHARE of the slowest slip.  Larger errors would
 * keep a slow slip alive that the table hardly slows.  It would then go on in
 * very many short steps. */
#define STOPS 0.01
#define CREEPS 0.1
#define SHARE 0.01

/* Passes in which an onset is found, Newton's steps in each, and a friction
 * that is not 0. */
#define PASSES 8
#define NEWTON 6
#define TINY 1e-50

/* What acts besides friction. */
struct free_line {
    double X, h, Y, Z;  /* slopes of uX, uh, h wY, wZ */
    double both, apart; /* what a friction of 1 along e_X adds to uX, h wY */
    double spun;        /* the moment of spin about e_X */
};

/* What friction does at the two ends. */
struct ends {
    struct free_line f;
    coin_priv_direction F[RIMS], n[RIMS]; /* forces; directions of slips */
    double N[RIMS];
    double grows; /* the slope of the speed of a rim that creeps */
    double slack; /* of the moments: below 0 it tips */
    int over;     /* and over which rim */
    double past;  /* the mode ends where slack, or the cone, is below -past */
    int mode;
    int stops; /* rims whose slip is none: they stick, or begin to creep */
};

static struct free_line free_of(const double *y, const coin_priv_law *l)
{
    const coin_priv_direction g = coin_priv_pull_of(y, l);
    const double wY = y[COIN_PRIV_WY], wZ = y[COIN_PRIV_WZ];
    const double lost =
        l->lossy ? coin_priv_grip(l, wZ, 1) / l->IZ + l->angular : 0;
    const struct free_line r = {
        g.X - wY * y[COIN_PRIV_UH] - lost * wZ,
        g.h + wY * (y[COIN_PRIV_UX] - wZ),
        -(l->spin / l->IX + l->angular) * l->half * wY,
        -lost * wZ,
        1 + 1 / l->IZ,
        l->half * l->half / l->IX,
        l->IZ * wY * wZ,
    };
    return r;
}

/* The slip of a rim, or its slope. */
static coin_priv_direction slip(const double *y, double half, int rim)
{
    const coin_priv_direction u = {
        y[COIN_PRIV_UX] + side[rim] * half * y[COIN_PRIV_WY], y[COIN_PRIV_UH]};
    return u;
}

static double length_of(coin_priv_direction u)
{
    return sqrt(u.X * u.X + u.h * u.h);
}

static double sum_of_speeds(const double *y)
{
    return 1 + fabs(y[COIN_PRIV_WY]) + fabs(y[COIN_PRIV_WZ]) +
           fabs(y[COIN_PRIV_UX]) + fabs(y[COIN_PRIV_UH]);
}

/* The normal forces, where the moment of friction and spin about e_X is M with
 * all weight on the rim + or -. */
static void share(struct ends *e, double half, double plus, double minus)
{
    const double to_plus = half - plus, to_minus = minus + half;
    e->slack = coin_priv_lesser(to_plus, to_minus) / half;
    e->over = to_plus < to_minus ? 1 : -1;
    e->N[0] =
        e->slack < 0 ? to_plus < to_minus : to_minus / (to_plus + to_minus);
    e->N[1] = 1 - e->N[0]; /* (134) */
}

/* Friction k of a rim along -n. */
static void rub(struct ends *e, int rim, double k)
{
    e->F[rim].X = -k * e->n[rim].X;
    e->F[rim].h = -k * e->n[rim].h;
}

/* The direction of a slip that begins, where P would have to be held, with the
 * inertia 1/D along e_X against a friction k; and its slope, below 0 if k could
 * hold P. */
static coin_priv_direction onset(coin_priv_direction P, double D, double k,
                                 double *grows)
{
    coin_priv_direction n = {0, 0};
    *grows = 0;
    k = coin_priv_larger(k, TINY);
    for (int i = 0; i <= NEWTON; ++i) {
        const double X = *grows + D * k, h = *grows + k;
        n.X = D * P.X / X; /* (138) */
        n.h = P.h / h;     /* (138) */
        const double z = length_of(n);
        if (i < NEWTON)
            *grows +=
                (z - 1) * (z * z) / (n.X * n.X / X + n.h * n.h / h + DBL_MIN);
    }
    return n;
}

/* One rim sticks, or creeps, and the other one slips.  Where u_h grows by
 * `across`.  Returns what it then grows by. */
static double hold(struct ends *e, const coin_priv_law *l, int mode,
                   double across)
{
    const struct free_line *const f = &e->f;
    const int i = (mode & (STICKS | CREEP)) != 0 ? 0 : 1, j = 1 - i;
    const double D = f->both + f->apart, mu = l->mu_kinetic;
    const double M = f->h - f->spun - across;
    share(e, l->half, M, M);
    rub(e, j, mu * e->N[j]);
    const coin_priv_direction P = {
        (f->X + side[i] * f->Y + (f->both - f->apart) * e->F[j].X) / D,
        f->h + e->F[j].h}; /* (136) */
    e->F[i].X = -P.X;
    e->F[i].h = -P.h;
    if (mode & BOTH)
        return 0;
    e->n[i] = onset(P, D, mu * e->N[i], &e->grows);
    rub(e, i, mu * e->N[i]);
    return e->grows * e->n[i].h;
}

/* A rim creeps: what u_h grows by changes the normal forces, which change
 * that. */
static void creep(struct ends *e, const coin_priv_law *l, int mode)
{
    double x = 0, off = hold(e, l, mode, 0), to = off / 2;
    for (int i = 0; i < PASSES && off != 0 && to != x; ++i) {
        const double next = hold(e, l, mode, to) - to;
        const double slope = (next - off) / (to - x);
        x = to;
        off = next;
        to = slope < 0 ? x - off / slope : x;
    }
}

/* Both rims stick. */
static void roll_force(struct ends *e, double half)
{
    const double M = e->f.h - e->f.spun;
    share(e, half, M, M);
    e->F[0].X = e->F[1].X = -e->f.X / (2 * e->f.both); /* (135) */
    e->F[0].h = e->F[1].h = -e->f.h / 2;
}

/* Both rims slip, or begin to: then against the force that would hold them. */
static void slide(struct ends *e, const coin_priv_law *l, int begins)
{
    const double mu = l->mu_kinetic;
    const coin_priv_direction P = {e->f.X / e->f.both, e->f.h};
    if (begins)
        e->n[0] = e->n[1] = onset(P, e->f.both, mu, &e->grows);
    for (int i = 0; i < RIMS && e->grows < 0; ++i) {
        e->n[i].X = P.X / mu;
        e->n[i].h = P.h / mu;
    }
    share(e, l->half, mu * e->n[0].h - e->f.spun, mu * e->n[1].h - e->f.spun);
    for (int i = 0; i < RIMS; ++i)
        rub(e, i, mu * e->N[i]); /* (137) */
}

/* Friction in a mode. */
COIN_PRIV_NOINLINE struct ends ends_of(const double *y, const coin_priv_law *l,
                                       int mode)
{
    struct ends e;
    memset(&e, 0, sizeof e);
    e.f = free_of(y, l);
    e.mode = mode;
    e.past = PAST;
    if (mode == BOTH) {
        roll_force(&e, l->half);
        return e;
    }
    for (int i = 0; i < RIMS; ++i) {
        const coin_priv_direction u = slip(y, l->half, i);
        const double per = 1 / coin_priv_larger(length_of(u), TINY);
        e.n[i].X = u.X * per;
        e.n[i].h = u.h * per;
        if (!(mode & (STICKS | CREEP) << i))
            e.past += ROUNDED * sum_of_speeds(y) * per;
    }
    if (mode & BOTH)
        (void)hold(&e, l, mode, 0);
    else if (mode && mode != BOTH_CREEP)
        creep(&e, l, mode);
    else
        slide(&e, l, mode);
    return e;
}

/* How far the friction that the sticking rims need is below what the table can
 * give, as a part of mu where that exceeds 1; below 0 a rim begins to slip.  A
 * rim without weight slips, whatever mu is. */
static double cone_of(const struct ends *e, double mu)
{
    const int mode = e->mode;
    const double of_N = coin_priv_lesser(1, mu), per = of_N < mu ? 1 / mu : 1;
    if (!(mode & BOTH))
        return 1;
    if (mode != BOTH) {
        const double N = e->N[mode - 1], F = length_of(e->F[mode - 1]);
        return coin_priv_lesser(N > 0 ? 1 : e->slack, of_N * N - per * F);
    }
    const double x = per * fabs(e->F[0].X);
    double least = 1, across = -2 * per * fabs(e->F[0].h);
    for (int i = 0; i < RIMS; ++i) {
        const double rest = of_N * e->N[i] - x;
        least = coin_priv_lesser(least, rest);
        across += rest > 0 ? sqrt(rest * (rest + 2 * x)) : 0;
    }
    return coin_priv_lesser(least, across); /* (139) */
}

/* Whether dry friction and the two ends hold a coin that does not move. */
static int holds(const double *y, const coin_priv_law *l)
{
    const coin_priv_direction g = coin_priv_pull_of(y, l);
    struct ends e;
    e.mode = BOTH;
    e.F[0].X = -g.X / 2;
    e.F[0].h = -g.h / 2;
    share(&e, l->half, g.h, g.h);
    return fabs(g.X) <= l->dry + l->rolling &&
           cone_of(&e, l->mu_static) >= -PAST;
}

/* Sets the slopes by t under the forces of the ends. */
static void slopes(double *d, const double *y, const coin_priv_law *l,
                   const struct ends *e)
{
    const double wY = y[COIN_PRIV_WY], wZ = y[COIN_PRIV_WZ];
    const double vX = y[COIN_PRIV_UX] - wZ, vh = y[COIN_PRIV_UH];
    const double sph = y[COIN_PRIV_SPH], cph = y[COIN_PRIV_CPH];
    const double X = e->F[0].X + e->F[1].X;
    memset(d, 0, COIN_PRIV_WIDE * sizeof *d);
    d[COIN_PRIV_WY] = (e->f.Y + e->f.apart * (e->F[0].X - e->F[1].X)) / l->half;
    d[COIN_PRIV_WZ] = e->f.Z + X / l->IZ;
    d[COIN_PRIV_UX] = e->f.X + e->f.both * X;
    d[COIN_PRIV_UH] = e->f.h + e->F[0].h + e->F[1].h;
    d[COIN_PRIV_SPH] = wY * cph;
    d[COIN_PRIV_CPH] = -wY * sph;
    d[COIN_PRIV_ADDS_PHI] = wY;
    d[COIN_PRIV_ADDS_PSI] = wZ;
    d[COIN_PRIV_ADDS_X] = vX * cph + vh * sph;
    d[COIN_PRIV_ADDS_Z] = vh * cph - vX * sph;
    d[COIN_PRIV_ADDS_T] = 1;
}

/* Nothing where the mode has ended: so a step that would pass its end is tried
 * again, half as long. */
static int line_slopes(double *d, const double *y, const coin_priv_problem *of)
{
    const coin_priv_law *const l = of->law;
    const struct ends e = ends_of(y, l, of->mode);
    const double least = coin_priv_lesser(e.slack, cone_of(&e, l->mu_static));
    for (int i = 0; i < RIMS; ++i)
        if (of->mode & CREEP << i && length_of(slip(y, l->half, i)) > of->limit)
            return 0;
    if (d && least >= -2 * e.past)
        slopes(d, y, l, &e);
    return least >= -2 * e.past;
}

/* The same of a coin that rolls straight on.  Slower than of->limit it rests.
 */
static int roll_slopes(double *d, const double *y, const coin_priv_problem *of)
{
    const coin_priv_law *const l = of->law;
    const double wZ = y[COIN_PRIV_WZ];
    const double lost =
        l->lossy ? coin_priv_grip(l, wZ, 1) + l->angular * l->IZ : 0;
    if (!(fabs(wZ) >= of->limit))
        return 0;
    if (!d)
        return 1;
    memset(d, 0, COIN_PRIV_WIDE * sizeof *d);
    d[COIN_PRIV_WZ] = -(coin_priv_pull_of(y, l).X + lost * wZ) / l->K[0];
    d[COIN_PRIV_ADDS_PSI] = wZ;
    d[COIN_PRIV_ADDS_X] = -wZ * y[COIN_PRIV_CPH];
    d[COIN_PRIV_ADDS_Z] = wZ * y[COIN_PRIV_SPH];
    d[COIN_PRIV_ADDS_T] = 1;
    return 1;
}

/* The speed below which a slip that begins creeps. */
static double creep_speed(double tol)
{
    const double r = sqrt(tol);
    return CREEPS * (r * sqrt(sqrt(r)));
}

/* The slip of which a rim counts as sticking, if it can be held: in a call, or,
 * with tol 0, of a body. */
static double least_slip(const double *y, double half, double tol)
{
    return COIN_PRIV_SLIP_LEAST + STOPS * tol +
           ROUNDED * (1 + half) *
               (fabs(y[COIN_PRIV_WY]) + fabs(y[COIN_PRIV_WZ]));
}

/* What the rims do. */
static struct ends ends_now(const double *y, const coin_priv_law *l, double tol)
{
    const double least = least_slip(y, l->half, tol);
    int mode = 0;
    for (int i = 0; i < RIMS; ++i)
        mode |= (length_of(slip(y, l->half, i)) <= least) << i;
    struct ends e = ends_of(y, l, mode);
    if (cone_of(&e, l->mu_static) < -PAST)
        e = ends_of(y, l, CREEP * mode);
    e.stops = mode;
    return e;
}

/* Stops slips that are none, by blows of friction: the coin loses the energy
 * that such slips have. */
static void stop(double *y, const coin_priv_law *l, const struct ends *e)
{
    const int mode = e->stops;
    const double u =
        mode == BOTH ? y[COIN_PRIV_UX] : slip(y, l->half, mode - 1).X;
    const double X = u / (mode == BOTH ? e->f.both : e->f.both + e->f.apart);
    y[COIN_PRIV_UX] -= e->f.both * X;
    y[COIN_PRIV_WZ] -= X / l->IZ;
    y[COIN_PRIV_WY] -= mode == BOTH ? y[COIN_PRIV_WY]
                                    : side[mode - 1] * e->f.apart * X / l->half;
    y[COIN_PRIV_UH] = 0;
}

/* The longest time up to h in which a slope leads at most by `most`. */
static double within(double h, double most, double slope)
{
    return h * slope > most ? most / slope : h;
}

/* The longest step. */
static double longest(const coin_priv_moving *g)
{
    const double *const y = g->step.y, *const d = g->step.slope[0];
    const coin_priv_law *const l = &g->law;
    const int mode = g->step.of.mode;
    const double wZ = y[COIN_PRIV_WZ], roll = sqrt(wZ * wZ + l->soft * l->soft);
    double h =
        within(g->stride, STABLE, coin_priv_loss_rate(y, l, mode != BOTH));
    if (l->dry + l->rolling > 0)
        h = within(h, WIDTH * roll, fabs(d[COIN_PRIV_WZ]));
    for (int i = 0; i < RIMS; ++i) {
        if (mode & (STICKS | CREEP) << i)
            continue;
        h = within(h, REACH * length_of(slip(y, l->half, i)),
                   length_of(slip(d, l->half, i)));
    }
    return h;
}

/* The speed of the rim that slips slowest. */
static double slowest(const double *y, double half, int mode)
{
    double u = (double)INFINITY;
    for (int i = 0; i < RIMS; ++i)
        if (!(mode & (STICKS | CREEP) << i))
            u = coin_priv_lesser(u, length_of(slip(y, half, i)));
    return u;
}

/* Tries a step, and takes it if it is good. */
static int32_t line_step(coin_priv_moving *g)
{
    coin_priv_dop853 *const w = &g->step;
    const double left = coin_priv_time_left(g);
    (void)w->of.rates(w->slope[0], w->y, &w->of);
    const double most_h = longest(g);
    const int ends = most_h >= left;
    const double h = ends ? left : most_h;
    const double error = coin_priv_try_step(w, h);
    const double most =
        coin_priv_lesser(ESTIMATE * g->tol * coin_priv_larger(h, SHORTEST),
                         SHARE * slowest(w->y, g->law.half, w->of.mode)) +
        4 * DBL_EPSILON * sum_of_speeds(w->y);
    const double by = coin_priv_lesser(4, coin_priv_next_length(error, most));
    --g->tries;
    if (error <= most) {
        g->stride = ends ? g->stride : h * by;
        return coin_priv_accept(g, w->end, ends);
    }
    g->stride = h * coin_priv_lesser(by, 0.5);
    return COIN_OK;
}

/* Whether a rim that is to stick slips faster than that of a body may. */
static int stops(const double *y, double half, int mode)
{
    const double least = least_slip(y, half, 0);
    return (mode & 1 && length_of(slip(y, half, 0)) > least) ||
           (mode & 2 && length_of(slip(y, half, 1)) > least);
}

/* Whether a coin that rolls has come to rest. */
static int has_stopped(coin_priv_moving *g)
{
    double *const wZ = &g->step.y[COIN_PRIV_WZ];
    if (fabs(*wZ) > COIN_PRIV_SLIP_LEAST || !holds(g->step.y, &g->law))
        return 0;
    g->changed |= *wZ != 0;
    *wZ = 0;
    return 1;
}

/* The rim over which it tips, or 0. */
static int rim_of_tip(const struct ends *e)
{
    return e->slack < -e->past ? e->over : 0;
}

/* Why the coin does not go on in its mode, if it does not.  begins: it has not
 * moved yet. */
static int look(coin_priv_moving *g, int begins, int *over)
{
    double *const y = g->step.y;
    const struct ends e = ends_now(y, &g->law, g->tol);
    const int changes =
        begins ? stops(y, g->law.half, e.stops) : e.mode != g->step.of.mode;
    g->step.of.mode = e.mode;
    *over = rim_of_tip(&e);
    if (e.stops) /* before it tips too: over a rim that rolls */
        stop(y, &g->law, &e);
    g->changed |= changes;
    if (*over && e.stops == BOTH)
        g->was &= ~COIN_SLIPS; /* no slip ends */
    if (*over)
        return COIN_PRIV_LINE_TIPS;
    return changes                            ? COIN_PRIV_LINE_CHANGES
           : e.mode == BOTH && has_stopped(g) ? COIN_PRIV_LINE_RESTS
                                              : COIN_PRIV_LINE_GOES;
}

static int32_t go(coin_priv_moving *g, int *why, int *over)
{
    coin_priv_problem *const of = &g->step.of;
    int32_t status = COIN_OK;
    *why = look(g, 1, over);
    of->rates = of->mode == BOTH ? roll_slopes : line_slopes;
    of->limit = of->mode != BOTH ? 2 * creep_speed(g->tol)
                : holds(g->step.y, &g->law)
                    ? (1 - g->tol) * COIN_PRIV_SLIP_LEAST
                    : 0;
    g->stride = FIRST / sum_of_speeds(g->step.y);
    while (status == COIN_OK && *why == COIN_PRIV_LINE_GOES && g->tries > 0 &&
           coin_priv_time_left(g) > 0) {
        status = line_step(g);
        *why = look(g, 0, over);
    }
    return status;
}

static void begin_line(coin_priv_moving *g)
{
    const coin_priv_rim u = coin_priv_rim_of(&g->c, 0);
    const double slip_of[2] = {u.X, u.h};
    g->law.eta = 0;
    coin_priv_begin(g, 0, slip_of);
}

int32_t coin_priv_move_on_line(coin_priv_moving *g, int *why, int *over)
{
    const int before = g->changed;
    g->changed = 0;
    begin_line(g);
    const int32_t status = go(g, why, over);
    if (g->changed)
        coin_priv_end(g);
    g->changed |= before;
    return status;
}

static struct ends ends_at(const coin_priv_coin *c, const coin_priv_law *l,
                           int *rests)
{
    coin_priv_moving g;
    g.law = *l;
    g.c = *c;
    begin_line(&g);
    *rests = fabs(c->wZ) <= COIN_PRIV_SLIP_LEAST && holds(g.step.y, l);
    return ends_now(g.step.y, l, 0);
}

int coin_priv_tips(const coin_priv_coin *c, const coin_priv_law *l)
{
    int rests;
    const struct ends e = ends_at(c, l, &rests);
    return rim_of_tip(&e);
}

int coin_priv_line_mode(const coin_priv_coin *c, const coin_priv_law *l)
{
    int rests;
    const struct ends e = ends_at(c, l, &rests);
    return e.mode != BOTH ? COIN_PRIV_SLIPS : rests ? COIN_PRIV_RESTS : 0;
}

coin_priv_push coin_priv_line_push(const coin_priv_coin *c,
                                   const coin_priv_law *l)
{
    int rests;
    const struct ends e = ends_at(c, l, &rests);
    const coin_priv_push r = {1, e.F[0].X + e.F[1].X, e.F[0].h + e.F[1].h};
    return r;
}
