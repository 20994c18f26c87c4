/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/angles.h"
#include "../motion/legendre.h"
#include "steady.h"

#include <math.h>

/* A place on the potential V(theta) of a state's integrals, Eq. (48). */
struct place {
    double theta;
    coin_priv_sc at;         /* sine and cosine of theta */
    double p, wY, wZ;        /* the linear pair, p = wY cos theta */
    double fall, fall_slope; /* d(wX)/dt = -V'/J, and its slope along theta */
};

/* The longest and the shortest step of the search, in units of cos theta.  The
 * series of (34) reaches twice as far as the longest.  Two extrema that are
 * nearer to each other than the shortest may both be missed. */
#define LONG_STEP 0.04
#define SHORT_STEP 0.0005

/* Nearer to flat than this no steady motion is searched for: there the
 * rounding of theta changes the terms of (39) by nearly the 1e-9 of STEADY. */
#define FLAT 1e-6

static void evaluate(struct place *o, const coin_priv_body *b)
{
    const double wY = o->wY = o->p / o->at.c, wZ = o->wZ;
    const double tth = o->at.s / o->at.c;
    const double dwY = wY * tth + b->k1 * wZ; /* (15) over wX */
    const double dwZ = b->k2 * wY;            /* (16) over wX */
    /* clang-format off */
    o->fall = b->GJ * o->at.s - wY * (b->KJ * wZ + b->XJ * wY * tth); /* (14) */
    o->fall_slope = b->GJ * o->at.c - b->KJ * (dwY * wZ + wY * dwZ)   /* (44) */
                  - b->XJ * wY * (2 * dwY * tth + wY * (1 + tth * tth));
    /* clang-format on */
}

/* Signs are multiplied, not numbers whose product may underflow. */
static int sign_of(double x)
{
    return (x > 0) - (x < 0);
}

/* Moves *o to another theta on the same potential, by at most 2 LONG_STEP
 * cos theta.  The cosine of the angle in the middle is corrected for the
 * rounding of that angle, which matters near flat. */
static void move(struct place *o, const coin_priv_body *b, double theta)
{
    const double half = (theta - o->theta) / 2;
    const double middle = o->theta + half, lost = o->theta - middle + half;
    const coin_priv_sc at = coin_priv_sincos(middle);
    const double c = at.c - lost * at.s;
    /* The change of sin theta. */
    const double e = 2 * c * coin_priv_sincos(half).s;
    coin_priv_legendre_shift(&o->p, &o->wZ, b->k1, b->k2, o->at.s,
                             o->at.c * o->at.c, e); /* (34) */
    o->theta = theta;
    o->at = coin_priv_sincos(theta);
    evaluate(o, b);
}

/* The step of Newton's method, or 4 rad if that is longer.  So long a step
 * leaves every bracket, and is longer than LONG_STEP. */
static double newton(const struct place *o)
{
    return fabs(o->fall) < 4 * fabs(o->fall_slope) ? -o->fall / o->fall_slope
                                                   : 4;
}

/* Moves *o to the extremum between it and end, where `fall` has the other sign:
 * by Newton's method, or by halving where a step would leave the bracket. */
static void to_extremum(struct place *o, const coin_priv_body *b, double end)
{
    double low = o->theta, high = end;
    const int sign = sign_of(o->fall);
    for (int i = 0; i < 60; ++i) {
        const double step = newton(o);
        double next = o->theta + step;
        if (fabs(step) <= DBL_EPSILON / 2 * fabs(o->theta))
            return;
        if (!((low < next && next < high) || (high < next && next < low)))
            next = low + (high - low) / 2;
        move(o, b, next);
        if (sign_of(o->fall) * sign > 0)
            low = next;
        else
            high = next;
    }
}

/* A step of the search: 1.5 times that of Newton's method, which is enough to
 * pass an extremum near by. */
static double step_of(const struct place *o)
{
    const double guess = 1.5 * fabs(newton(o));
    const double most = LONG_STEP * o->at.c, least = SHORT_STEP * o->at.c;
    return guess > most ? most : guess < least ? least : guess;
}

/* Whether two extrema may lie between two places.  `fall` then has the same
 * sign at both.  On the way its size decreases at the first place and increases
 * at the second. */
static int may_pass_two(const struct place *from, const struct place *to,
                        double side)
{
    const int before = sign_of(from->fall) * sign_of(from->fall_slope);
    const int after = sign_of(to->fall) * sign_of(to->fall_slope);
    return sign_of(from->fall) * sign_of(to->fall) > 0 && before * side < 0 &&
           after * side > 0;
}

/* Goes to the first extremum on one side of *o, but no farther than most; 0 if
 * there is none. */
static int find(struct place *o, const coin_priv_body *b, double side,
                double most)
{
    const double start = o->theta;
    while (o->at.c > FLAT && fabs(o->theta - start) <= most) {
        const struct place last = *o;
        double step = side * step_of(o);
        move(o, b, o->theta + step);
        while (may_pass_two(&last, o, side) &&
               fabs(step) > SHORT_STEP * o->at.c) {
            step /= 2;
            *o = last;
            move(o, b, o->theta + step);
        }
        if (sign_of(o->fall) * sign_of(last.fall) <= 0) {
            const double end = o->theta;
            *o = last;
            to_extremum(o, b, end);
            return 1;
        }
    }
    return 0;
}

/* Farther than from one side of the table to the other. */
#define FARTHEST 4.0

/* The nearest extremum to either side within `most`; 0 if there is none.  The
 * side that Newton's method points to is searched first, as an extremum there
 * limits the search on the other side. */
static int nearest(struct place *o, const coin_priv_body *b, double most)
{
    struct place ahead = *o, behind = *o;
    if (o->fall == 0)
        return 1;
    const double side = sign_of(o->fall) * sign_of(o->fall_slope) < 0 ? 1 : -1;
    const int first = find(&ahead, b, side, most);
    const double way = first ? fabs(ahead.theta - o->theta) : most;
    const int second = find(&behind, b, -side, way);
    const double back = fabs(behind.theta - o->theta);
    *o = second && !(first && way <= back) ? behind : ahead;
    return first || second;
}

/* Changes the rates as little as possible so that (39) holds at this lean.  At
 * the extremum `fall` is not 0, due to the rounding of theta, and large for
 * fast coins.  Newton's method in the plane of wY and wZ makes it 0; at rates
 * of 1e16 its second step still has an effect.  For slow coins the change would
 * not be small, and is not needed. */
static void balance(struct place *o, const coin_priv_body *b)
{
    const double tth = o->at.s / o->at.c;
    for (int i = 0; i < 3; ++i) {
        const double by_wY = b->KJ * o->wZ + 2 * b->XJ * o->wY * tth;
        const double by_wZ = b->KJ * o->wY;
        const double slope = coin_priv_hypot(by_wY, by_wZ);
        if (!(fabs(o->fall) < slope * coin_priv_hypot(o->wY, o->wZ)))
            return;
        o->p += o->fall / slope * (by_wY / slope) * o->at.c;
        o->wZ += o->fall / slope * (by_wZ / slope);
        evaluate(o, b);
    }
}

int32_t coin_priv_steady_near(const coin_state *s, const coin_priv_body *b,
                              double most, coin_state *out)
{
    const coin_priv_sc at = coin_priv_sincos(s->theta);
    struct place o = {s->theta, at, s->wY * at.c, s->wY, s->wZ, 0, 0};
    evaluate(&o, b);
    if (!nearest(&o, b, most))
        return COIN_EDOMAIN;
    balance(&o, b);
    coin_state near = *s;
    near.theta = o.theta;
    near.wX = 0;
    near.wY = o.wY;
    near.wZ = o.wZ;
    /* For bodies with moments of inertia 1e80 apart the search may fail. */
    coin_priv_sc th;
    const int32_t unbalanced = coin_priv_check_balance(&near, b, &th);
    if ((coin_priv_check_state(&near, b) | unbalanced) != COIN_OK)
        return COIN_EDOMAIN;
    *out = near;
    return COIN_OK;
}

int32_t coin_steady_near(const coin_state *s, const coin_params *p,
                         coin_state *out)
{
    coin_priv_body b;
    const int32_t status = out ? coin_priv_check(s, p, &b) : COIN_EARG;
    return status == COIN_OK ? coin_priv_steady_near(s, &b, FARTHEST, out)
                             : status;
}
