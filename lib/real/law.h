/* SPDX-License-Identifier: MIT */
/* What a table does to a coin that touches it: its losses and its contact.
 *
 * Everything is in natural units, M = a = g = 1.  Slopes of a coin whose
 * contact rolls along the rim are by Sundman's time, dt = cos(theta) dtau;
 * those of a coin whose contact is held near flat, d(psi)/dt = 0, are by t. */
#ifndef ROLLCOIN_LAW_H
#define ROLLCOIN_LAW_H

#include "../motion/state.h"

#include <math.h>

/* The variables of a step.  uX, uh: the slip velocity along e_X and along e_h =
 * (sin phi, 0, cos phi).  The first COIN_PRIV_READ are read by the slopes; phi,
 * psi, x, z and t are what a step adds. */
enum {
    COIN_PRIV_WX,
    COIN_PRIV_WY,
    COIN_PRIV_WZ,
    COIN_PRIV_S, /* sin theta */
    COIN_PRIV_C, /* cos theta */
    COIN_PRIV_UX,
    COIN_PRIV_UH,
    COIN_PRIV_SPH, /* sin phi */
    COIN_PRIV_CPH,
    COIN_PRIV_READ,
    COIN_PRIV_ADDS_PHI = COIN_PRIV_READ,
    COIN_PRIV_ADDS_PSI,
    COIN_PRIV_ADDS_X,
    COIN_PRIV_ADDS_Z,
    COIN_PRIV_ADDS_T,
    COIN_PRIV_SIZE,
    COIN_PRIV_WIDE = 16 /* with what fills the last vector of a step */
};

/* What a coin does, as bits; 0 rolls.  A coin_priv_moving is a coin in contact:
 * HELD and IDLE are bits of it alone, AIR and RESTS say how its contact ended.
 * coin_priv_body_mode() reads the other bits off a coin_body.  SLIPS is 1, so
 * that it is an index into J and K of a law. */
enum {
    COIN_PRIV_SLIPS = 1,  /* against kinetic friction */
    COIN_PRIV_HELD = 2,   /* the losses keep d(psi)/dt = 0 */
    COIN_PRIV_IDLE = 4,   /* for one step the losses do not act, nor hold the
                             contact: N would be negative */
    COIN_PRIV_AIR = 8,    /* the contact lifts off; a body: it does not touch */
    COIN_PRIV_RESTS = 16, /* the coin has come down on its face, and may slide
                             there; a body: it lies flat without motion */
    COIN_PRIV_LIES = 32   /* a body: it slides on its face */
};

/* The losses, the friction and the body. */
typedef struct coin_priv_law {
    double IX, IZ;
    double J[2], K[2]; /* I_X + 1 and I_Z + 1 of a coin that rolls; I_X and I_Z
                          of one that slips */
    double perJ[2], perK[2]; /* 1/J, 1/K */
    double damping, dry, viscous, layer, gap, rolling, spin, angular, soft;
    double flat; /* a coin with a smaller cos theta lies flat */
    double mu_static, mu_kinetic;
    int lossy;         /* whether a coefficient of the losses is not 0 */
    int keeps_rolling; /* the contact neither slips nor lifts, as for
                      coin_settle() */
} coin_priv_law;

/* The force of the table on a coin, times dt over the time of the slopes: cos
 * theta, or 1 while the contact is held. */
typedef struct coin_priv_push {
    double N, X, h; /* along e_y, e_X, e_h */
} coin_priv_push;

/* A direction along the table. */
typedef struct coin_priv_direction {
    double X, h;
} coin_priv_direction;

/* losses.c: the law of a coin with these losses and without friction, or
 * COIN_EPARAMS. */
int32_t coin_priv_law_of(coin_priv_law *out, const coin_losses *l,
                         const coin_priv_body *b);

/* table.c: the law of a table, or COIN_EPARAMS. */
int32_t coin_priv_table_law(coin_priv_law *out, const coin_table *table,
                            const coin_priv_body *b);

/* u = cos(theta) d(psi)/dt: how fast the contact rolls along the rim. */
COIN_PRIV_INLINE double coin_priv_roll_speed(const double *y)
{
    return y[COIN_PRIV_C] * y[COIN_PRIV_WZ] + y[COIN_PRIV_S] * y[COIN_PRIV_WY];
}

/* -Q/u of the contour friction.  c may be below 0: the polynomial of a step may
 * fall through the table, before the event is found that ends it. */
COIN_PRIV_INLINE double coin_priv_grip(const coin_priv_law *l, double u,
                                       double c)
{
    const double solid = l->dry + l->rolling * c, q = 1 / c;
    const double fluid = l->viscous + l->gap * q;
    double grip = q * fluid; /* (65) */
    if (solid > 0)
        grip += solid / sqrt(u * u + l->soft * l->soft * (c * c)); /* (65) */
    if (l->layer > 0)
        grip += q * (l->layer * sqrt(fabs(u * q))); /* (65) */
    return grip;
}

/* What the losses add to the slopes of wX, wY, wZ by tau. */
typedef struct coin_priv_slowing {
    double wX, wY, wZ;
} coin_priv_slowing;

COIN_PRIV_INLINE coin_priv_slowing coin_priv_slowing_of(const coin_priv_law *l,
                                                        const double *y,
                                                        int slips)
{
    const double wX = y[COIN_PRIV_WX], wY = y[COIN_PRIV_WY];
    const double wZ = y[COIN_PRIV_WZ], s = y[COIN_PRIV_S], c = y[COIN_PRIV_C];
    const double perJ = l->perJ[slips], perK = l->perK[slips];
    const double u = coin_priv_roll_speed(y);
    const double Q = -u * coin_priv_grip(l, u, c);
    coin_priv_slowing d = {0, Q * s * l->perJ[1], Q * c * perK}; /* (68) */
    if (COIN_PRIV_RARELY(l->damping + l->spin + l->angular > 0)) {
        const double fade = l->damping * fabs(u);            /* (66) */
        const double turn = l->spin * (wY * c - wZ * s) * c; /* (67) */
        const double all = l->angular * c;                   /* (95) */
        /* (68) */
        d.wX -= (fade + all * (l->IX * perJ)) * wX;
        d.wY -= turn * c * l->perJ[1] + (fade + all) * wY;
        d.wZ += turn * s * perK - (fade + all * (l->IZ * perK)) * wZ;
    }
    return d;
}

/* contact.c: the slopes of a coin in this mode, and the force of the table.  A
 * slip has the direction n.  Without a slip n is not read.  A null d leaves the
 * slopes out. */
coin_priv_push coin_priv_slopes(double *d, const double *y,
                                const coin_priv_law *l, int mode,
                                coin_priv_direction n);

/* The slopes alone, by the time of the mode: tau, sigma, or t while the contact
 * is held. */
void coin_priv_rates(double *d, const double *y, const coin_priv_law *l,
                     int mode);

/* The force on a coin that keeps to its mode. */
coin_priv_push coin_priv_push_of(const double *y, const coin_priv_law *l,
                                 int mode);

/* The distance of that force from the edge of what the contact can give, over
 * the size of its terms.  Below 0 the contact cannot give it: a rolling coin
 * begins to slip or lifts off, and a slipping coin lifts off.  A coin with
 * damping cannot slip: below 0 it lifts off, by coin_priv_weight(). */
double coin_priv_contact_margin(const double *y, const coin_priv_law *l,
                                int mode);

/* Minus the free acceleration of the gap under the contact, times cos theta.
 * Above 0 the table presses, or the coin falls back on it (96). */
double coin_priv_weight(const double *y, const coin_priv_law *l);

/* The time in which no lift-off is looked at.  A coin that would fall back
 * within it does not lift off.  With a tenth of it 5 calls of make tuning
 * instead of 2 end by COIN_ESTEP; with ten times of it tosses become others. */
COIN_PRIV_INLINE double coin_priv_blind(const double *y)
{
    return 1e-4 / (1 + fabs(y[COIN_PRIV_WX]) + fabs(y[COIN_PRIV_WY]) +
                   fabs(y[COIN_PRIV_WZ]));
}

/* Whether a coin whose contact cannot go on as it does lifts off, by the weight
 * above.  One that would fall back within coin_priv_blind() does not. */
int coin_priv_leaves(const double *y, const coin_priv_law *l);

/* The direction in which a slip begins where sticking takes the force F. */
coin_priv_direction coin_priv_onset(const double *y, const coin_priv_law *l,
                                    int mode, coin_priv_push F);

/* A function of x, and its value at one. */
typedef double coin_priv_function(const void *of, double x);
typedef struct coin_priv_place {
    double x, at;
} coin_priv_place;

/* contact.c: an x within `width` after the root of a function, which is not
 * negative at a and negative at b > a. */
double coin_priv_root(coin_priv_function *f, const void *of, coin_priv_place a,
                      coin_priv_place b, double width);

/* held.c: by how much the losses can hold a stopped contact; below 0 it begins
 * to roll. */
double coin_priv_hold_margin(const double *y, const coin_priv_law *l, int mode,
                             double tol);

/* held.c: whether the losses keep d(psi)/dt = 0 until the coin lies flat, or
 * as long as it stays as near to flat as it is. */
int coin_priv_is_held(const double *y, const coin_priv_law *l, int mode,
                      double tol);

#endif
