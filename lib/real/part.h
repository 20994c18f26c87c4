/* SPDX-License-Identifier: MIT */
/* Where a real coin would slip or lift off, or is nearly flat, according to the
 * polynomials that join the series at both ends of a stretch of motion, or of a
 * part of it. */
#ifndef ROLLCOIN_PART_H
#define ROLLCOIN_PART_H

#include "bernstein.h"
#include "stretch.h"

/* COIN_NEARLY_FLAT begins at this cos theta. */
#define COIN_PRIV_NEARLY_FLAT 0.01

/* What is looked for: bits of coin_check(), within a time tol [T].  No
 * bit holds where less F < more N: those are 1/mu and 1, or 1 and mu, so that
 * neither is above 1; and 0 and 1 if slipping does not count. */
typedef struct coin_priv_search {
    const coin_params *p;
    double mu, less, more, tol;
    int32_t bits;
} coin_priv_search;

/* A curve over a stretch of h strides errs by less than (h/these)^(2 terms) of
 * the forces at both ends, and cos theta by less of its values there
 * (test_force). */
#define COIN_PRIV_REACH 2.85
#define COIN_PRIV_SOME_REACH 2.55
#define COIN_PRIV_FEW_REACH 2.2

/* The least number of terms that may do for a stretch of so many strides, which
 * begins where the one before ends: *at is the force on that one. */
int coin_priv_terms_for(const coin_priv_search *f, const coin_priv_force *at,
                        double stride);

/* Whether no bit holds on a way of h in the unit of the series, of so many
 * strides, beyond doubt: by the terms that *at has. */
int coin_priv_is_clear(const coin_priv_search *f, const coin_priv_force *at,
                       double h, double stride);

/* Whether no bit holds on a stretch, beyond doubt: by so many terms, or else by
 * all.  `one` is the tau of a stride. */
int coin_priv_is_clear_all_along(const coin_priv_search *f,
                                 coin_priv_stretch *w, double one, int terms);

/* The force along a curve in Bernstein's form, scaled so that the coin slips
 * where along^2 + across^2 > bound^2. */
typedef struct coin_priv_curve {
    double along[COIN_PRIV_JOINED + 1];
    double across[COIN_PRIV_JOINED + 1];
    double bound[COIN_PRIV_JOINED + 1];
} coin_priv_curve;

/* A part of a stretch, and its polynomials: those are set that the bits looked
 * for need. */
typedef struct coin_priv_part {
    const coin_priv_stretch *of;
    double first, width; /* the whole stretch is 0, 1 */
    coin_priv_curve force;
    double normal[COIN_PRIV_JOINED + 1], cth[COIN_PRIV_JOINED + 1];
} coin_priv_part;

/* Sets the polynomials by the forces at the ends of the part, of all terms. */
void coin_priv_join_part(coin_priv_part *w, const coin_priv_search *f,
                         const coin_priv_force *at);

/* Where in a part, 0 to 1, a bit holds; from > 1 if nowhere. */
typedef struct coin_priv_place {
    double from, to;
} coin_priv_place;

/* The next place beyond `from` where a bit holds. */
coin_priv_place coin_priv_next_place(const coin_priv_search *f,
                                     const coin_priv_part *w, double from);

#endif
