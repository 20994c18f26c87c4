/* SPDX-License-Identifier: MIT */
/* Single precision, compared with doubles that start from the same numbers. */
#ifndef ROLLCOIN_TESTS_FLOATS_H
#define ROLLCOIN_TESTS_FLOATS_H

#include <coin.h>
#include <coinf.h>

/* Half the distance between 1 and the next float. */
#define UF 0x1p-24

/* The nearest floats, with low 0. */
coinf_params floats_params(const coin_params *p);
coinf_state floats_state(const coin_state *s);

/* The same numbers as doubles; for a state the remainders are added. */
coin_params doubles_params(const coinf_params *p);
coin_state doubles_state(const coinf_state *s);

/* How far the pose of a state is from the exact motion, a time after *start:
 * the largest difference of the angles, up to whole turns, and of x and z in
 * radii.  The exact motion is coin_advance() at its least tol, which
 * test_advance compares with the references. */
double floats_error(const coinf_state *s, const coinf_state *start,
                    const coinf_params *p, double t);

#endif
