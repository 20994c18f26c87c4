/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_EXTRAPOLATION_H
#define ROLLCOIN_EXTRAPOLATION_H

#include "run.h"

/* One step of order 14 in tau; adds the time that it takes to r->g.added.t.  0,
 * and *r untouched, if it ends at or below the table or where phi or psi is out
 * of range.  theta is in its pair alone until coin_priv_read_lean(). */
int coin_priv_extrapolate(coin_priv_run *r, double tau);

#endif
