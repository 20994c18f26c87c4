/* SPDX-License-Identifier: MIT */
/* One step of DOP853 (Hairer, Norsett, Wanner): order 8, an estimate of its
 * error, and a polynomial of order 7 for the motion within it. */
#ifndef ROLLCOIN_DOP853_H
#define ROLLCOIN_DOP853_H

#include "law.h"

enum { COIN_PRIV_STAGES = 16, COIN_PRIV_DENSE = 7 };

/* What computes the slopes of a step: coin_priv_rates(), coin_priv_rates_by_t()
 * or a function of flat_slide.c. */
typedef void coin_priv_rates_function(double *d, const double *y,
                                      const coin_priv_law *l, int mode);

/* What is integrated: the slopes of a coin in a mode, by the time of the mode
 * or by t. */
typedef struct coin_priv_problem {
    const coin_priv_law *law;
    coin_priv_rates_function *rates;
    int mode;
    double most; /* a stage whose rates add up to more has run away */
} coin_priv_problem;

/* A step from y to end.  slope[0] are the slopes at y, slope[12] those at end
 * for dense[]. */
typedef struct coin_priv_dop853 {
    coin_priv_problem of;
    double h;
    double y[COIN_PRIV_WIDE], end[COIN_PRIV_WIDE];
    double slope[COIN_PRIV_STAGES][COIN_PRIV_WIDE];
    double dense[COIN_PRIV_DENSE][COIN_PRIV_WIDE];
    int sound;     /* whether every stage has slopes */
    int has_dense; /* whether dense[] is set */
} coin_priv_dop853;

/* Makes slopes those by t, and returns the factor. */
double coin_priv_by_t(double *d);

/* coin_priv_rates(), all by t. */
void coin_priv_rates_by_t(double *d, const double *y, const coin_priv_law *l,
                          int mode);

/* Sets w->end, where w->of, w->y and w->slope[0] are set.  Returns the estimate
 * of the error of the variables that are read; infinite if a stage runs away or
 * lies below the table. */
double coin_priv_try_step(coin_priv_dop853 *w, double h);

/* Sets `to` to the variables at the part x of the step, from 0 to 1.
 */
void coin_priv_within(double *to, coin_priv_dop853 *w, double x);

#endif
