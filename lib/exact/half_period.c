/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/angles.h"
#include "half_period.h"

#include <math.h>

#define OF COIN_PRIV_OF

/* The largest value of a series' last terms within its reach.  A tenth needs 8
 * % more pieces for the same errors.  With 100 times as much the errors of 500
 * random orbits double, for 13 % fewer pieces (make tuning). */
#define LEFT_OUT 1e-17

/* The longest reach of a series, times the rate W of W2_of().  A swing takes at
 * least pi/2 over W.  With little spin, a series of a longer reach would lead
 * past the table.  Half of it adds 0.5 % to the pieces (make tuning). */
#define LONGEST 1.2

/* A series may be used up to this many times its reach: its error is then
 * 1.05^28 = 3.9 times as large.  With 1.01 or 1.2 the pieces and errors are the
 * same within 1 % (make tuning). */
#define BEYOND 1.05

/* A motion whose W exceeds that of the start by this factor is not followed:
 * powers of its rates up to COIN_PRIV_ORDER would overflow. */
#define FASTEST 1e8

static double wX_of(const coin_priv_point *p)
{
    return OF(p->row[1], 1);
}

/* W^2 of (47), with g/a in the place of g/(a cos theta). */
static double W2_of(const coin_priv_half_period *h, const coin_priv_point *p)
{
    const double wX = wX_of(p), c = OF(p->th, 0);
    const double wY = OF(p->row[2], 0), wZ = OF(p->row[2], 1);
    return (wX * wX + wY * wY) / (c * c) + wZ * wZ + h->g_a; /* (47) */
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

/* How far a series reaches: where its last powers come down to LEFT_OUT. */
static double reach_of(const coin_priv_half_period *h,
                       const coin_priv_series *s)
{
    const coin_priv_point *p = s->at;
    double last = 0;
    for (int k = COIN_PRIV_ORDER - 1; k <= COIN_PRIV_ORDER; ++k)
        for (int i = 0; i < COIN_PRIV_PATH; ++i) {
            const coin_priv_pair row = p[k].row[i];
            last = coin_priv_larger(last, fabs(OF(row, 0)));
            last = coin_priv_larger(last, fabs(OF(row, 1)));
        }
    const double longest = LONGEST / sqrt(W2_of(h, p));
    /* A limit that keeps its power, 1e280 at most, from overflowing. */
    const double most = longest < 1e10 ? longest : 1e10;
    double power = 1;
    for (int k = 0; k < COIN_PRIV_ORDER; ++k)
        power *= most;
    return last * power <= LEFT_OUT ? most : root_28(LEFT_OUT / last);
}

double coin_priv_point_fall(const coin_priv_field *field,
                            const coin_priv_point *p)
{
    const double s = OF(p->th, 1), tan = s / OF(p->th, 0);
    const double wY = OF(p->row[2], 0), wZ = OF(p->row[2], 1);
    return field->GJ * s -
           (field->KJ * wZ + field->XJ * wY * tan) * wY; /* (14) */
}

double coin_priv_point_fall_slope(const coin_priv_field *field,
                                  const coin_priv_point *p)
{
    const double c = OF(p->th, 0), tan = OF(p->th, 1) / c;
    const double wY = OF(p->row[2], 0), wZ = OF(p->row[2], 1);
    const double dwY = wY * tan + field->k1 * wZ; /* (15) over wX */
    const double dwZ = field->k2 * wY;            /* (16) over wX */
    return field->GJ * c - field->KJ * (dwY * wZ + wY * dwZ) -
           field->XJ * wY * (2 * dwY * tan + wY * (1 + tan * tan)); /* (44) */
}

/* The root of wX between 0 and end: by Newton's method, or by halving where a
 * step would leave the bracket, which shrinks each time. */
static double root(const coin_priv_series *s, double end, double toward)
{
    double low = 0, high = end, t = end, step;
    do {
        double wX = 0, slope = 0;
        for (int k = COIN_PRIV_ORDER; k >= 0; --k) {
            slope = slope * t + wX;
            wX = wX * t + wX_of(&s->at[k]);
        }
        if (wX == 0)
            return t;
        if (wX * toward > 0)
            low = t;
        else
            high = t;
        double next = low + (high - low) / 2;
        if (fabs(wX) < fabs(slope * (high - low))) {
            const double newton = t - wX / slope;
            next = (newton - low) * (newton - high) < 0 ? newton : next;
        }
        step = next - t;
        t = next;
    } while (fabs(step) > DBL_EPSILON / 2 * fabs(end));
    return t;
}

/* Normalizes the pair of the lean, and takes that of the heading from phi. */
static void normalize(coin_priv_point *p)
{
    const double c = OF(p->th, 0), s = OF(p->th, 1);
    const double more = 1 + (1 - (c * c + s * s)) / 2;
    const coin_priv_sc ph = coin_priv_sincos(OF(p->row[0], 1));
    p->th = coin_priv_pair_of(c * more, s * more);
    p->ph = coin_priv_pair_of(ph.c, ph.s);
}

/* Begins a series at the point that another has at the time t; 0 if the coin is
 * too fast there. */
static int begin_at(const coin_priv_half_period *h, coin_priv_series *to,
                    const coin_priv_series *from, double t)
{
    const double most = FASTEST * FASTEST;
    coin_priv_point *p = to->at;
    *p = coin_priv_series_at(from, t);
    p->row[COIN_PRIV_PATH] = coin_priv_pair_of(0, 0);
    normalize(p);
    if (!(W2_of(h, p) < most))
        return 0;
    coin_priv_series_fill(to, &h->field);
    return 1;
}

/* Makes the series h->now a piece.  Its path is computed, and then moved so
 * that it is at `path` at the time `joint` after its centre: there the piece
 * continues another one. */
static void add_piece(coin_priv_half_period *h, double center, double joint,
                      coin_priv_pair path)
{
    const int n = h->count++;
    coin_priv_point *p = h->now.at;
    coin_priv_series_follow(&h->now);
    const coin_priv_pair here = coin_priv_series_path(&h->now, joint);
    p->row[COIN_PRIV_PATH] =
        coin_priv_pair_of(OF(path, 0) - OF(here, 0), OF(path, 1) - OF(here, 1));
    h->o->private_centers[n] = center;
    h->reach[n] = reach_of(h, &h->now);
    h->joint[n] = joint;
    coin_priv_series_keep(&h->now, coin_priv_larger(h->reach[n], fabs(joint)),
                          h->o->private_terms + COIN_PRIV_PIECE * n);
}

static int turns_within(const coin_priv_half_period *h,
                        const coin_priv_series *s, double t)
{
    const coin_priv_point p = coin_priv_series_at(s, t);
    return !(wX_of(&p) * h->toward > 0);
}

/* How far beyond the end of a piece the centre of the next one is placed.  The
 * next one must reach back that far: the estimate assumes that the reach goes
 * on changing as it did from the piece's centre to its end. */
static double beyond(double reach, double at_end)
{
    return at_end < reach ? at_end * reach / (2 * reach - at_end) : at_end;
}

/* Adds the piece that begins where another ends.  A series about that end leads
 * to the new centre; if it reaches a turning point, it is the piece itself.
 * Returns 0 if no piece can be added. */
static int go_on(coin_priv_half_period *h, int from, double side)
{
    const double end = h->o->private_centers[from] + side * h->reach[from];
    const double tau = end - h->o->private_centers[from];
    const coin_priv_pair path = coin_priv_series_path(&h->now, tau);
    coin_priv_series *between = &h->between;
    if (h->count == COIN_PRIV_PIECES || !begin_at(h, between, &h->now, tau))
        return 0;
    const double reach = reach_of(h, between);
    if (turns_within(h, between, side * reach)) {
        h->now = *between;
        add_piece(h, end, 0, path);
        return 1;
    }
    double step = beyond(h->reach[from], reach), back = 0;
    while (step > BEYOND * back) {
        const double before = step,
                     center = end + side * (back > 0 ? back : step);
        step = fabs(center - end);
        /* Gives up if rounding keeps the step from getting shorter. */
        if ((back > 0 && !(step < before)) ||
            !begin_at(h, &h->now, between, center - end))
            return 0;
        back = reach_of(h, &h->now);
    }
    add_piece(h, end + side * step, -side * step, path);
    return 1;
}

static coin_priv_turning_point turning_point_at(const coin_priv_half_period *h,
                                                int piece, double tau)
{
    const coin_priv_point p = coin_priv_series_at(&h->now, tau);
    const coin_priv_pair path = coin_priv_series_path(&h->now, tau);
    const double c = h->o->private_centers[piece], sum = c + tau;
    const double of_tau = sum - c;
    const coin_priv_turning_point turn = {
        sum,
        (c - (sum - of_tau)) + (tau - of_tau),
        OF(p.row[0], 0),
        OF(p.row[0], 1),
        OF(p.row[1], 0),
        OF(path, 0),
        OF(path, 1),
    };
    return turn;
}

/* Adds pieces from the start to the turning point on one side; 0 if none is
 * found. */
static int walk(coin_priv_half_period *h, coin_priv_turning_point *turn,
                double side)
{
    int piece = 0;
    while (!turns_within(h, &h->now, side * h->reach[piece])) {
        if (!go_on(h, piece, side))
            return 0;
        piece = h->count - 1;
    }
    *turn = turning_point_at(h, piece,
                             root(&h->now, side * h->reach[piece], h->toward));
    return 1;
}

/* The largest power of two that is not above W. */
static double rate_of(double W2)
{
    double rate = 1;
    while (rate * rate > W2)
        rate /= 2;
    while (4 * rate * rate <= W2)
        rate *= 2;
    return rate;
}

void coin_priv_half_period_begin(coin_priv_half_period *h, coin_orbit *o,
                                 const coin_state *s, const coin_priv_body *b)
{
    const coin_priv_sc th = coin_priv_sincos(s->theta);
    const double wX = s->wX, wY = s->wY, wZ = s->wZ;
    const double W2 =
        (wX * wX + wY * wY) / (th.c * th.c) + wZ * wZ + b->g_a; /* (47) */
    const double rate = rate_of(W2), unit = 1 / rate;
    const coin_priv_field field = {
        1, b->GJ * unit * unit, b->KJ, b->XJ, b->k1, b->k2,
    };
    coin_priv_point p;
    h->o = o;
    h->field = field;
    h->g_a = b->g_a * unit * unit;
    h->rate = rate;
    h->count = h->back = 0;
    p.row[0] = coin_priv_pair_of(s->theta, 0);
    p.row[1] = coin_priv_pair_of(0, wX * unit);
    p.row[2] = coin_priv_pair_of(wY * unit, wZ * unit);
    p.row[COIN_PRIV_PATH] = coin_priv_pair_of(0, 0);
    p.th = coin_priv_pair_of(th.c, th.s);
    p.ph = coin_priv_pair_of(1, 0);
    h->now.at[0] = p;
    coin_priv_series_fill(&h->now, &h->field);
}

int coin_priv_half_period_solve(coin_priv_half_period *h)
{
    add_piece(h, 0, 0, coin_priv_pair_of(0, 0));
    const coin_priv_series start = h->now;
    const double wX = wX_of(start.at);
    h->toward = (wX != 0 ? wX : wX_of(start.at + 1)) < 0 ? -1 : 1;
    if (wX == 0)
        h->A = turning_point_at(h, 0, 0);
    if (!walk(h, &h->B, 1))
        return 0;
    const int ahead = h->count;
    h->now = start;
    if (wX != 0 && !walk(h, &h->A, -1))
        return 0;
    h->back = h->count - ahead;
    return 1;
}
