/* SPDX-License-Identifier: MIT */
#ifndef COUNTED_H
#define COUNTED_H

#include <coin.h>

/* coin_advance() that adds the right-hand sides it takes to
 * workprec_slopes. */
int32_t counted_advance(coin_state *s, const coin_params *p, double t,
                        double tol, double *reached);

#endif
