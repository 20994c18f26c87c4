/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/angles.h"
#include "../motion/legendre.h"
#include "steady_near.h"

/* A place on the potential V(theta) of a state's integrals, Eq. (48). */
struct place {
    double theta;
    coin_priv_sc at;         /* sine and cosine of theta */
    double p, wY, wZ;        /* the linear pair, p = wY cos theta */
    double fall, fall_slope; /* d(wX)/dt = -V'/J, and its slope along theta */
};

/* The longest step, in units of cos theta.  The series of (34) reaches twice as
 * far. */
#define LONG_STEP 0.04

/* After a step this short, in the same units, the next is below rounding.  Next
 * to flat the rounding of theta is larger: a step of 2 DBL_EPSILON is the last
 * there. */
#define LAST_STEP 1e-9

/* The most steps: 4 lead as far as the quasi-steady path asks for, and the last
 * ones converge quadratically. */
#define STEPS_MAX 60

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

/* Moves *o to another theta on the same potential, by at most LONG_STEP
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

/* The step of Newton's method towards the valley, or LONG_STEP downhill where
 * that is longer or leads uphill. */
static double step_of(const struct place *o)
{
    const double most = LONG_STEP * o->at.c;
    const double down = o->fall < 0 ? -most : most;
    return o->fall == 0                            ? 0
           : fabs(o->fall) < -o->fall_slope * most ? -o->fall / o->fall_slope
                                                   : down;
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

int32_t coin_priv_steady_near(coin_state *s, const coin_priv_body *b)
{
    const coin_priv_sc at = coin_priv_sincos(s->theta);
    struct place o = {s->theta, at, s->wY * at.c, s->wY, s->wZ, 0, 0};
    evaluate(&o, b);
    double step;
    int steps = 0;
    do {
        if (steps++ == STEPS_MAX)
            return COIN_EDOMAIN;
        step = step_of(&o);
        move(&o, b, o.theta + step);
    } while (fabs(step) > LAST_STEP * o.at.c + 2 * DBL_EPSILON);
    balance(&o, b);
    s->theta = o.theta;
    s->wX = 0;
    s->wY = o.wY;
    s->wZ = o.wZ;
    return COIN_OK;
}
