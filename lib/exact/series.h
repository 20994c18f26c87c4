/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_SERIES_H
#define ROLLCOIN_SERIES_H

#include "../motion/equations.h"
#include "pair.h"
#include "pieces.h"

/* A motion about a point, as power series of time.  COIN_PRIV_ORDER: the
 * highest power.  A higher order reaches farther from a point, and costs its
 * square there (measured: COIN_PRIV_ORDER in tests/studies/tables.md).
 * COIN_PRIV_PATH: the row of z and x. */
enum { COIN_PRIV_ORDER = 28, COIN_PRIV_PATH = 3 };

typedef struct coin_priv_point {
    coin_priv_pair row[4]; /* theta phi | psi wX | wY wZ | z x, in radii */
    coin_priv_pair th, ph; /* cosine and sine of theta and of phi */
} coin_priv_point;

typedef struct coin_priv_series {
    coin_priv_point at[COIN_PRIV_ORDER + 1];
    double time, reach; /* set by half_period.c: the time of the point, and how
                           far from it the series may be used */
} coin_priv_series;

/* Computes all powers from at[0], which is given, but those of path and ph.
 * Time is in units in which the field's h is 1. */
void coin_priv_series_expand(coin_priv_series *s, const coin_priv_field *f);

/* Computes the powers of the path and of ph.  Both functions together cost as
 * much as 40 steps of COIN_RK4. */
void coin_priv_series_expand_path(coin_priv_series *s);

/* The point a time t later.  Its path and ph are not computed: they are those
 * of at[0]. */
coin_priv_point coin_priv_series_at(const coin_priv_series *s, double t);

/* The path a time t later. */
coin_priv_pair coin_priv_series_path(const coin_priv_series *s, double t);

/* Writes the rows of a piece that holds for times from -reach to reach. */
void coin_priv_series_economized(const coin_priv_series *s, double reach,
                                 double *rows);

#endif
