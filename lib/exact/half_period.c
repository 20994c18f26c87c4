/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/angles.h"
#include "half_period.h"

#include <math.h>
#include <string.h>

#define ELEMENT COIN_PRIV_ELEMENT

/* The largest value of a series' last terms within its reach, in radians and in
 * rates of the orbit's unit.  Measured: LAST_TERM in tests/studies/tables.md.
 */
#define LAST_TERM 1e-17

/* The longest reach of a series, times the rate W of (47).  A swing takes at
 * least pi/2 over W.  With little spin, a series of a longer reach would lead
 * past the table.  Measured: REACH_MAX in tables.md. */
#define REACH_MAX 1.2

/* A series may be used up to this many times its reach: its error is then
 * 1.05^28 = 3.9 times as large.  Measured: REACH_MARGIN in tables.md. */
#define REACH_MARGIN 1.05

/* A motion whose W exceeds that of the start by this factor is not followed:
 * powers of its rates up to COIN_PRIV_ORDER would overflow. */
#define RATE_MAX 1e8

static double wX_at(const coin_priv_point *p)
{
    return ELEMENT(p->row[1], 1);
}

coin_priv_variables coin_priv_point_variables(const coin_priv_point *p)
{
    const double c = ELEMENT(p->th, 0), s = ELEMENT(p->th, 1), q = 1 / c;
    const coin_priv_variables y = {
        wX_at(p),
        ELEMENT(p->row[2], 0),
        ELEMENT(p->row[2], 1),
        s,
        c,
        q,
        q * s,
        0,
        1,
    };
    return y;
}

static double rate2_at(const coin_priv_half_period *h, const coin_priv_point *p)
{
    const coin_priv_variables y = coin_priv_point_variables(p);
    return coin_priv_rate2(h->b.g_a, &y);
}

/* x to the power 1/COIN_PRIV_ORDER = 1/28 = 1/32 + 1/32/8 + 1/32/64 + ...  The
 * first three terms are taken.  The rest of them would change the result by at
 * most 3 % for x > 1e-190. */
static double root_28(double x)
{
    double y = sqrt(sqrt(sqrt(sqrt(sqrt(x))))), product = y;
    for (int i = 0; i < 2; ++i) {
        y = sqrt(sqrt(sqrt(y)));
        product *= y;
    }
    return product;
}

/* How far a series reaches: where its last powers come down to LAST_TERM, or
 * REACH_MAX. */
static double reach_of(const coin_priv_half_period *h,
                       const coin_priv_series *s)
{
    const coin_priv_point *p = s->at;
    double last = 1e-300; /* not 0: it divides */
    for (int k = COIN_PRIV_ORDER - 1; k <= COIN_PRIV_ORDER; ++k)
        for (int i = 0; i < COIN_PRIV_PATH; ++i) {
            const coin_priv_pair row = p[k].row[i];
            last = coin_priv_larger(last, fabs(ELEMENT(row, 0)));
            last = coin_priv_larger(last, fabs(ELEMENT(row, 1)));
        }
    const double longest = REACH_MAX / sqrt(rate2_at(h, p));
    return coin_priv_lesser(longest, root_28(LAST_TERM / last));
}

/* The root of wX between 0 and end: by Newton's method, or by halving where a
 * step would leave the bracket, which shrinks each time. */
static double root(const coin_priv_series *s, double end, double direction)
{
    double inside = 0, outside = end, t = end, step;
    do {
        double wX = 0, slope = 0;
        for (int k = COIN_PRIV_ORDER; k >= 0; --k) {
            slope = slope * t + wX;
            wX = wX * t + wX_at(&s->at[k]);
        }
        if (wX == 0)
            return t;
        if (wX * direction > 0)
            inside = t;
        else
            outside = t;
        double next = inside + (outside - inside) / 2;
        if (fabs(wX) < fabs(slope * (outside - inside))) {
            const double newton = t - wX / slope;
            next = (newton - inside) * (newton - outside) < 0 ? newton : next;
        }
        step = next - t;
        t = next;
    } while (fabs(step) > DBL_EPSILON / 2 * fabs(end));
    return t;
}

/* Normalizes the pair of the lean, and takes that of the heading from phi. */
static void normalize(coin_priv_point *p)
{
    const double c = ELEMENT(p->th, 0), s = ELEMENT(p->th, 1);
    const double more = 1 + (1 - (c * c + s * s)) / 2;
    const coin_priv_sc ph = coin_priv_sincos(ELEMENT(p->row[0], 1));
    p->th = coin_priv_pair_make(c * more, s * more);
    p->ph = coin_priv_pair_make(ph.c, ph.s);
}

/* Computes the powers of a series from its point. */
static void expand(const coin_priv_half_period *h, coin_priv_series *s)
{
    coin_priv_series_expand(s, &h->field);
    s->reach = reach_of(h, s);
}

/* Begins a series at the point that another has at a time; 0 if that point is
 * not above the table, or the coin is too fast there. */
static int begin_at(const coin_priv_half_period *h, coin_priv_series *to,
                    const coin_priv_series *from, double time)
{
    const double most = RATE_MAX * RATE_MAX;
    coin_priv_point *p = to->at;
    *p = coin_priv_series_at(from, time - from->time);
    p->row[COIN_PRIV_PATH] = coin_priv_pair_make(0, 0);
    normalize(p);
    if (!(ELEMENT(p->th, 0) > 0 && rate2_at(h, p) < most))
        return 0;
    to->time = time;
    expand(h, to);
    return 1;
}

/* Makes the series h->now a piece: the last one in time, or, if side is -1, the
 * first one.  Those before the start are kept at the end of the arrays.  The
 * path of the series is computed, and then moved so that it is at `path` at the
 * edge, the time at which the piece continues another one. */
static void add_piece(coin_priv_half_period *h, double side, double edge,
                      coin_priv_pair path)
{
    coin_orbit *o = h->o;
    const int n = side < 0 ? COIN_PRIV_PIECES - 1 - h->count : h->count;
    const double joint = edge - h->now.time;
    coin_priv_point *p = h->now.at;
    coin_priv_series_expand_path(&h->now);
    const coin_priv_pair here = coin_priv_series_path(&h->now, joint);
    p->row[COIN_PRIV_PATH] =
        coin_priv_pair_make(ELEMENT(path, 0) - ELEMENT(here, 0),
                            ELEMENT(path, 1) - ELEMENT(here, 1));
    o->private_centers[n] = h->now.time;
    o->private_edges[side < 0 ? n + 1 : n] = edge;
    coin_priv_series_economized(&h->now,
                                coin_priv_larger(h->now.reach, fabs(joint)),
                                o->private_terms + COIN_PRIV_PIECE * n);
    ++h->count;
}

/* Moves the pieces from the end of the arrays to their beginning. */
static void move_to_begin(const coin_priv_half_period *h)
{
    const int from = COIN_PRIV_PIECES - h->count;
    coin_orbit *o = h->o;
    for (int n = 0; n < h->count && from > 0; ++n) {
        double *piece = o->private_terms + COIN_PRIV_PIECE * n;
        o->private_edges[n] = o->private_edges[from + n];
        o->private_centers[n] = o->private_centers[from + n];
        memcpy(piece, piece + COIN_PRIV_PIECE * from,
               COIN_PRIV_PIECE * sizeof *piece);
    }
}

/* Whether wX changes its sign within the reach of a series. */
static int turns_within(const coin_priv_half_period *h,
                        const coin_priv_series *s, double side)
{
    const coin_priv_point p = coin_priv_series_at(s, side * s->reach);
    return !(wX_at(&p) * h->direction > 0);
}

/* Begins h->now beyond h->between, the series about the end of a piece of this
 * reach, where it reaches back to that end.  The first trial assumes that the
 * reach shrinks beyond that end as much as it did from the centre of the piece
 * to it.  Each further trial begins nearer to the end.  0 if no series can be
 * begun there. */
static int begin_beyond(coin_priv_half_period *h, double side, double reach)
{
    const coin_priv_series *at_end = &h->between;
    const double part = coin_priv_lesser(at_end->reach / reach, 1);
    double step = at_end->reach / (2 - part);
    while (begin_at(h, &h->now, at_end, at_end->time + side * step)) {
        if (step <= REACH_MARGIN * h->now.reach)
            return 1;
        step = h->now.reach;
    }
    return 0;
}

/* Adds the piece that continues the latest one.  A series about the end of that
 * leads to the new centre; if it reaches a turning point, it is the piece
 * itself.  Returns 0 if no piece can be added. */
static int add_next_piece(coin_priv_half_period *h, double side)
{
    const double reach = h->now.reach, end = h->now.time + side * reach;
    const coin_priv_pair path =
        coin_priv_series_path(&h->now, end - h->now.time);
    if (h->count == COIN_PRIV_PIECES || !begin_at(h, &h->between, &h->now, end))
        return 0;
    if (turns_within(h, &h->between, side))
        h->now = h->between;
    else if (!begin_beyond(h, side, reach))
        return 0;
    add_piece(h, side, end, path);
    return 1;
}

/* The point of h->now a time after its centre, as a turning point. */
static coin_priv_turning_point turning_point_at(const coin_priv_half_period *h,
                                                double tau)
{
    const coin_priv_point p = coin_priv_series_at(&h->now, tau);
    const coin_priv_pair path = coin_priv_series_path(&h->now, tau);
    const coin_priv_turning_point turn = {
        h->now.time + tau,    ELEMENT(p.row[0], 0), ELEMENT(p.row[0], 1),
        ELEMENT(p.row[1], 0), ELEMENT(path, 0),     ELEMENT(path, 1),
    };
    return turn;
}

/* Adds pieces from the start to the turning point on one side; 0 if none is
 * found. */
static int add_pieces(coin_priv_half_period *h, coin_priv_turning_point *turn,
                      double side)
{
    while (!turns_within(h, &h->now, side))
        if (!add_next_piece(h, side))
            return 0;
    const double end = side * h->now.reach;
    *turn = turning_point_at(h, root(&h->now, end, h->direction));
    return 1;
}

/* The largest power of two that is not above W. */
static double power_of_two(double W2)
{
    double rate = 1;
    while (rate * rate > W2)
        rate /= 2;
    while (4 * rate * rate <= W2)
        rate *= 2;
    return rate;
}

void coin_priv_half_period_begin(coin_priv_half_period *h, coin_orbit *o,
                                 const coin_state *s,
                                 const coin_priv_constants *b)
{
    const coin_priv_variables y = coin_priv_variables_of(s);
    const double rate = power_of_two(coin_priv_rate2(b->g_a, &y)),
                 unit = 1 / rate;
    coin_priv_point p;
    h->o = o;
    h->b = *b;
    h->b.GJ = b->GJ * unit * unit;
    h->b.g_a = b->g_a * unit * unit;
    h->field = coin_priv_field_of(&h->b, 1);
    h->rate = rate;
    h->count = 0;
    p.row[0] = coin_priv_pair_make(s->theta, 0);
    p.row[1] = coin_priv_pair_make(0, y.wX * unit);
    p.row[2] = coin_priv_pair_make(y.wY * unit, y.wZ * unit);
    p.row[COIN_PRIV_PATH] = coin_priv_pair_make(0, 0);
    p.th = coin_priv_pair_make(y.cth, y.sth);
    p.ph = coin_priv_pair_make(1, 0);
    h->now.at[0] = p;
    h->now.time = 0;
    expand(h, &h->now);
}

int coin_priv_half_period_solve(coin_priv_half_period *h)
{
    const double wX = wX_at(h->now.at);
    h->direction = (wX != 0 ? wX : wX_at(h->now.at + 1)) < 0 ? -1 : 1;
    add_piece(h, -1, 0, coin_priv_pair_make(0, 0));
    const coin_priv_series start = h->now;
    if (wX == 0)
        h->A = turning_point_at(h, 0);
    else if (!add_pieces(h, &h->A, -1))
        return 0;
    move_to_begin(h);
    h->now = start;
    return add_pieces(h, &h->B, 1);
}
