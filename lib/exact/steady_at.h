/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_STEADY_AT_H
#define ROLLCOIN_STEADY_AT_H

#include <coin.h>

/* The constant rates of a steady motion: d(phi)/dt, d(psi)/dt, and the centre's
 * speed along its path. */
typedef struct coin_priv_steady {
    double heading, roll, speed;
} coin_priv_steady;

/* Moves a steady state by any time; it may leave its range. */
void coin_priv_steady_move(coin_state *s, const coin_priv_steady *rates,
                           double t);

#endif
