/* SPDX-License-Identifier: MIT */
/* The last fall of a coin whose contact has stopped. */
#ifndef ROLLCOIN_HOLD_H
#define ROLLCOIN_HOLD_H

#include "losses.h"

/* A coin near flat while d(psi)/dt = 0 is held: it turns about the vertical
 * through its point of contact, without slip.  Eq. (72). */
typedef struct PRIV(held_fall) {
    real x;   /* the angle from flat, pi/2 - |theta| */
    real v;   /* -dx/dt */
    real L;   /* the angular momentum about the vertical */
    real phi; /* the heading gained */
} PRIV(held_fall);

/* The power of other losses counts as 0 below this part of endless_power(). */
#define COIN_PRIV_NO_PART K(1e-6)

/* A contact counts as stopped where u^2, with u = cos(theta) d(psi)/dt, is at
 * most this: the square of a part eps of the rates of a fall. */
COIN_PRIV_INLINE real PRIV(stopped_speed2)(const PRIV(body) * b,
                                           const PRIV(variables) * y, real eps)
{
    return eps * eps * (y->wX * y->wX + b->GJ * y->cth);
}

/* The torque of the losses along e_Z at a u with this square. */
COIN_PRIV_INLINE real PRIV(holding_torque)(const PRIV(losses) * l, real u2,
                                           real cth)
{
    const real u = SQRT(u2);
    return u * PRIV(grip)(l, u, cth);
}

/* The power, by tau, by which rolling and damping, which never stop a contact,
 * take energy from the lean of a coin near flat; 0 where other losses take a
 * part as well. */
COIN_PRIV_INLINE real PRIV(endless_power)(const PRIV(losses) * l,
                                          const PRIV(variables) * y)
{
    const real u = PRIV(roll_speed)(y->wY, y->wZ, y->sth, y->cth);
    const real T2 = l->J * y->wX * y->wX + l->IX * y->wY * y->wY;
    PRIV(losses) rolling = *l;
    rolling.dry = rolling.fluid = 0;
    const real faded = l->damping * FABS(u) * T2;
    const real own = u * u * PRIV(grip)(&rolling, u, y->cth) + faded;
    const real all = u * u * PRIV(grip)(l, u, y->cth) + faded;
    return all - own <= COIN_PRIV_NO_PART * own ? own : 0;
}

/* Whether the contact of a coin near flat has stopped, to within a part eps of
 * the rates of the fall, and the losses can hold it. */
int PRIV(is_held)(const PRIV(losses) * l, const PRIV(body) * b,
                  const PRIV(variables) * y, real eps);

/* The fall that begins at *y. */
PRIV(held_fall)
PRIV(fall_of)(const PRIV(losses) * l, const PRIV(variables) * y);

/* Moves the fall on by the time t, which does not lead beyond flat. */
void PRIV(fall_by)(PRIV(held_fall) * f, const PRIV(losses) * l,
                   const PRIV(body) * b, real t);

/* The time until the coin is flat. */
real PRIV(fall_time)(const PRIV(held_fall) * f, const PRIV(losses) * l,
                     const PRIV(body) * b);

/* A time in which a rising coin at most doubles its angle from flat.  If the
 * coin stops rising within that time, it is falling at the end of it.  The time
 * is at least the rounding of the time of a fall.  Otherwise it could be 0, and
 * the rise would not end. */
real PRIV(rise_time)(const PRIV(held_fall) * f, const PRIV(losses) * l,
                     const PRIV(body) * b);

/* d(phi)/dt. */
real PRIV(fall_turn)(const PRIV(held_fall) * f, const PRIV(losses) * l);

#endif
