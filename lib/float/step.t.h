/* SPDX-License-Identifier: MIT */
/* A step in single precision: what it adds to a state, and how. */
#include "floats.h"

#include "../motion/equations.h"

#include "../motion/kind.h"

/* For one coin, parts are functions, so that a step takes little stack; for
 * coins side by side they are inlined. */
#undef PART
#ifdef COIN_PRIV_ABREAST
#define PART COIN_PRIV_INLINE
#else
#define PART COIN_PRIV_NOINLINE
#endif

/* A state, with its numbers in the order of coinf_state.  low[0] to low[7] are
 * the remainders of theta, phi, psi, x, z, wX, wY, wZ: what their rounding left
 * out. */
#ifdef COIN_PRIV_ABREAST
typedef struct coinf_lanes_state {
    real theta, phi, psi, x, z, wX, wY, wZ, low[8];
} coinf_lanes_state;
#else
typedef coinf_state coinf_priv_state;
#endif

/* What the steps of a run share: the equations of motion times dt, and the
 * limits on W^2, Eq. (47), where a step begins and ends. */
typedef struct PRIV(plan) {
    PRIV(field) f;
    real KJ_low; /* (KJ + KJ_low)/GJ is K/(M g a), in twice a float's digits */
    real a, g_a, k1, k2;
    real coarse2, most2; /* coarse2 <= most2 */
} PRIV(plan);

/* ------------------------------------------------------ compensated sums -- */

/* Adds a part and its own remainder, `small`, to a sum and its remainder. */
COIN_PRIV_INLINE void PRIV(add_parts)(real *sum, real *low, real part,
                                      real small)
{
    const real large = *sum + part, of_part = large - *sum;
    const real off = (*sum - (large - of_part)) + (part - of_part);
    const real rest = (*low + small) + off;
    *sum = large + rest;
    *low = rest - (*sum - large);
}

/* A float as two of 12 bits. */
typedef struct PRIV(halves) {
    real high, low;
} PRIV(halves);

COIN_PRIV_INLINE PRIV(halves) PRIV(halves_of)(real a)
{
    const real t = K(4097) * a, high = t - (t - a); /* 4097 = 2^12 + 1 */
    const PRIV(halves) h = {high, a - high};
    return h;
}

/* What the rounding of a b leaves out, to the bit: Dekker's product. */
PART real PRIV(residue)(real a, real b)
{
    const PRIV(halves) x = PRIV(halves_of)(a), y = PRIV(halves_of)(b);
    const real off = x.high * y.high - a * b;
    return ((off + x.high * y.low) + x.low * y.high) + x.low * y.low;
}

/* ---------------------------------------------------------------- angles -- */

/* Sine and cosine of an angle and its remainder. */
PART PRIV(sc) PRIV(sine_cosine_with_low)(real angle, real low)
{
    const PRIV(sc) of = PRIV(sine_cosine)(angle);
    const PRIV(sc) pair = {of.s + of.c * low, of.c - of.s * low};
    return pair;
}

/* The variables of an angular velocity and of the pairs of lean and heading. */
COIN_PRIV_INLINE PRIV(variables)
    PRIV(variables_from)(real wX, real wY, real wZ, PRIV(sc) th, PRIV(sc) ph)
{
    const real q = K(1) / th.c;
    const PRIV(variables) y = {
        wX, wY, wZ, th.s, th.c, q, th.s * q, ph.s, ph.c,
    };
    return y;
}

/* A state as the equations read it. */
PART PRIV(variables) PRIV(variables_with_low)(const PRIV(state) * s)
{
    const PRIV(sc) th = PRIV(sine_cosine_with_low)(s->theta, s->low[0]);
    const PRIV(sc) ph = PRIV(sine_cosine_with_low)(s->phi, s->low[1]);
    return PRIV(variables_from)(s->wX, s->wY, s->wZ, th, ph);
}

/* Subtracts whole turns from an angle, by the parts of pi/2. */
PART void PRIV(reduce)(real *angle, real *low)
{
    const real turns =
        (*angle * (K(0.25) / COIN_PRIV_HALF_PI) + COIN_PRIV_ROUNDER) -
        COIN_PRIV_ROUNDER;
    const real none = {0};
    PRIV(add_parts)(angle, low, turns * (-4 * COIN_PRIV_P1), none);
    PRIV(add_parts)(angle, low, turns * (-4 * COIN_PRIV_P2), none);
    PRIV(add_parts)(angle, low, turns * (-4 * COIN_PRIV_P3), none);
}

/* ---------------------------------------------------------------- slopes -- */

/* h d/dt of a state's members, or a part of their change. */
typedef struct PRIV(slope) {
    real theta, phi, psi, x, z, wX, wY, wZ;
} PRIV(slope);

/* What KJ_low adds to h d(wX)/dt of (14), in KJ wZ wY. */
COIN_PRIV_INLINE real PRIV(fall_low)(const PRIV(plan) * plan,
                                     const PRIV(variables) * y)
{
    return -(plan->KJ_low * y->wZ * y->wY);
}

/* The slope at a stage.  psi' is computed as wZ + phi' sin theta, so that the
 * remainder of phi' gives that of psi'. */
COIN_PRIV_INLINE PRIV(slope)
    PRIV(slope_at)(const PRIV(plan) * plan, const PRIV(variables) * y)
{
    const PRIV(field) *f = &plan->f;
    const PRIV(variables) d = PRIV(slopes_at)(f, y);
    const real phi = PRIV(pose_slopes)(f, y).phi;
    real v[3];
    PRIV(velocity_of)(v, f->h * plan->a, y);
    const PRIV(slope) of = {
        f->h * y->wX,                /* (17) */
        phi,                         /* (18) */
        f->h * y->wZ + phi * y->sth, /* (19) */
        v[0],
        v[2],
        d.wX,
        d.wY,
        d.wZ,
    };
    return of;
}

/* A stage: the start plus a part w of a slope.  It is the textbook's stage: the
 * pairs are turned by what is added to the angles, and 1/cos theta is computed
 * by a division.  As the start plus a part of a slope, pairs have errors of
 * z^2/2 for a turn z, and 1/cos theta of tan^2 theta z^2. */
COIN_PRIV_INLINE PRIV(variables)
    PRIV(stage_along)(const PRIV(variables) * y1, scalar w,
                      const PRIV(slope) * of)
{
    const PRIV(sc) lean = {y1->sth, y1->cth}, heading = {y1->sph, y1->cph};
    const PRIV(sc) th = PRIV(turned_a_little)(lean, w * of->theta);
    const PRIV(sc) ph = PRIV(turned_a_little)(heading, w * of->phi);
    return PRIV(variables_from)(y1->wX + w * of->wX, y1->wY + w * of->wY,
                                y1->wZ + w * of->wZ, th, ph);
}

/* rest + w (of - first). */
COIN_PRIV_INLINE void PRIV(gather)(PRIV(slope) * rest, scalar w,
                                   const PRIV(slope) * of,
                                   const PRIV(slope) * first)
{
    rest->theta += w * (of->theta - first->theta);
    rest->phi += w * (of->phi - first->phi);
    rest->psi += w * (of->psi - first->psi);
    rest->x += w * (of->x - first->x);
    rest->z += w * (of->z - first->z);
    rest->wX += w * (of->wX - first->wX);
    rest->wY += w * (of->wY - first->wY);
    rest->wZ += w * (of->wZ - first->wZ);
}

/* What the rounding of the first slope left out.  It is computed only for those
 * parts that are the same in each step of a steady motion: their errors would
 * add up. */
COIN_PRIV_INLINE PRIV(slope)
    PRIV(left_out)(const PRIV(slope) * first, const PRIV(plan) * plan,
                   const PRIV(variables) * y)
{
    const real h = plan->f.h, cth = y->cth;
    const real off = PRIV(residue)(h, y->wY) - PRIV(residue)(first->phi, cth);
    const real phi = y->q * ((h * y->wY - first->phi * cth) + off); /* (18) */
    const real fall = PRIV(fall_low)(plan, y), none = {0};
    const PRIV(slope) low = {
        none, phi, phi * y->sth, none, none, fall, none, none,
    };
    return low;
}

/* A function for the slope at a stage. */
typedef PRIV(slope)
    PRIV(slope_function)(const PRIV(plan) * plan, const PRIV(variables) * y);

/* The classical Runge-Kutta step, as the first slope f1 and the rest of the
 * change, ((f2 - f1) + (f3 - f1))/3 + (f4 - f1)/6.  The rounded weights then
 * multiply the rest only, which is small.  If they multiplied f1, their errors
 * would add up in a steady motion.
 * *last becomes the last stage, which stands for the end of the step. */
COIN_PRIV_INLINE void PRIV(slopes)(PRIV(slope) * first, PRIV(slope) * rest,
                                   PRIV(variables) * last,
                                   const PRIV(plan) * plan,
                                   const PRIV(variables) * y1,
                                   PRIV(slope_function) * slope_at)
{
    static const scalar reach[] = {K(0.5), K(0.5), 1};
    static const scalar weight[] = {K(1.0 / 3), K(1.0 / 3), K(1.0 / 6)};
    PRIV(slope) of = *first = slope_at(plan, y1);
    *rest = PRIV(left_out)(first, plan, y1);
    for (int i = 0; i < 3; ++i) {
        *last = PRIV(stage_along)(y1, reach[i], &of);
        of = slope_at(plan, last);
        PRIV(gather)(rest, weight[i], &of, first);
    }
}

/* Adds the change of a step to a state. */
COIN_PRIV_INLINE void PRIV(add_change)(PRIV(state) * s,
                                       const PRIV(slope) * first,
                                       const PRIV(slope) * rest)
{
    PRIV(add_parts)(&s->theta, &s->low[0], first->theta, rest->theta);
    PRIV(add_parts)(&s->phi, &s->low[1], first->phi, rest->phi);
    PRIV(add_parts)(&s->psi, &s->low[2], first->psi, rest->psi);
    PRIV(add_parts)(&s->x, &s->low[3], first->x, rest->x);
    PRIV(add_parts)(&s->z, &s->low[4], first->z, rest->z);
    PRIV(add_parts)(&s->wX, &s->low[5], first->wX, rest->wX);
    PRIV(add_parts)(&s->wY, &s->low[6], first->wY, rest->wY);
    PRIV(add_parts)(&s->wZ, &s->low[7], first->wZ, rest->wZ);
}

/* Whether a step may end here: all ones or 0, and 0 for NaN. */
COIN_PRIV_INLINE whole PRIV(holds)(const PRIV(state) * s,
                                   const PRIV(plan) * plan)
{
    const real wX = s->wX, wY = s->wY, wZ = s->wZ;
    const real pose = PRIV(magnitude)(s->phi) + PRIV(magnitude)(s->psi) +
                      PRIV(magnitude)(s->x) + PRIV(magnitude)(s->z);
    return PRIV(truth)((PRIV(magnitude)(s->theta) < COIN_PRIV_HALF_PI) &
                       (pose <= COIN_PRIV_LARGEST) &
                       (wX * wX + wY * wY + wZ * wZ <= plan->most2));
}
