/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_TESTS_SUNDMAN8_H
#define ROLLCOIN_TESTS_SUNDMAN8_H

#include "run.h"

/* coin_priv_extrapolate() by another formula, that of order 8, for the same
 * equations. */
int sundman8_step(coin_priv_run *r, double tau);

#endif
