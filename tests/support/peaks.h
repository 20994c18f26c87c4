/* SPDX-License-Identifier: MIT */
/* Motions with an orbit, and where they need most friction. */
#ifndef ROLLCOIN_TESTS_PEAKS_H
#define ROLLCOIN_TESTS_PEAKS_H

#include "random.h"

#include <coin.h>

struct motion {
    coin_params p;
    coin_state s;
    coin_orbit o;
    double unit, side; /* side: of time, 1 or -1 */
};

/* One that has an orbit and that is not so unstable that steps lose it, and
 * that begins with N > 0. */
struct motion motion_any(struct random *r);

/* One whose largest F/N within a time, at *at, is that of a maximum within, and
 * not above 10. */
struct motion motion_with_peak(struct random *r, double *t, double *most,
                               double *at);

/* The state after a time; F/N then, infinite where N <= 0. */
coin_state motion_after(const struct motion *m, double t);
double motion_ratio(const struct motion *m, double t);

/* The largest F/N within a time, by samples and their neighbourhoods. */
double motion_largest(const struct motion *m, double t, double *at);

#endif
