/* SPDX-License-Identifier: MIT */
/* A coin under way, in all modes, and what it does in the air and at an impact.
 * In contact phi, psi, x and z alone are current (real/move.h).
 *
 * All is in natural units, in which M = a = g = 1.  IX, IZ are I_X/(M a^2),
 * I_Z/(M a^2). */
#ifndef ROLLCOIN_AIR_H
#define ROLLCOIN_AIR_H

#include "../motion/equations.h"
#include "../motion/state.h"

/* A coin: its rates, the sines and cosines of its lean theta and of its heading
 * phi, half its thickness, the height of its centre and the velocity of that.
 * What only adds up is a sum: phi, psi, x, z. */
typedef struct coin_priv_coin {
    double wX, wY, wZ;
    coin_priv_sc th, ph;
    double half;
    double y, vx, vy, vz;
    coin_priv_sum phi, psi, x, z;
} coin_priv_coin;

/* The height of the centre above the lowest point, (118). */
COIN_PRIV_INLINE double coin_priv_height(const coin_priv_coin *c)
{
    return c->th.c + c->half * fabs(c->th.s);
}

/* Sets a coin upright if its rims are equally low, to rounding.  They differ by
 * 2 h |sin theta|; a height rounds by about 1 u. */
COIN_PRIV_INLINE void coin_priv_set_upright(coin_priv_coin *c)
{
    if (c->half > 0 && 2 * c->half * fabs(c->th.s) <= 4 * COIN_PRIV_EPSILON) {
        c->th.s = 0;
        c->th.c = 1;
    }
}

/* The place along the axis of the rim that is lower, or of two that are equally
 * low of the one that goes down faster: half or -half; 0 if both do. */
COIN_PRIV_INLINE double coin_priv_lower_rim(const coin_priv_coin *c)
{
    const double to = c->th.s != 0 ? c->th.s : c->wX;
    return to > 0 ? c->half : to < 0 ? -c->half : 0;
}

/* The energy of a coin that balances on a rim, (126): with less it cannot turn
 * over. */
COIN_PRIV_INLINE double coin_priv_barrier(double half)
{
    return sqrt(1 + half * half); /* (126) */
}

/* From the centre to the lowest point of a rim, (118): the lever along e_h and
 * the height. */
typedef struct coin_priv_lever {
    double P, Y;
} coin_priv_lever;

COIN_PRIV_INLINE coin_priv_lever coin_priv_lever_of(double s, double c,
                                                    double eta)
{
    const coin_priv_lever r = {s - eta * c, c + eta * s};
    return r;
}

/* A flight of a coin: a symmetric top, which turns about its axis at the rate
 * sigma while the axis turns about k.  Its turn is slowed at the rate
 * `angular`: it is that of a free one at the time of coin_priv_decay_of(). */
typedef struct coin_priv_flight {
    coin_priv_coin from;
    double kX, kY, kZ; /* a unit vector along the axes at the start */
    double rate;       /* of the precession about k */
    double sigma;      /* the rate about e_Z besides it */
    double angular;    /* of coin_losses */
    double pull[2];    /* along x and z */
} coin_priv_flight;

/* A flight without a pull. */
void coin_priv_flight_of(coin_priv_flight *f, const coin_priv_coin *c,
                         double IX, double IZ, double angular);

/* exp(-x) and (1 - exp(-x))/x. */
typedef struct coin_priv_decay {
    double left, part;
} coin_priv_decay;

/* For x >= 0.  Accuracy: 8 u of `part`, and 8 u in `left` (test_flight). */
coin_priv_decay coin_priv_decay_of(double x);

/* Sets *c to where the coin is after t.  phi and psi come to lie in [-pi, pi],
 * to rounding.  Accuracy: 1e-15 (1 + (rate + |sigma|) t) (test_flight), also
 * where that angle is so large that nothing is left of it: it is reduced to its
 * rounding. */
void coin_priv_fly(coin_priv_coin *c, const coin_priv_flight *f, double t);

/* What a search for a touch comes to. */
typedef struct coin_priv_touch {
    double t;    /* of the touch; else there is none up to here */
    int touches; /* whether it touches */
    int looks;   /* how often the gap has been computed */
} coin_priv_touch;

/* The first time within t at which the rim at eta touches the table.  leaves:
 * its lowest point is on the table at the start and moves up.  The search has a
 * limit: it may end before t. */
coin_priv_touch coin_priv_rim_touch(const coin_priv_flight *f, double eta,
                                    double t, int leaves);

/* The same for the rim that touches first. */
coin_priv_touch coin_priv_first_touch(const coin_priv_flight *f, double t,
                                      int leaves);

/* The velocity of the lowest point of the rim at eta along e_X, e_h and e_y. */
typedef struct coin_priv_rim {
    double X, h, y;
} coin_priv_rim;

coin_priv_rim coin_priv_rim_of(const coin_priv_coin *c, double eta);

/* What the table does to a coin that hits it. */
typedef struct coin_priv_bounce {
    double restitution, mu_static, mu_kinetic;
} coin_priv_bounce;

/* The impact of a coin whose rim at eta touches and moves down. */
void coin_priv_impact(coin_priv_coin *c, double eta, double IX, double IZ,
                      const coin_priv_bounce *law);

#endif
