/* SPDX-License-Identifier: MIT */
/* Whether the force of the table stays within the cone of friction. */
#ifndef ROLLCOIN_CONE_H
#define ROLLCOIN_CONE_H

#include "contact.h"
#include "gbs.h"

/* What is allowed for the error of the interpolated motion, over stride^6.  In
 * cone.c that is an error of the clearance.  In cone_by_ends.c the square
 * margin may err by 2 MISS stride^6 times `weight`.  On random motions of any
 * body, with strides up to 1.65, the error came to a tenth of this.  Fast
 * passes near flat err more.  There least() of cone_by_ends.c subtracts
 * differences that are large enough to cover it.  coin_priv_surely_in_cone()
 * passed no step that leaves the cone (test_cone_by_ends). */
#define COIN_PRIV_MISS 0.006

/* What cone_by_ends.c allows for the error of the force where it takes it as a
 * polynomial, divided by the sum of the sizes at both ends: MISS3 stride^4 for
 * degree 3, and MISS4 stride^5 for degree 4.  On random motions the error came
 * to a third of it (test_cone_by_ends). */
#define COIN_PRIV_MISS3 0.08
#define COIN_PRIV_MISS4 0.008

/* A step to be tested. */
typedef struct coin_priv_tested_step {
    const coin_priv_contact *contact;
    coin_priv_right_hand_side *slopes; /* of the step */
    const coin_priv_slip *from, *to;
    double h;      /* its length */
    double stride; /* h over the time in which the motion changes */
} coin_priv_tested_step;

/* The clearance: how far the force is within the cone of friction.  Of a coin
 * that rolls it is the margin of the force that rolling needs, of one that
 * slips it is the normal force, both over a scale of the force.  Below 0 a
 * rolling coin slips or lifts off, and a slipping one lifts off. */
double coin_priv_clearance(const coin_priv_contact *contact,
                           const coin_priv_slip *y, int slips);

/* Whether the clearance stays positive along a step; at its end it may be
 * negative. */
typedef enum coin_priv_verdict {
    COIN_PRIV_STAYS,   /* it does */
    COIN_PRIV_LEAVES,  /* it does not */
    COIN_PRIV_UNCLEAR, /* it may not */
} coin_priv_verdict;

/* Tests a step whose motion between its ends is Hermite's polynomial of degree
 * 5.  *part: the part of the step to go on with: 1 if the clearance stays
 * positive, the first place at which it is seen to be negative if it leaves,
 * and a half if that is unclear. */
coin_priv_verdict coin_priv_test_cone(const coin_priv_tested_step *step,
                                      double *part);

/* The force that a rolling coin needs, over M a and times cos theta: along e_y,
 * e_X and e_h.  size: the scale by which forces are compared. */
typedef struct coin_priv_need {
    double N, X, h, size;
} coin_priv_need;

/* An end of a rolling step.  y, d, dd: wX, wY, wZ, sin and cos theta, and their
 * first and second derivatives by tau.  force, slope: the force, and its
 * derivative by tau.  square_margin: mu N |mu N| - F^2 over size^2, and over
 * mu^2 too if mu > 1.  weight: the sum of mu |N|, |F_X| and |F_h| in the same
 * units.  An error e of each changes the square margin by about 2 e weight. */
typedef struct coin_priv_end {
    double y[5], d[5], dd[5];
    coin_priv_need force, slope;
    double square_margin, weight;
} coin_priv_end;

/* The square margin there, of a coin without losses. */
double coin_priv_square_margin_at(const coin_priv_contact *contact,
                                  const coin_priv_field *f,
                                  const coin_priv_variables *y);

/* The end at *y; time is the tau in which the motion changes. */
void coin_priv_end_of(coin_priv_end *e, const coin_priv_contact *contact,
                      const coin_priv_field *f, const coin_priv_losses *l,
                      const coin_priv_variables *y, double time);

/* Returns 1 if a rolling step of tau from *a to *b, of the stride given,
 * certainly keeps within the cone, by curves of degree 3 and 4 or by three
 * places within the step.  Returns 0 if that is not certain. */
int coin_priv_surely_in_cone(const coin_priv_contact *contact,
                             const coin_priv_field *f,
                             const coin_priv_losses *l, const coin_priv_end *a,
                             const coin_priv_end *b, double tau, double stride);

#endif
