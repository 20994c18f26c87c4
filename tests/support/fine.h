/* SPDX-License-Identifier: MIT */
/* A motion in long double, by the textbook's equations in Sundman's time and
 * the coefficients of Dormand and Prince.  It shares no code with lib/.  Where
 * long double has 64 bits, its rounding is 2000 times finer than that of a
 * double. */
#ifndef ROLLCOIN_TESTS_FINE_H
#define ROLLCOIN_TESTS_FINE_H

#include <coin.h>

struct fine {
    long double IX, IZ, a, unit; /* over M a^2; the units of length and time */
    long double y[9]; /* theta phi psi x z wX wY wZ t, in natural units */
};

struct fine fine_begin(const coin_state *s, const coin_params *p);

/* Goes to the time t since the start, and returns the state there. */
coin_state fine_at(struct fine *f, double t);

#endif
