/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_HALF_PERIOD_H
#define ROLLCOIN_HALF_PERIOD_H

#include "../motion/state.h"
#include "pieces.h"
#include "series.h"

/* A turning point: the time from the start to it, its lean, and what the motion
 * from the start to it adds to the rest of the pose. */
typedef struct coin_priv_turning_point {
    double time, theta, phi, psi, z, x;
} coin_priv_turning_point;

/* Half a period while it is computed: from the turning point A to the turning
 * point B, through the start.  Heading, roll and path are measured from the
 * start. */
typedef struct coin_priv_half_period {
    coin_orbit *o;            /* gets the pieces */
    coin_priv_constants b;    /* GJ and g_a in the orbit's unit of time */
    coin_priv_field field;    /* of b; h is 1 */
    double rate;              /* 1 over the unit of time */
    coin_priv_series now;     /* of the latest piece */
    coin_priv_series between; /* about the end of a piece */
    int count;                /* of the pieces */
    double direction;         /* has the sign of wX between A and B */
    coin_priv_turning_point A, B;
} coin_priv_half_period;

/* What the equations read of a point.  The pair of its heading is left out. */
coin_priv_variables coin_priv_point_variables(const coin_priv_point *p);

/* Computes the series about the start, in *h. */
void coin_priv_half_period_begin(coin_priv_half_period *h, coin_orbit *o,
                                 const coin_state *s,
                                 const coin_priv_constants *b);

/* Computes the pieces and both turning points.  Returns 0 if that would take
 * more than COIN_PRIV_PIECES pieces, or if a series cannot be continued. */
int coin_priv_half_period_solve(coin_priv_half_period *h);

#endif
