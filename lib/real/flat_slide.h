/* SPDX-License-Identifier: MIT */
/* A coin that lies flat and slides on its face. */
#ifndef ROLLCOIN_FLAT_SLIDE_H
#define ROLLCOIN_FLAT_SLIDE_H

#include "move.h"

/* Moves a coin that lies flat, by t or until it stops or g->tries are used up.
 * g->law is set.  Returns the time moved. */
double coin_priv_slide_flat(coin_priv_coin *c, coin_priv_moving *g, double t);

/* A coin with a thickness comes to lie, by a blow of the table of the impulse
 * P: what part friction takes from the velocity of the centre that the end of
 * its tilt, A, would leave it.  U: the velocity of the middle of the face; w:
 * its turn. */
double coin_priv_face_grip(const coin_priv_law *l, double U2, double A2,
                           double P, double w);

/* The friction on a coin whose centre slides at v and whose face turns at w,
 * over mu M g: 0 to 1. */
double coin_priv_flat_drag(double IZ, double v, double w);

#endif
