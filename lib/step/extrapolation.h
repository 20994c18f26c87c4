/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_EXTRAPOLATION_H
#define ROLLCOIN_EXTRAPOLATION_H

#include "run.h"

/* One step of order 14 in Sundman's time, as coin_priv_sundman_step(). */
int coin_priv_extrapolate(coin_priv_run *r, double tau);

#endif
