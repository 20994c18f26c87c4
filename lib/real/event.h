/* SPDX-License-Identifier: MIT */
/* The first moment of a piece of motion at which a real coin would slip or lift
 * off, or is nearly flat. */
#ifndef ROLLCOIN_EVENT_H
#define ROLLCOIN_EVENT_H

#include "../step/extrapolation.h"

#include "bernstein.h"

/* What is looked for: bits of coin_check(), within a time tol [T].  The unit
 * of time of the series is that of a step of stride 1. */
typedef struct coin_priv_search {
    const coin_params *p;
    double mu, tol, unit;
    int32_t bits;
} coin_priv_search;

/* A piece of the motion: a tau from where a run stood, and the force at both
 * ends. */
typedef struct coin_priv_piece {
    coin_priv_run from;
    double tau;
    coin_priv_force begin, end;
} coin_priv_piece;

/* A moment of a piece: how far in it, 0 to 1, the run that leads there, whose
 * added.t is the time since the piece began, and the bits that hold. */
typedef struct coin_priv_moment {
    double x;
    coin_priv_run run;
    int32_t bits;
} coin_priv_moment;

/* The bits looked for that hold. */
int32_t coin_priv_bits_held(const coin_priv_search *f, const coin_state *s);

/* The first event of a piece at whose begin none of the bits holds, within tol
 * of where the event begins; 0 if there is none. */
int coin_priv_first_event(coin_priv_moment *out, const coin_priv_search *f,
                          const coin_priv_piece *w);

#endif
