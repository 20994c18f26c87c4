/* SPDX-License-Identifier: MIT */
/* The last fall of a coin whose contact has stopped. */
#ifndef ROLLCOIN_HOLD_H
#define ROLLCOIN_HOLD_H

#include "losses.h"

/* A coin near flat while d(psi)/dt = 0 is held: it turns about the vertical
 * through its point of contact.  Eq. (72). */
typedef struct coin_priv_held_fall {
    double x;   /* the angle from flat, pi/2 - |theta| */
    double v;   /* -dx/dt */
    double L;   /* the angular momentum about the vertical */
    double phi; /* the heading gained */
} coin_priv_held_fall;

/* Whether the contact of a coin near flat has stopped, within a part eps of
 * the rates that the fall has, and the losses are able to hold it there. */
int coin_priv_held(const coin_priv_losses *l, const coin_priv_body *b,
                   const coin_priv_variables *y, double eps);

/* The torque along e_Z that the losses give while it is so slow. */
double coin_priv_hold(const coin_priv_losses *l, const coin_priv_body *b,
                      const coin_priv_variables *y, double eps);

/* How the fall begins in *y. */
coin_priv_held_fall coin_priv_fall_of(const coin_priv_losses *l,
                                      const coin_priv_variables *y);

/* The fall after a time within it. */
coin_priv_held_fall coin_priv_fall_at(const coin_priv_held_fall *f,
                                      const coin_priv_losses *l,
                                      const coin_priv_body *b, double t);

/* The time until the coin is flat. */
double coin_priv_fall_time(const coin_priv_held_fall *f,
                           const coin_priv_losses *l, const coin_priv_body *b);

/* A time in which a rising coin at most doubles its angle from flat, or comes
 * to fall. */
double coin_priv_rise_time(const coin_priv_held_fall *f,
                           const coin_priv_losses *l, const coin_priv_body *b);

/* d(phi)/dt. */
double coin_priv_fall_turn(const coin_priv_held_fall *f,
                           const coin_priv_losses *l);

#endif
