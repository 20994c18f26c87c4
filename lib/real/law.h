/* SPDX-License-Identifier: MIT */
/* What a table does to a coin that touches it: its losses and its contact.
 *
 * Everything is in natural units, M = a = g = 1.  Slopes of a coin whose
 * contact rolls along the rim are by Sundman's time, dt = cos(theta) dtau;
 * those of a coin whose contact is held near flat, d(psi)/dt = 0, are by t. */
#ifndef ROLLCOIN_LAW_H
#define ROLLCOIN_LAW_H

#include "../air/air.h"
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

/* What a coin does, as bits; 0 rolls.  HELD is a bit of a contact under way
 * alone, ROCKS says how one ended; coin_priv_coin_mode() reads the others off a
 * coin.  SLIPS is 1, so that it is an index into J and K of a law.
 */
enum {
    COIN_PRIV_SLIPS = 1, /* against kinetic friction */
    COIN_PRIV_HELD = 2,  /* the losses keep d(psi)/dt = 0 */
    COIN_PRIV_AIR = 4,   /* it does not touch, lifts off, or comes down: an
                            impact is due */
    COIN_PRIV_RESTS = 8, /* it does not move; or a contact ended so, which may
                            go on as a slide on the face */
    COIN_PRIV_LIES = 16, /* it is on its face */
    COIN_PRIV_LINE = 32, /* it is on both rims, upright */
    COIN_PRIV_ROCKS = 64 /* the other rim comes down, upright */
};

/* The force of the table on a coin, times dt over the time of the slopes: cos
 * theta, or 1 while the contact is held. */
typedef struct coin_priv_push {
    double N, X, h; /* along e_y, e_X, e_h */
} coin_priv_push;

/* A direction along the table. */
typedef struct coin_priv_direction {
    double X, h;
} coin_priv_direction;

struct coin_priv_law;

/* contact.c, thick.c: slopes and force of one mode; *d are the slopes of all
 * that a step needs, times `by`, by the time of the mode.  A slip has the
 * direction n.  A null d leaves the slopes out.  The plain one is for a law
 * without thickness and pull. */
typedef coin_priv_push coin_priv_contact(double *d, const double *y,
                                         const struct coin_priv_law *l,
                                         int mode, coin_priv_direction n,
                                         double by);
coin_priv_contact coin_priv_plain_contact, coin_priv_thick_contact;

/* The losses, the friction and the body. */
typedef struct coin_priv_law {
    double IX, IZ;
    double half;       /* half the thickness, h */
    double eta;        /* h or -h: the place along the axis of the rim that
                          touches */
    double pull[2];    /* of the table, along x and z */
    int plain;         /* whether half and pull are 0 */
    double J[2], K[2]; /* I_X + 1 + h^2 and I_Z + 1 of a coin that rolls; I_X
                          and I_Z of one that slips */
    double perJ[2];    /* 1/J */
    double perK[2];    /* 1/(I_Z D) with D of (120), 1/K where h = 0; 1/I_Z */
    double damping, dry, viscous, layer, gap, rolling, spin, angular, soft;
    double flat; /* a coin with a smaller cos theta lies flat */
    double mu_static, mu_kinetic, restitution;
    coin_priv_contact *contact; /* the plain one, or the thick one */
    int lossy;         /* whether a coefficient of the losses is not 0 */
    int keeps_rolling; /* the contact neither slips nor lifts, as for
                      coin_settle() */
} coin_priv_law;

/* The pull along e_X and e_h. */
COIN_PRIV_INLINE coin_priv_direction coin_priv_pull_of(const double *y,
                                                       const coin_priv_law *l)
{
    const double sph = y[COIN_PRIV_SPH], cph = y[COIN_PRIV_CPH];
    const coin_priv_direction g = {l->pull[0] * cph - l->pull[1] * sph,
                                   l->pull[0] * sph + l->pull[1] * cph};
    return g;
}

/* losses.c: the law of a coin with these losses and without friction, or
 * COIN_EPARAMS. */
int32_t coin_priv_law_of(coin_priv_law *out, const coin_losses *l,
                         const coin_priv_constants *b);

/* table.c: the law of a table for a coin with this half thickness, or
 * COIN_EPARAMS. */
int32_t coin_priv_table_law(coin_priv_law *out, const coin_table *table,
                            const coin_priv_constants *b, double half);

/* Half the thickness, in radii. */
COIN_PRIV_INLINE double coin_priv_half_of(const coin_params *p)
{
    return p->thickness / (2 * p->radius);
}

/* The size of the pull. */
COIN_PRIV_INLINE double coin_priv_pull(const coin_priv_law *l)
{
    return sqrt(l->pull[0] * l->pull[0] + l->pull[1] * l->pull[1]);
}

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
        const double fade = l->damping * fabs(u);             /* (66) */
        const double pivot = l->spin * (wY * c - wZ * s) * c; /* (67) */
        const double all = l->angular * c;                    /* (95) */
        /* (68) */
        d.wX -= (fade + all * (l->IX * perJ)) * wX;
        d.wY -= pivot * c * l->perJ[1] + (fade + all) * wY;
        d.wZ += pivot * s * perK - (fade + all * (l->IZ * perK)) * wZ;
    }
    return d;
}

/* contact.c: the slopes of a coin in this mode, and the force of the table.  A
 * slip has the direction n.  Without a slip n is not read.  A null d leaves the
 * slopes out. */
coin_priv_push coin_priv_slopes(double *d, const double *y,
                                const coin_priv_law *l, int mode,
                                coin_priv_direction n);

/* dop853.h: what is integrated. */
typedef struct coin_priv_problem coin_priv_problem;

/* The slopes alone, by the time of the mode: tau, sigma, or t while the contact
 * is held; or, if of->by_t, by t.  1, or 0 if the rates have run away or the
 * coin is below the table.  A null d leaves the slopes out. */
int coin_priv_rates(double *d, const double *y, const coin_priv_problem *of);

/* Makes slopes those by t, and returns the factor. */
double coin_priv_by_t(double *d);

/* Sets the norm of a sine and a cosine to 1.  A step leaves a difference of the
 * size of its error. */
COIN_PRIV_INLINE void coin_priv_normalize_pair(double *s, double *c)
{
    const double per = 1 / sqrt(*s * *s + *c * *c);
    *s *= per;
    *c *= per;
}

/* The force on a coin that keeps to its mode. */
coin_priv_push coin_priv_push_of(const double *y, const coin_priv_law *l,
                                 int mode);

/* The distance of that force from the edge of what the contact can give, over
 * the size of its terms.  Below 0 the contact cannot give it: a rolling coin
 * begins to slip or lifts off, and a slipping coin lifts off. */
double coin_priv_contact_margin(const double *y, const coin_priv_law *l,
                                int mode);

/* The time in which no lift-off is looked at.  A coin that would fall back
 * within it does not lift off.  Measured: coin_priv_blind() in tables.md. */
COIN_PRIV_INLINE double coin_priv_blind(const double *y)
{
    return 1e-4 / (1 + fabs(y[COIN_PRIV_WX]) + fabs(y[COIN_PRIV_WY]) +
                   fabs(y[COIN_PRIV_WZ]));
}

/* Whether a coin whose contact cannot go on as it does lifts off, (96).  One
 * that would fall back within coin_priv_blind() does not. */
int coin_priv_leaves(const double *y, const coin_priv_law *l);

/* The direction in which a slip begins where sticking takes the force F. */
coin_priv_direction coin_priv_onset(const double *y, const coin_priv_law *l,
                                    int mode, coin_priv_push F);

/* held.c: by how much the losses can hold a stopped contact; below 0 it begins
 * to roll. */
double coin_priv_hold_margin(const double *y, const coin_priv_law *l, int mode,
                             double tol);

/* held.c: whether the losses keep d(psi)/dt = 0 until the coin lies flat, or
 * as long as it stays as near to flat as it is. */
int coin_priv_is_held(const double *y, const coin_priv_law *l, int mode,
                      double tol);

#endif
