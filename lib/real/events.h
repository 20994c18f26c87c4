/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_EVENTS_H
#define ROLLCOIN_EVENTS_H

#include "move.h"

/* The first event within the step just made, of `stride` radians of the motion:
 * 1, and the variables just after it, if there is one. */
int coin_priv_first_event(double *cut, coin_priv_moving *g, double stride);

#endif
