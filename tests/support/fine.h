/* SPDX-License-Identifier: MIT */
/* A motion in long double, by the textbook's equations in Sundman's time and
 * the table of Dormand and Prince: a truth that shares no code with lib/, and
 * 2000 times finer than a double where long double has 64 bits. */
#ifndef ROLLCOIN_TESTS_FINE_H
#define ROLLCOIN_TESTS_FINE_H

#include <coin.h>

struct fine {
    long double IX, IZ, a, unit; /* over M a^2; the units of length and time */
    long double y[9]; /* theta phi psi x z wX wY wZ t, in natural units */
};

struct fine fine_begin(const coin_state *s, const coin_params *p);

/* Goes to the time t since the start, and says the state there. */
coin_state fine_at(struct fine *f, double t);

#endif
