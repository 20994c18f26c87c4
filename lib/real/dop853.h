/* SPDX-License-Identifier: MIT */
/* One step of DOP853 (Hairer, Norsett, Wanner): order 8, an estimate of its
 * error, and a polynomial of order 7 for the motion within it. */
#ifndef ROLLCOIN_DOP853_H
#define ROLLCOIN_DOP853_H

#include "law.h"

enum { COIN_PRIV_STAGES = 16, COIN_PRIV_DENSE = 7 };

/* Sets the slopes *d at the variables y, and returns whether they mean
 * something: 0 ends the step.  A null d only asks that. */
typedef int coin_priv_rates_function(double *d, const double *y,
                                     const coin_priv_problem *of);

/* What is integrated: rates() alone reads the members after itself. */
struct coin_priv_problem {
    coin_priv_rates_function *rates;
    const coin_priv_law *law;
    int mode, by_t; /* of law.h; on the line that of line.c */
    double limit;   /* of a stage: each rates() says what it limits */
};

/* A step from y to end.  slope[0] are the slopes at y, slope[12] those at end
 * for dense[]. */
typedef struct coin_priv_dop853 {
    coin_priv_problem of;
    double h;
    double y[COIN_PRIV_WIDE], end[COIN_PRIV_WIDE];
    double slope[COIN_PRIV_STAGES][COIN_PRIV_WIDE];
    double dense[COIN_PRIV_DENSE][COIN_PRIV_WIDE];
    int sound;     /* whether the slopes of every stage mean something */
    int has_dense; /* whether dense[] is set */
} coin_priv_dop853;

/* Sets w->end, where w->of, w->y and w->slope[0] are set.  Returns the estimate
 * of the error of the variables that are read; infinite if slopes of a stage,
 * or at the end, mean nothing. */
double coin_priv_try_step(coin_priv_dop853 *w, double h);

/* How many times as long as this step the next one may be, whose error is to be
 * below `most`.  An error below 1e-9 of `most` counts as that. Measured: 0.2
 * and 0.7 in tables.md. */
COIN_PRIV_INLINE double coin_priv_next_length(double error, double most)
{
    const double ratio = most / coin_priv_larger(error, 1e-9 * most);
    return 0.2 + 0.7 * sqrt(sqrt(sqrt(ratio)));
}

/* Sets `to` to the variables at the part x of the step, from 0 to 1. */
void coin_priv_within(double *to, coin_priv_dop853 *w, double x);

/* The same of those that the slopes read. */
void coin_priv_read_within(double *to, coin_priv_dop853 *w, double x);

#endif
