/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_EXTRAPOLATION_H
#define ROLLCOIN_EXTRAPOLATION_H

#include "run.h"

/* One step of order 14 in tau, unless the estimate of its error is above
 * *error; *error becomes that estimate, an angle or a part of cos theta, and at
 * most 1: through the table too.  Adds the time of the step to r->g.added.t.
 * Returns whether the step was made.  If not, or if phi or psi would leave
 * their range, *r is untouched.  The step does not set added.theta: until
 * coin_priv_read_lean() is called, only sin and cos theta are right. */
int coin_priv_extrapolate(coin_priv_run *r, double tau, double *error);

#endif
