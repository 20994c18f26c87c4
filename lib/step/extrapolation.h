/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_EXTRAPOLATION_H
#define ROLLCOIN_EXTRAPOLATION_H

#include "run.h"

/* One step of order 14 in tau.  Adds the time that it takes to r->g.added.t.
 * Returns 0, and leaves *r untouched, if the step ends at or below the table,
 * or where phi or psi is out of range.  It does not set added.theta: until
 * coin_priv_read_lean() is called, only sin and cos theta are right. */
int coin_priv_extrapolate(coin_priv_run *r, double tau);

#endif
