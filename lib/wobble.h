/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_WOBBLE_H
#define ROLLCOIN_WOBBLE_H

#include "params.h"

/* A small swing about a steady motion.  Its neighbour on the leaf of the start
 * leans by `apart` more; the rest says how all answers to a lean y away from
 * the neighbour. */
typedef struct coin_priv_wobble {
    double L, apart;   /* lambda^2 */
    double wY, wZ;     /* d(wY)/dy, d(wZ)/dy */
    double phi, psi;   /* d(phi')/dy, d(psi')/dy */
    double dphi, dpsi; /* phi', psi' of the neighbour */
    double Y;          /* y at the start */
} coin_priv_wobble;

/* The swing of a sound start about a steady motion of that lambda^2;
 * COIN_EDOMAIN if it is too far off to be small. */
int32_t coin_priv_wobble_begin(coin_priv_wobble *w, const coin_state *steady,
                               const coin_state *start, const coin_priv_body *b,
                               double lambda2);

/* Where it is after t; COIN_ESTEP, and *out untouched, if that leads out of
 * range. */
int32_t coin_priv_wobble_move(const coin_priv_wobble *w,
                              const coin_state *start, const coin_priv_body *b,
                              double t, coin_state *out);

#endif
