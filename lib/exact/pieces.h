/* SPDX-License-Identifier: MIT */
/* What the private members of a coin_orbit are.
 *
 * A is the turning point of theta last before the start, B the next one.  The
 * time from A to B is cut into pieces; within each, lean and pose are
 * polynomials of the time since the piece's centre, and the rates follow from
 * their derivatives.  Units are radii and a power of two times 1 T near 1/W,
 * so that nothing overflows and no input is rounded.  The path is in the frame
 * of A: it begins at A, with phi = psi = 0. */
#ifndef ROLLCOIN_PIECES_H
#define ROLLCOIN_PIECES_H

#include "../motion/angles.h"
#include "pair.h"

#include <coin.h>

/* As coin_orbit has room for: with 42 pieces it fills 32,768 bytes (measured:
 * COIN_PRIV_PIECES in tests/studies/tables.md).  They are in the order of time.
 * An edge is where a piece begins; the last one is B. */
enum { COIN_PRIV_PIECES = 42 };

/* The rows of a piece, each with its terms, the constant one first.  Terms are
 * read in pairs (measured: COIN_PRIV_TERMS in tables.md). */
enum {
    COIN_PRIV_THETA,
    COIN_PRIV_PHI,
    COIN_PRIV_PSI,
    COIN_PRIV_Z,
    COIN_PRIV_X,
    COIN_PRIV_ROWS,
    COIN_PRIV_TERMS = 18,
    COIN_PRIV_PIECE = COIN_PRIV_ROWS * COIN_PRIV_TERMS
};

/* private_frame[0] of every orbit.  Other contents of memory hardly have this
 * value, and orbits of other versions of the library have another. */
#define COIN_PRIV_VERSION                                                      \
    (65536.0 * COIN_VERSION_MAJOR + 256.0 * COIN_VERSION_MINOR +               \
     COIN_VERSION_PATCH)
#define COIN_PRIV_FORMAT (2.2073158e-107 * (16777216.0 + COIN_PRIV_VERSION))

/* private_frame of an orbit with a period.  "In three": as the three parts that
 * coin_priv_split() gives. */
enum {
    COIN_PRIV_RATE = 1,     /* 1 over the unit of time */
    COIN_PRIV_COUNT,        /* how many pieces there are */
    COIN_PRIV_SINCE,        /* the time from A to the start */
    COIN_PRIV_OVER,         /* 1 over the period */
    COIN_PRIV_PERIOD = 7,   /* in three */
    COIN_PRIV_HEADING = 10, /* per period, in three */
    COIN_PRIV_ROLL = 13,    /* per period, in three */
    COIN_PRIV_TURN = 16,    /* heading per period in turns, less the nearest
                               whole number, in three */
    COIN_PRIV_PHI0 = 19,    /* phi of the start; phi of A minus that */
    COIN_PRIV_PSI0 = 21,    /* the same of psi */
    COIN_PRIV_AXIS = 23,    /* radius times cosine and sine of A's heading */
    COIN_PRIV_PLACE = 25,   /* z and x of the centre of mass at A */
    COIN_PRIV_SWING = 27,   /* of (58): L/sin(b), or 0 if b is next to 0 */
    COIN_PRIV_DRIFT,        /* L if b is next to 0 */
    COIN_PRIV_FAR = 30,     /* the largest x and z, of a steady motion too */
    COIN_PRIV_W2_MAX        /* the largest square of a rate, likewise */
};

/* private_frame of a steady motion, whose start is private_terms: theta, phi,
 * psi, z, x, wY, wZ. */
enum {
    COIN_PRIV_STEADY_HEADING = 1,
    COIN_PRIV_STEADY_ROLL,
    COIN_PRIV_STEADY_SPEED
};

/* Where a piece's row begins. */
static inline const double *coin_priv_row(const coin_orbit *o, int piece,
                                          int row)
{
    return o->private_terms + COIN_PRIV_PIECE * piece + COIN_PRIV_TERMS * row;
}

/* A row a time t after its piece's centre, and its derivative: even and odd
 * powers side by side, E(t^2) + t O(t^2). */
COIN_PRIV_INLINE coin_priv_pair coin_priv_row_at(const double *row, double t)
{
    const coin_priv_pair u = coin_priv_pair_both(t * t);
    coin_priv_pair sum = coin_priv_pair_load(row + COIN_PRIV_TERMS - 2);
    coin_priv_pair slope = coin_priv_pair_both(0);
#define COIN_PRIV_POWER(k)                                                     \
    slope = coin_priv_pair_add_product(sum, slope, u);                         \
    sum = coin_priv_pair_add_product(coin_priv_pair_load(row + (k)), sum, u)
    COIN_PRIV_POWER(14);
    COIN_PRIV_POWER(12);
    COIN_PRIV_POWER(10);
    COIN_PRIV_POWER(8);
    COIN_PRIV_POWER(6);
    COIN_PRIV_POWER(4);
    COIN_PRIV_POWER(2);
    COIN_PRIV_POWER(0);
    const double E = COIN_PRIV_ELEMENT(sum, 0), O = COIN_PRIV_ELEMENT(sum, 1);
    const double dE = COIN_PRIV_ELEMENT(slope, 0),
                 dO = COIN_PRIV_ELEMENT(slope, 1);
    return coin_priv_pair_make(E + t * O, O + 2 * (t * (dE + t * dO)));
}

/* Solves (18) and (19) for wY and wZ. */
COIN_PRIV_INLINE void coin_priv_spin_rates(double *wY, double *wZ, double dphi,
                                           double dpsi, coin_priv_sc th)
{
    *wY = dphi * th.c;        /* from (18) */
    *wZ = dpsi - dphi * th.s; /* from (19) */
}

/* The nearest integer, |x| <= 2^51. */
static inline double coin_priv_round(double x)
{
    return (x + COIN_PRIV_ROUNDER) - COIN_PRIV_ROUNDER;
}

/* value + remainder as two parts of 22 bits and the rest.  The product of an
 * integer of up to 31 bits and one of the first two parts is exact. */
static inline void coin_priv_split(double part[3], double value,
                                   double remainder)
{
    const double shift = 2147483649.0; /* 2^31 + 1 */
    part[0] = value * shift - (value * shift - value);
    const double rest = value - part[0];
    part[1] = rest * shift - (rest * shift - rest);
    part[2] = (rest - part[1]) + remainder;
}

#endif
