/* SPDX-License-Identifier: MIT */
#ifndef TEXTBOOK_H
#define TEXTBOOK_H

#include <coin.h>

/* The yardstick: classical RK4 as a textbook has it, straight from (14)-(20):
 * 8 variables, a sine and a cosine of libm for each angle in every stage. */
void textbook_rates(double d[8], const coin_params *p, const double y[8]);
void textbook_run(coin_state *s, const coin_params *p, double dt,
                  unsigned long steps);

#endif
