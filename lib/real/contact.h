/* SPDX-License-Identifier: MIT */
/* A coin that slips: the force of the table on it, and its slopes.
 *
 * Lengths are in radii.  Slopes are by Sundman's time, dt = cos(theta) dtau;
 * those of a coin whose contact is held near flat, d(psi)/dt = 0, are by t.
 * Forces are over M a, and times cos(theta) unless the contact is held. */
#ifndef ROLLCOIN_CONTACT_H
#define ROLLCOIN_CONTACT_H

#include "losses.h"

/* The variables of a step.  All are doubles, so that the method takes them as
 * an array.  uX, uh: the slip velocity along e_X and e_h = (sin phi, 0, cos
 * phi).  phi, psi, x, z and t are what the step adds: no slope reads them. */
typedef struct coin_priv_slip {
    double wX, wY, wZ, sth, cth, uX, uh; /* what the force depends on */
    double sph, cph;                     /* what the path depends on */
    double phi, psi, x, z, t;
} coin_priv_slip;

enum { COIN_PRIV_SLIP_SIZE = sizeof(coin_priv_slip) / sizeof(double) };

/* What the force at the contact depends on: the body, the friction and the
 * losses.  l.K is I_Z instead of I_Z + M a^2: a torque about e_Z turns a
 * slipping coin, and does not move its centre.  friction.c sets it. */
typedef struct coin_priv_contact {
    coin_priv_body b;
    coin_priv_losses l;
    double mu_static, mu_kinetic;
    double w0;    /* 1 over the natural unit of time */
    double most;  /* of coin_priv_slip_size(): beyond it a trial has failed */
    int psi_held; /* 1: near flat the losses keep d(psi)/dt = 0, and slopes
                     are by t */
} coin_priv_contact;

typedef struct coin_priv_push {
    double N, X, h; /* along e_y, e_X, e_h */
} coin_priv_push;

/* A direction along the table. */
typedef struct coin_priv_direction {
    double X, h;
} coin_priv_direction;

/* Whether p lets a coin slide as f says and slow as l, which may be null:
 * COIN_OK and *out, or COIN_EPARAMS.  Neither p nor f is null. */
int32_t coin_priv_contact_of(coin_priv_contact *out, const coin_params *p,
                             const coin_friction *f, const coin_losses *l);

/* The force that keeps the slip at 0, where y->uX and y->uh are 0. */
coin_priv_push coin_priv_static(const coin_priv_contact *contact,
                                const coin_priv_slip *y);

/* The friction against a slip in direction n. */
coin_priv_push coin_priv_kinetic(const coin_priv_contact *contact,
                                 const coin_priv_slip *y,
                                 coin_priv_direction n);

/* dtau/dsigma of (83) at a slip speed u. */
COIN_PRIV_INLINE double coin_priv_slip_scale(const coin_priv_contact *contact,
                                             double u)
{
    return u / (u + contact->w0); /* (83) */
}

/* The slopes by tau of a coin that rolls, and by sigma of one that slips.  In
 * sigma a slip begins and ends exponentially, and is smooth however near its
 * speed comes to 0.  For coin_priv_dopri8(); the problem is a
 * coin_priv_contact. */
void coin_priv_roll_slopes(double *dy, const double *y, const void *contact);
void coin_priv_slip_slopes(double *dy, const double *y, const void *contact);

/* The slopes under a force. */
void coin_priv_slopes_under(coin_priv_slip *d, const coin_priv_contact *contact,
                            const coin_priv_slip *y,
                            const coin_priv_push *force);

/* mu_static N - F of the static force, divided by mu_static if that is above 1,
 * plus an allowance for its rounding.  Below 0 the force leaves the cone of
 * friction. */
double coin_priv_margin(const coin_priv_contact *contact,
                        const coin_priv_slip *y);

/* Whether a coin whose contact leaves the cone of friction slips.  Otherwise it
 * lifts off: if mu_static is infinite, or if the N of a slip, (80), is not
 * above 0.  The sign of that N is the same for slips in all directions. */
int coin_priv_can_slip(const coin_priv_contact *contact,
                       const coin_priv_slip *y);

/* The direction in which a slip begins where sticking would need more friction
 * than mu_static gives: (84).  The friction of *stick is not 0. */
coin_priv_direction coin_priv_slip_direction(const coin_priv_contact *contact,
                                             const coin_priv_slip *y,
                                             const coin_priv_push *stick);

#endif
