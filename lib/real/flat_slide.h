/* SPDX-License-Identifier: MIT */
/* A coin that lies flat and slides on its face. */
#ifndef ROLLCOIN_FLAT_SLIDE_H
#define ROLLCOIN_FLAT_SLIDE_H

#include "move.h"

/* Moves a body that lies flat, by t or until it stops or g->tries are used up.
 * g->law is set.  Returns the time moved. */
double coin_priv_slide_flat(coin_body *b, coin_priv_moving *g, double t);

/* The friction on a coin whose centre slides at v and whose face turns at w,
 * over mu M g: 0 to 1. */
double coin_priv_flat_drag(double IZ, double v, double w);

#endif
