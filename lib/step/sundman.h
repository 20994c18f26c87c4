/* SPDX-License-Identifier: MIT */
/* Steps in Sundman's time tau, dt = cos theta dtau. */
#ifndef ROLLCOIN_SUNDMAN_H
#define ROLLCOIN_SUNDMAN_H

#include "run.h"

/* Where cos theta is less than this, the coin counts as flat.  A pass as close
 * as that would take less time than a double resolves. */
#define COIN_PRIV_FLAT 1e-30

/* Weights, without unit, in the rate that a stride is measured by.
 *
 * The terms are those of Eq. (44), the frequency of the lean.  That of wZ has
 * its weight, k1 K/J.  With COIN_PRIV_WEIGHT_Y the error of a step of a given
 * stride depends least on the motion.
 *
 * For bodies with I_Z far below I_X that frequency is low, and slope2, from the
 * slope of wX, Eq. (14), is larger.  For rings it never decides.  In a step of
 * such a body the contact would roll by more than 16 rad if roll2 did not bound
 * the rate from below.  Measured: the rows of these names in
 * tests/studies/tables.md. */
#define COIN_PRIV_WEIGHT_Y 1.5
#define COIN_PRIV_WEIGHT_SLOPE 3
#define COIN_PRIV_WEIGHT_ROLL 0.04

/* The tau of a step of the given stride from here: the stride divided by the
 * coin's own rate.  In a step of stride 1 the motion changes by about its own
 * size. */
COIN_PRIV_INLINE double coin_priv_sundman_tau(const coin_priv_constants *b,
                                              const coin_priv_variables *y,
                                              double stride)
{
    const double wX = y->wX, wY = y->wY, cwZ = y->cth * y->wZ;
    const double rate2 = wX * wX + COIN_PRIV_WEIGHT_Y * (wY * wY) +
                         b->KJ * b->k1 * (cwZ * cwZ) + y->cth * b->g_a;
    const double slope2 = COIN_PRIV_WEIGHT_SLOPE * b->KJ * fabs(wY * cwZ);
    const double roll2 = COIN_PRIV_WEIGHT_ROLL * (cwZ * cwZ);
    const double least2 = slope2 > roll2 ? slope2 : roll2;
    return stride / sqrt(least2 > rate2 ? least2 : rate2);
}

/* h d(wX)/dtau: that by t times cos theta.  It does not contain q and tan
 * theta. */
COIN_PRIV_INLINE double coin_priv_sundman_slope(const coin_priv_field *f,
                                                const coin_priv_variables *y)
{
    const double wY = y->wY, s = y->sth, c = y->cth, cwZ = c * y->wZ;
    return (f->GJ * s) * c - ((f->KJ * wY) * cwZ +
                              (f->XJ * wY) * (f->h * wY * s)); /* from (32) */
}

/* Where the series of coin_priv_tau_of() is poor, its sum may have the wrong
 * sign.  So tau is at least COIN_PRIV_LEAST_PART of rem/c, and each step leads
 * on. */
#define COIN_PRIV_LEAST_PART 0.125

/* The tau in which the time rem passes from here, by its power series in rem to
 * third order.  c, c1, c2: cos theta and its derivatives by t.  (54) */
COIN_PRIV_INLINE double coin_priv_tau_of(const coin_priv_constants *b,
                                         const coin_priv_variables *y,
                                         double rem)
{
    const coin_priv_field f = coin_priv_field_of(b, 1);
    const double c = y->cth, r = rem / c;
    const double dwX = coin_priv_sundman_slope(&f, y) / c;
    const double c1 = -y->sth * y->wX * r; /* times r, r^2: without unit */
    const double c2 = (-c * y->wX * y->wX - y->sth * dwX) * r * r;
    const double part = 1 - c1 / 2 + (2 * c1 * c1 - c * c2) / 6;
    return r * coin_priv_larger(part, COIN_PRIV_LEAST_PART);
}

/* Ends a step in tau that was accepted: y are the variables at its end, adds
 * what it adds to the pose.  0, and *r untouched, if the pose leaves its range.
 */
COIN_PRIV_INLINE int coin_priv_accept_step(coin_priv_run *r,
                                           const coin_priv_variables *y,
                                           const coin_priv_pose *adds)
{
    coin_priv_progress *const g = &r->g;
    coin_priv_pose added = coin_priv_pose_plus(&g->added, 1, adds);
    added.t = g->added.t + adds->t;
    if (!coin_priv_pose_in_range(g, &r->limits, &added))
        return 0;
    g->y = *y;
    g->added = added;
    if (++r->steps % COIN_PRIV_BLOCK == 0) {
        coin_priv_add_block(g);
        const coin_priv_sc ph = coin_priv_angle_pair(g->phi);
        g->y.sph = ph.s;
        g->y.cph = ph.c;
    }
    return 1;
}

/* Takes theta from its pair, after steps in tau and before a step in t. */
COIN_PRIV_INLINE void coin_priv_read_lean(coin_priv_progress *g)
{
    const coin_priv_sc th = {g->y.sth, g->y.cth};
    g->added.theta = coin_priv_angle(th);
}

#endif
