/* SPDX-License-Identifier: MIT */
/* A finer truth than the library's steps, where a scene amplifies theirs. */
#ifndef ROLLCOIN_TESTS_FINE_H
#define ROLLCOIN_TESTS_FINE_H

#include "support/rungs.h"

/* The largest error of the orbit's pose at so many times up to the horizon,
 * against steps in long double: Eq. (14)-(20) with
 * the C library's sines, the formula of order 8 as published, 256 steps to a
 * unit of Sundman's time. */
double fine_error(const struct rung_scene *scene, int looks);

#endif
