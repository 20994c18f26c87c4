/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/angles.h"
#include "half.h"

#include <math.h>

#define OF COIN_PRIV_OF

/* What the last power of a series may be worth where it is left. */
#define LEFT_OUT 1e-17

/* The longest step, over the fastest rate W of (47): from one turning point to
 * the next there are pi/2 of it at least.  With little spin a series does not
 * see the table and leads past it, to where no turning point may lie. */
#define LONGEST 1.2

/* A turning point farther than this part of a step gets a piece of its own:
 * the terms that are kept reach half a step, and at 0.6 err by 4e-16. */
#define BEYOND 0.6

static double larger(double a, double b)
{
    return a > fabs(b) ? a : fabs(b);
}

static double wX_of(const coin_priv_point *p)
{
    return OF(p->row[1], 1);
}

/* How far the series reaches: where its last powers come down to LEFT_OUT. */
static double reach_of(const coin_priv_half *h)
{
    const coin_priv_point *p = h->now.at;
    double last = 0;
    for (int k = COIN_PRIV_ORDER - 1; k <= COIN_PRIV_ORDER; ++k)
        for (int i = 0; i < COIN_PRIV_PATH; ++i)
            last = larger(larger(last, OF(p[k].row[i], 0)), OF(p[k].row[i], 1));
    const double wX = wX_of(p), c = OF(p->th, 0);
    const double wY = OF(p->row[2], 0), wZ = OF(p->row[2], 1);
    const double W2 =
        (wX * wX + wY * wY) / (c * c) + wZ * wZ + h->g_a; /* (47) */
    const double most = LONGEST / sqrt(W2);
    const double reach = sqrt(sqrt(sqrt(sqrt(sqrt(LEFT_OUT / last)))));
    return reach < most ? reach : most;
}

/* lambda^2 at a centre. */
static double bend_of(const coin_priv_law *law, const coin_priv_point *p)
{
    const double c = OF(p->th, 0), tan = OF(p->th, 1) / c;
    const double wY = OF(p->row[2], 0), wZ = OF(p->row[2], 1);
    const double dwY = wY * tan + law->k1 * wZ; /* (15) over wX */
    const double dwZ = law->k2 * wY;            /* (16) over wX */
    return law->GJ * c - law->KJ * (dwY * wZ + wY * dwZ) -
           law->XJ * wY * (2 * dwY * tan + wY * (1 + tan * tan)); /* (44) */
}

/* The series about the point now.at[0], a time t after the start, becomes the
 * next piece. */
static void add_piece(coin_priv_half *h, double t)
{
    const int n = h->count++;
    const coin_priv_point *p = h->now.at;
    double *term =
        h->o->private_terms + COIN_PRIV_ROWS * COIN_PRIV_TERMS * (size_t)n;
    coin_priv_series_fill(&h->now, &h->law);
    h->o->private_centers[n] = t;
    h->reach[n] = reach_of(h);
    h->bend[n] = bend_of(&h->law, p);
    for (int k = 0; k < COIN_PRIV_TERMS; ++k)
        for (int i = 0; i < COIN_PRIV_ROWS; ++i)
            *term++ = OF(p[k].row[i / 2], i % 2);
}

/* The root of wX between 0 and end, by Newton's steps, or halves where those
 * lead out of the bracket, which shrinks each time. */
static double root(const coin_priv_half *h, double end)
{
    const coin_priv_point *p = h->now.at;
    double low = 0, high = end, t = end, step;
    do {
        double wX = 0, slope = 0;
        for (int k = COIN_PRIV_ORDER; k >= 0; --k) {
            slope = slope * t + wX;
            wX = wX * t + wX_of(&p[k]);
        }
        if (wX * h->toward > 0)
            low = t;
        else
            high = t;
        double next = t - wX / slope;
        if (!((next - low) * (next - high) < 0))
            next = low + (high - low) / 2;
        step = next - t;
        t = next;
    } while (fabs(step) > DBL_EPSILON / 2 * fabs(end));
    return t;
}

/* A point as the series gives it, put back on the unit circles. */
static void settle(coin_priv_point *p)
{
    const double c = OF(p->th, 0), s = OF(p->th, 1);
    const double more = 1 + (1 - (c * c + s * s)) / 2;
    const coin_priv_sc ph = coin_priv_sincos(OF(p->row[0], 1));
    p->th = coin_priv_pair_of(c * more, s * more);
    p->ph = coin_priv_pair_of(ph.c, ph.s);
}

/* The piece after another: its centre lies at tau from that one's.  The path
 * goes on where the two meet, halfway in their reach. */
static void go_on(coin_priv_half *h, int from, double tau)
{
    const double t = h->o->private_centers[from] + tau;
    const double step = t - h->o->private_centers[from];
    const coin_priv_series before = h->now;
    coin_priv_point *p = h->now.at;
    *p = coin_priv_series_at(&before, step);
    p->row[COIN_PRIV_PATH] = coin_priv_pair_of(0, 0);
    settle(p);
    const int n = h->count;
    add_piece(h, t);
    const double joint = -step * (h->reach[n] / (h->reach[from] + h->reach[n]));
    const coin_priv_pair a = coin_priv_series_path(&before, step + joint);
    const coin_priv_pair b = coin_priv_series_path(&h->now, joint);
    const double z = OF(a, 0) - OF(b, 0), x = OF(a, 1) - OF(b, 1);
    double *term =
        h->o->private_terms + COIN_PRIV_ROWS * COIN_PRIV_TERMS * (size_t)n;
    p->row[COIN_PRIV_PATH] = coin_priv_pair_of(z, x);
    term[COIN_PRIV_Z] = z;
    term[COIN_PRIV_X] = x;
    h->joint[n] = joint;
}

static coin_priv_turn turn_at(const coin_priv_half *h, int piece, double tau)
{
    const coin_priv_point p = coin_priv_series_at(&h->now, tau);
    const coin_priv_pair path = coin_priv_series_path(&h->now, tau);
    const double c = h->o->private_centers[piece], sum = c + tau;
    const double of_tau = sum - c;
    const coin_priv_turn turn = {
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

/* Adds pieces from the start to the turning point on one side; 0 if they are
 * too few. */
static int walk(coin_priv_half *h, coin_priv_turn *turn, double side)
{
    int piece = 0, turned = 0;
    while (!turned) {
        const double step = side * h->reach[piece];
        const coin_priv_point p = coin_priv_series_at(&h->now, step);
        turned = !(wX_of(&p) * h->toward > 0);
        const double tau = turned ? root(h, step) : step;
        if (turned && fabs(tau) <= BEYOND * fabs(step)) {
            *turn = turn_at(h, piece, tau);
            return 1;
        }
        if (h->count == COIN_PRIV_PIECES)
            return 0;
        go_on(h, piece, tau);
        piece = h->count - 1;
    }
    /* The centre is the root as rounded; by how much, wX tells. */
    *turn = turn_at(h, piece, -wX_of(h->now.at) / wX_of(h->now.at + 1));
    return 1;
}

/* The power of two below W. */
static double rate_of(double W2)
{
    double rate = 1;
    while (rate * rate > W2)
        rate /= 2;
    while (4 * rate * rate <= W2)
        rate *= 2;
    return rate;
}

void coin_priv_half_begin(coin_priv_half *h, coin_orbit *o, const coin_state *s,
                          const coin_priv_body *b)
{
    const coin_priv_sc th = coin_priv_sincos(s->theta);
    const double wX = s->wX, wY = s->wY, wZ = s->wZ;
    const double W2 =
        (wX * wX + wY * wY) / (th.c * th.c) + wZ * wZ + b->g_a; /* (47) */
    const double rate = rate_of(W2), unit = 1 / rate;
    const coin_priv_law law = {
        b->GJ * unit * unit, b->KJ, b->XJ, b->k1, b->k2,
    };
    coin_priv_point p;
    h->o = o;
    h->law = law;
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
    add_piece(h, 0);
}

int coin_priv_half_solve(coin_priv_half *h)
{
    const coin_priv_series start = h->now;
    const double wX = wX_of(start.at);
    h->toward = (wX != 0 ? wX : wX_of(start.at + 1)) < 0 ? -1 : 1;
    if (wX == 0)
        h->A = turn_at(h, 0, 0);
    if (!walk(h, &h->B, 1))
        return 0;
    const int ahead = h->count;
    h->now = start;
    if (wX != 0 && !walk(h, &h->A, -1))
        return 0;
    h->back = h->count - ahead;
    return 1;
}
