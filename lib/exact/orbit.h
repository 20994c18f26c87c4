/* SPDX-License-Identifier: MIT */
/* What the private members of a coin_orbit are.
 *
 * A is the turning point of theta last before the start, B the next one.  The
 * time from A to B is cut into pieces; within each, lean, pose and rates are
 * polynomials of the time since the piece's centre.  Units are radii and a
 * power of two times 1 T near 1/W, so that nothing overflows and no input is
 * rounded.  The path is in the
 * frame of A: it begins there, with phi = psi = 0. */
#ifndef ROLLCOIN_ORBIT_H
#define ROLLCOIN_ORBIT_H

#include "../motion/precision.h"

#include <coin.h>

enum { COIN_PRIV_PIECES = 24, COIN_PRIV_TERMS = 20, COIN_PRIV_ROWS = 8 };

/* The rows, a term's numbers: lean and pose, and the rates. */
enum {
    COIN_PRIV_THETA,
    COIN_PRIV_PHI,
    COIN_PRIV_PSI,
    COIN_PRIV_WX,
    COIN_PRIV_WY,
    COIN_PRIV_WZ,
    COIN_PRIV_Z,
    COIN_PRIV_X
};

/* private_frame of an orbit with a period; "in three" as coin_priv_split(). */
enum {
    COIN_PRIV_RATE,        /* 1 over the unit of time */
    COIN_PRIV_COUNT,       /* how many pieces there are */
    COIN_PRIV_BACK,        /* how many of them lie before the start's */
    COIN_PRIV_SINCE,       /* the time from A to the start, in two parts */
    COIN_PRIV_OVER = 5,    /* 1 over the period */
    COIN_PRIV_PERIOD,      /* in three */
    COIN_PRIV_HEADING = 9, /* per period, in three */
    COIN_PRIV_ROLL = 12,   /* per period, in three */
    COIN_PRIV_TURN = 15,   /* heading per period in turns, to the nearest whole
                              one, in three */
    COIN_PRIV_PHI0 = 18,   /* of the start, and what A to the start adds */
    COIN_PRIV_PSI0 = 20,
    COIN_PRIV_AXIS = 22,  /* radius times cosine and sine of A's heading */
    COIN_PRIV_PLACE = 24, /* z and x of A's centre of mass */
    COIN_PRIV_SWING = 26, /* of (58): L/sin(b), or 0 if b = 0 */
    COIN_PRIV_DRIFT       /* L if b = 0 */
};

/* private_frame of a steady motion, whose start is the first term. */
enum {
    COIN_PRIV_STEADY_HEADING,
    COIN_PRIV_STEADY_ROLL,
    COIN_PRIV_STEADY_SPEED
};

/* Where a piece's term lies. */
static inline const double *coin_priv_term(const coin_orbit *o, int piece,
                                           int k)
{
    return o->private_terms + COIN_PRIV_ROWS * (COIN_PRIV_TERMS * piece + k);
}

/* The piece of a rank in time.  The start's is the first, those after it
 * follow, then those before it, backward. */
static inline int coin_priv_piece(int rank, int back, int count)
{
    return rank < back ? count - 1 - rank : rank - back;
}

/* The nearest integer, |x| <= 2^51. */
static inline double coin_priv_round(double x)
{
    return (x + COIN_PRIV_ROUNDER) - COIN_PRIV_ROUNDER;
}

/* high + low as two parts of 22 bits and the rest: an integer of up to 31 bits
 * times one of the two is exact. */
static inline void coin_priv_split(double part[3], double high, double low)
{
    const double shift = 2147483649.0; /* 2^31 + 1 */
    part[0] = high * shift - (high * shift - high);
    const double rest = high - part[0];
    part[1] = rest * shift - (rest * shift - rest);
    part[2] = (rest - part[1]) + low;
}

#endif
