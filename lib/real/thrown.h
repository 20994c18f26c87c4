/* SPDX-License-Identifier: MIT */
/* A coin on its way through all modes: in the air, in contact, flat. */
#ifndef ROLLCOIN_THROWN_H
#define ROLLCOIN_THROWN_H

#include "coin_body.h"

/* A body under way, in natural units. */
typedef struct coin_priv_thrown {
    coin_body b;
    coin_priv_attitude at;
    double restitution;
    double time, tol;    /* of the call */
    coin_priv_sum moved; /* the time so far */
    int32_t stop;        /* bits that end the call */
    int32_t event;       /* what begins here: COIN_TOUCHES, or COIN_ROLLS if
                            the coin rolls */
    int changed;         /* whether *b is another body than at the start */
    coin_priv_moving g;  /* of the contact; g.law and g.tries are those of the
                            whole way */
} coin_priv_thrown;

/* Moves until the time is over, the coin rests or a bit of stop holds: the mode
 * as a status, or-ed with these; COIN_ESTEP, COIN_ERANGE.  The law, the
 * restitution and g.tries are set. */
int32_t coin_priv_go_on(coin_priv_thrown *w);

#endif
