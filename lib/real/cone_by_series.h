/* SPDX-License-Identifier: MIT */
/* Where a real coin would slip or lift off, or is nearly flat, according to the
 * polynomials that join the series at both ends of a stretch of motion, or of a
 * part of it. */
#ifndef ROLLCOIN_CONE_BY_SERIES_H
#define ROLLCOIN_CONE_BY_SERIES_H

#include "../motion/rest.h"

#include "bernstein.h"
#include "stretch.h"

/* What is looked for: bits of coin_check(), to within a time tol [T].  The coin
 * neither slips nor lifts off where per_F F < per_N N.  The pair per_F, per_N
 * is (1, mu) for mu <= 1 and (1/mu, 1) above; (0, 1) if no slip counts. */
typedef struct coin_priv_search {
    const coin_params *p;
    double mu, per_F, per_N, tol;
    int32_t bits;
} coin_priv_search;

/* Bounds of the error of a curve that joins series of n terms at both ends of a
 * stretch.  Let x be (strides/reach)^(2 n).  A curve of the force errs by less
 * than x times the sum of the first and second derivatives of the force by
 * strides, at both ends.  The curve of cos theta errs by less than x times the
 * sum of its values at the ends.  These are the reaches for all, for some and
 * for few terms.  On 840,000 random stretches of any body the errors came to at
 * most half of these bounds, which test_force tests. */
#define COIN_PRIV_REACH 2.75
#define COIN_PRIV_SOME_REACH 2.45
#define COIN_PRIV_FEW_REACH 1.7

/* Whether it is certain that no bit holds on a stretch with this force at its
 * ends.  h is its length in the unit of the series.  0 if it is not certain. */
int coin_priv_is_clear(const coin_priv_search *f,
                       const coin_priv_force_series *at, double h,
                       double stride);

/* coin_priv_is_clear() of a whole stretch.  Computes the force at its ends into
 * w->force, which on entry is the force on the stretch before.  By that it
 * chooses how many terms are likely to be enough, and takes more if they are
 * not.  `one` is the tau of a stride. */
int coin_priv_judge_stretch(const coin_priv_search *f, coin_priv_stretch *w,
                            double one);

/* The force along a curve in Bernstein's form, scaled so that the coin slips
 * where X^2 + h^2 > bound^2. */
typedef struct coin_priv_curve {
    double X[COIN_PRIV_JOINED + 1];
    double h[COIN_PRIV_JOINED + 1];
    double bound[COIN_PRIV_JOINED + 1];
} coin_priv_curve;

/* A part of a stretch, and its polynomials.  Only those that the bits looked
 * for need are set. */
typedef struct coin_priv_part {
    const coin_priv_stretch *of;
    double first, width; /* the whole stretch is 0, 1 */
    coin_priv_curve force;
    double normal[COIN_PRIV_JOINED + 1], cth[COIN_PRIV_JOINED + 1];
} coin_priv_part;

/* Sets the polynomials by the forces at the ends of the part, of all terms. */
void coin_priv_join_part(coin_priv_part *w, const coin_priv_search *f,
                         const coin_priv_force_series *at);

/* Where in a part, 0 to 1, a bit holds; from > 1 if nowhere. */
typedef struct coin_priv_place {
    double from, to;
} coin_priv_place;

/* The next place beyond `from` where a bit holds. */
coin_priv_place coin_priv_next_place(const coin_priv_search *f,
                                     const coin_priv_part *w, double from);

#endif
