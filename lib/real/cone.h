/* SPDX-License-Identifier: MIT */
/* Whether the force of the table stays within the cone of friction. */
#ifndef ROLLCOIN_CONE_H
#define ROLLCOIN_CONE_H

#include "contact.h"
#include "gbs.h"

/* What is allowed for the error of the interpolated motion, over stride^6.  In
 * cone.c it is an error of the clearance.  In plain.c it is a half of the error
 * of the square margin, over `weight`.  Random motions of any body, with
 * strides up to 1.65, have a tenth of that.  Fast passes near flat have more:
 * there the differences of the square margin make up for it.  No step that
 * leaves the cone was found plain (test_plain). */
#define COIN_PRIV_MISS 0.006

/* What plain.c allows for where it takes the force as a polynomial: MISS3 for
 * degree 3, over stride^4, and MISS4 for degree 4, over stride^5; both over the
 * sum of the sizes at both ends.  Random motions have a third of it
 * (test_plain). */
#define COIN_PRIV_MISS3 0.08
#define COIN_PRIV_MISS4 0.008

/* A step to be looked at. */
typedef struct coin_priv_look {
    const coin_priv_contact *contact;
    coin_priv_right_hand_side *slopes; /* of the step */
    const coin_priv_slip *from, *to;
    double h;      /* its length */
    double stride; /* h over the time in which the motion changes */
} coin_priv_look;

/* The clearance: how far the force is within the cone of friction.  Of a coin
 * that rolls it is the margin of the force that rolling needs, of one that
 * slips it is the normal force, both over a scale of the force.  Below 0 a
 * rolling coin slips or lifts off, and a slipping one lifts off. */
double coin_priv_clearance(const coin_priv_contact *contact,
                           const coin_priv_slip *y, int slips);

/* Returns 1 if the clearance is positive all along a step; at its end it may be
 * negative.  Returns -x if it is negative at the part x of the step, and
 * positive before.  Returns 0.5 if neither is known: the caller then tries half
 * of the step.  Between the ends the motion is Hermite's polynomial of degree
 * 5. */
double coin_priv_cone_left_at(const coin_priv_look *look);

/* The force that a rolling coin needs, over M a and times cos theta: along e_y,
 * e_X and e_h.  size: the scale by which forces are compared. */
typedef struct coin_priv_need {
    double N, X, h, size;
} coin_priv_need;

/* An end of a rolling step, by tau: wX, wY, wZ, sin and cos theta, their slopes
 * and those of their slopes; the force and its slope.  square_margin: mu N |mu
 * N| - F^2 over size^2, and over mu^2 too if mu > 1.  weight: the sum of mu
 * |N|, |F_X| and |F_h| in the same units, by which errors of the force are
 * multiplied. */
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

/* Whether a rolling step of tau from *a to *b, of the stride given, certainly
 * keeps within the cone: by curves of degree 3 and 4, or by three places within
 * the step.  0: that is not known. */
int coin_priv_plain(const coin_priv_contact *contact, const coin_priv_field *f,
                    const coin_priv_losses *l, const coin_priv_end *a,
                    const coin_priv_end *b, double tau, double stride);

#endif
