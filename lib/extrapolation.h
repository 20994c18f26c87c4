/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_EXTRAPOLATION_H
#define ROLLCOIN_EXTRAPOLATION_H

#include "stepper.h"

/* One step of order 14 in Sundman's time; adds the time it takes to pose.t.
 * Returns 0, with *c untouched, if it ends at or below the table or where phi
 * or psi is out of range. */
int coin_priv_extrapolate(coin_priv_carry *c, const coin_priv_body *b,
                          double tau);

#endif
