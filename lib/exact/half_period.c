/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/angles.h"
#include "half_period.h"

#include <math.h>

#define ELEMENT COIN_PRIV_ELEMENT

/* The largest value of a series' last terms within its reach.  A tenth needs 8
 * % more pieces for the same errors.  With 100 times as much the errors of 500
 * random orbits double, for 13 % fewer pieces (make tuning). */
#define LAST_TERM 1e-17

/* The longest reach of a series, times the rate W of (47).  A swing takes at
 * least pi/2 over W.  With little spin, a series of a longer reach would lead
 * past the table.  Half of it adds 0.5 % to the pieces (make tuning). */
#define REACH_MAX 1.2

/* A series may be used up to this many times its reach: its error is then
 * 1.05^28 = 3.9 times as large.  With 1.01 or 1.2 the pieces and errors are the
 * same within 1 % (make tuning). */
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

/* How far a series reaches: where its last powers come down to LAST_TERM. */
static double reach_about(const coin_priv_half_period *h,
                          const coin_priv_series *s)
{
    const coin_priv_point *p = s->at;
    double last = 0;
    for (int k = COIN_PRIV_ORDER - 1; k <= COIN_PRIV_ORDER; ++k)
        for (int i = 0; i < COIN_PRIV_PATH; ++i) {
            const coin_priv_pair row = p[k].row[i];
            last = coin_priv_larger(last, fabs(ELEMENT(row, 0)));
            last = coin_priv_larger(last, fabs(ELEMENT(row, 1)));
        }
    const double longest = REACH_MAX / sqrt(rate2_at(h, p));
    /* A limit that keeps its power, 1e280 at most, from overflowing. */
    const double most = longest < 1e10 ? longest : 1e10;
    double power = 1;
    for (int k = 0; k < COIN_PRIV_ORDER; ++k)
        power *= most;
    return last * power <= LAST_TERM ? most : root_28(LAST_TERM / last);
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

/* Begins a series at the point that another has at the time t; 0 if that
 * point is not above the table, or the coin is too fast there. */
static int begin_at(const coin_priv_half_period *h, coin_priv_series *to,
                    const coin_priv_series *from, double t)
{
    const double most = RATE_MAX * RATE_MAX;
    coin_priv_point *p = to->at;
    *p = coin_priv_series_at(from, t);
    p->row[COIN_PRIV_PATH] = coin_priv_pair_make(0, 0);
    normalize(p);
    if (!(ELEMENT(p->th, 0) > 0 && rate2_at(h, p) < most))
        return 0;
    coin_priv_series_expand(to, &h->field);
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
    coin_priv_series_expand_path(&h->now);
    const coin_priv_pair here = coin_priv_series_path(&h->now, joint);
    p->row[COIN_PRIV_PATH] =
        coin_priv_pair_make(ELEMENT(path, 0) - ELEMENT(here, 0),
                            ELEMENT(path, 1) - ELEMENT(here, 1));
    h->o->private_centers[n] = center;
    h->reach[n] = reach_about(h, &h->now);
    h->joint[n] = joint;
    coin_priv_series_economized(&h->now,
                                coin_priv_larger(h->reach[n], fabs(joint)),
                                h->o->private_terms + COIN_PRIV_PIECE * n);
}

static int turns_within(const coin_priv_half_period *h,
                        const coin_priv_series *s, double t)
{
    const coin_priv_point p = coin_priv_series_at(s, t);
    return !(wX_at(&p) * h->direction > 0);
}

/* How far beyond the end of a piece the centre of the next one is placed.  The
 * next one must reach back that far: the estimate assumes that the reach goes
 * on changing as it did from the piece's centre to its end. */
static double center_after(double reach, double at_end)
{
    return at_end < reach ? at_end * reach / (2 * reach - at_end) : at_end;
}

/* Adds the piece that begins where another ends.  A series about that end leads
 * to the new centre; if it reaches a turning point, it is the piece itself.
 * Returns 0 if no piece can be added. */
static int add_next_piece(coin_priv_half_period *h, int from, double side)
{
    const double end = h->o->private_centers[from] + side * h->reach[from];
    const double tau = end - h->o->private_centers[from];
    const coin_priv_pair path = coin_priv_series_path(&h->now, tau);
    coin_priv_series *between = &h->between;
    if (h->count == COIN_PRIV_PIECES || !begin_at(h, between, &h->now, tau))
        return 0;
    const double reach = reach_about(h, between);
    if (turns_within(h, between, side * reach)) {
        h->now = *between;
        add_piece(h, end, 0, path);
        return 1;
    }
    double back = center_after(h->reach[from], reach), step = DBL_MAX;
    do {
        const double before = step, center = end + side * back;
        step = fabs(center - end);
        /* Gives up if rounding keeps the step from getting shorter. */
        if (step >= before || !begin_at(h, &h->now, between, center - end))
            return 0;
        back = reach_about(h, &h->now);
    } while (step > REACH_MARGIN * back);
    add_piece(h, end + side * step, -side * step, path);
    return 1;
}

static coin_priv_turning_point turning_point_at(const coin_priv_half_period *h,
                                                int piece, double tau)
{
    const coin_priv_point p = coin_priv_series_at(&h->now, tau);
    const coin_priv_pair path = coin_priv_series_path(&h->now, tau);
    const double c = h->o->private_centers[piece], sum = c + tau;
    const double tau_in_sum = sum - c;
    const coin_priv_turning_point turn = {
        sum,
        (c - (sum - tau_in_sum)) + (tau - tau_in_sum),
        ELEMENT(p.row[0], 0),
        ELEMENT(p.row[0], 1),
        ELEMENT(p.row[1], 0),
        ELEMENT(path, 0),
        ELEMENT(path, 1),
    };
    return turn;
}

/* Adds pieces from the start to the turning point on one side; 0 if none is
 * found. */
static int add_pieces(coin_priv_half_period *h, coin_priv_turning_point *turn,
                      double side)
{
    int piece = 0;
    while (!turns_within(h, &h->now, side * h->reach[piece])) {
        if (!add_next_piece(h, piece, side))
            return 0;
        piece = h->count - 1;
    }
    *turn = turning_point_at(
        h, piece, root(&h->now, side * h->reach[piece], h->direction));
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
                                 const coin_state *s, const coin_priv_body *b)
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
    h->count = h->back = 0;
    p.row[0] = coin_priv_pair_make(s->theta, 0);
    p.row[1] = coin_priv_pair_make(0, y.wX * unit);
    p.row[2] = coin_priv_pair_make(y.wY * unit, y.wZ * unit);
    p.row[COIN_PRIV_PATH] = coin_priv_pair_make(0, 0);
    p.th = coin_priv_pair_make(y.cth, y.sth);
    p.ph = coin_priv_pair_make(1, 0);
    h->now.at[0] = p;
    coin_priv_series_expand(&h->now, &h->field);
}

int coin_priv_half_period_solve(coin_priv_half_period *h)
{
    add_piece(h, 0, 0, coin_priv_pair_make(0, 0));
    const coin_priv_series start = h->now;
    const double wX = wX_at(start.at);
    h->direction = (wX != 0 ? wX : wX_at(start.at + 1)) < 0 ? -1 : 1;
    if (wX == 0)
        h->A = turning_point_at(h, 0, 0);
    if (!add_pieces(h, &h->B, 1))
        return 0;
    const int ahead = h->count;
    h->now = start;
    if (wX != 0 && !add_pieces(h, &h->A, -1))
        return 0;
    h->back = h->count - ahead;
    return 1;
}
