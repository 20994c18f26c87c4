/* SPDX-License-Identifier: MIT */
/* Whether the force of the table stays within the cone of friction. */
#ifndef ROLLCOIN_CONE_H
#define ROLLCOIN_CONE_H

#include "contact.h"
#include "gbs.h"

/* The largest error of the margin where the motion is interpolated, over
 * stride^6 and the largest of its terms.  By how much the curves of degree 3
 * and 4 in plain.c may miss the force, over stride^4 and stride^5 and the sizes
 * at both ends.  Random motions of any body, with strides up to 1.65, reach a
 * third of the last two.  They reach a tenth of the first, but fast passes near
 * flat exceed it: there the differences of the margin make up for it.  No step
 * that leaves the cone was found plain (test_plain). */
#define COIN_PRIV_MISS 0.006
#define COIN_PRIV_MISS3 0.08
#define COIN_PRIV_MISS4 0.008

/* A step to be looked at. */
typedef struct coin_priv_look {
    const coin_priv_table *table;
    coin_priv_right_hand_side *slopes; /* of the step */
    const coin_priv_slip *from, *to;
    double h;      /* its length */
    double stride; /* h over the time in which the motion changes */
} coin_priv_look;

/* The clearance: how far the force is within the cone of friction.  Of a coin
 * that rolls it is the margin of the force that rolling needs, of one that
 * slips it is the normal force, both over a scale of the force.  Below 0 a
 * rolling coin slips or lifts off, and a slipping one lifts off. */
double coin_priv_clearance(const coin_priv_table *table,
                           const coin_priv_slip *y, int slips);

/* 1 if the clearance is positive all along a step, but perhaps at its end; the
 * part of the step to try instead where that is not known; minus the part at
 * which the clearance is below 0, if it is positive before.  Between the ends
 * the motion is interpolated, to order 6. */
double coin_priv_looked(const coin_priv_look *look);

/* The force that a rolling coin needs, over M a and times cos theta: along e_y,
 * e_X and e_h.  size: the scale by which forces are compared. */
typedef struct coin_priv_need {
    double N, X, h, size;
} coin_priv_need;

/* An end of a rolling step, by tau: wX, wY, wZ, sin and cos theta, their slopes
 * and those of their slopes; the force and its slope.  margin: mu N |mu N| -
 * F^2 over size^2, and over mu^2 too if mu > 1.  weight: the sum of mu |N|,
 * |F_X| and |F_h| in the same units, by which errors of the force are
 * multiplied. */
typedef struct coin_priv_end {
    double y[5], d[5], dd[5];
    coin_priv_need force, slope;
    double margin, weight;
} coin_priv_end;

/* The margin there, of a coin without losses. */
double coin_priv_margin_at(const coin_priv_table *table,
                           const coin_priv_field *f,
                           const coin_priv_variables *y);

/* The end at *y; time is the tau in which the motion changes. */
void coin_priv_end_of(coin_priv_end *e, const coin_priv_table *table,
                      const coin_priv_field *f, const coin_priv_losses *l,
                      const coin_priv_variables *y, double time);

/* Whether a rolling step of tau from *a to *b, of the stride given, certainly
 * keeps within the cone: by curves of degree 3 and 4, or by three places within
 * the step.  0: that is not known. */
int coin_priv_plain(const coin_priv_table *table, const coin_priv_field *f,
                    const coin_priv_losses *l, const coin_priv_end *a,
                    const coin_priv_end *b, double tau, double stride);

#endif
