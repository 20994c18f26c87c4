/* SPDX-License-Identifier: MIT */
/* Whether the force of the table stays within the cone of friction. */
#ifndef ROLLCOIN_CONE_H
#define ROLLCOIN_CONE_H

#include "contact.h"
#include "gbs.h"

/* A step to be looked at. */
typedef struct coin_priv_look {
    const coin_priv_table *table;
    coin_priv_slopes *slopes; /* of the step */
    const coin_priv_slip *from, *to;
    double h;      /* its length */
    double stride; /* h over the time in which the motion changes */
} coin_priv_look;

/* How much of the cone is left: the margin of the force that a rolling coin
 * needs, or the normal force of one that slips, over the largest of its terms.
 * Below 0 a rolling coin slips or lifts, a slipping one lifts. */
double coin_priv_left(const coin_priv_table *table, const coin_priv_slip *y,
                      int slips);

/* The part of a step, 0 to 1, up to which nothing was left of the cone, or is
 * not known to be left: 1 if it is, also at all places within.  Between the
 * ends the motion is interpolated, to order 6. */
double coin_priv_looked(const coin_priv_look *look);

#endif
