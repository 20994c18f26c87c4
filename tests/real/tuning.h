/* SPDX-License-Identifier: MIT */
/* What tuning.c counts. */
#ifndef ROLLCOIN_TESTS_REAL_TUNING_H
#define ROLLCOIN_TESTS_REAL_TUNING_H

enum { DOPRI8, LOSSY, EXTRAPOLATE, CONE, SERIES, CHECK, FLOAT_STEP, COUNTED };
extern double counted[COUNTED];

#endif
