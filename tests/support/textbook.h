/* SPDX-License-Identifier: MIT */
/* The classical Runge-Kutta step as a textbook writes it: eight variables,
 * Eq. (14)-(20) with libm's sine, cosine and tangent in every stage.  It shares
 * no code with the library. */
#ifndef ROLLCOIN_TESTS_TEXTBOOK_H
#define ROLLCOIN_TESTS_TEXTBOOK_H

#include <coin.h>

void textbook_step(coin_state *s, const coin_params *p, double dt);

#endif
