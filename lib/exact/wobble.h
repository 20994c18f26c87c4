/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_WOBBLE_H
#define ROLLCOIN_WOBBLE_H

#include "../motion/body.h"
#include "../motion/equations.h"

/* Coefficients kept of the lean's acceleration along a leaf. */
enum { COIN_PRIV_WOBBLE_TERMS = 6 };

/* A small wobble, prepared for any number of times.  The leaf of a state is the
 * set of all states with its K_Y and K_Z.  The neighbour is the steady motion
 * on the leaf of the start, to first order, (60).  y is the lean minus that of
 * the neighbour. */
typedef struct coin_priv_wobble {
    coin_state start;
    double a;
    double L, rate;  /* lambda^2 and sqrt |lambda^2| */
    double apart;    /* lean of the neighbour minus that of the steady motion */
    double Y, v;     /* lean of the start minus the neighbour's; wX/rate */
    double wY, wZ;   /* d(wY)/dy, d(wZ)/dy */
    double phi, psi; /* d(phi')/dy, d(psi')/dy */
    double dphi, dpsi; /* phi', psi' of the neighbour */
    /* On the leaf of the start |wX' - lambda^2 y| is at most rounding + the sum
     * of left_out[k] (|y|/cth)^k.  cth is cos theta of the neighbour. */
    double left_out[COIN_PRIV_WOBBLE_TERMS], rounding, cth;
} coin_priv_wobble;

/* COIN_OK, or COIN_EDOMAIN if the neighbour is too far away.  steady, with
 * sine and cosine of its lean, has passed coin_priv_check_steady(), and start
 * coin_priv_check_state(). */
int32_t coin_priv_wobble_begin(coin_priv_wobble *w, const coin_state *steady,
                               const coin_state *start, const coin_priv_body *b,
                               const coin_priv_sc *th);

/* The state after t, which is finite: COIN_OK, or COIN_ESTEP and COIN_EDOMAIN
 * as coin_wobble_at(), and *out untouched. */
int32_t coin_priv_wobble_at(const coin_priv_wobble *w, const coin_priv_body *b,
                            double t, coin_state *out);

#endif
