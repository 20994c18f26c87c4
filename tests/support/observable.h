/* SPDX-License-Identifier: MIT */
/* Functions of a state against the reference files, within the bound that
 * their docstrings claim. */
#ifndef ROLLCOIN_TESTS_OBSERVABLE_H
#define ROLLCOIN_TESTS_OBSERVABLE_H

#include <coin.h>

enum { OBSERVABLE_MAX = 9 };

typedef void values_of(const coin_state *s, const coin_params *p,
                       double out[OBSERVABLE_MAX]);

struct observable {
    values_of *values;
    values_of *terms; /* sum of the absolute values of the formula's terms */
    double units;     /* bound of the error, in u of the terms */
    const char *columns[OBSERVABLE_MAX + 1]; /* in the files; ends with null */
};

/* At the states of observables.csv, which are exact. */
void observable_at_exact_states(const struct observable *o);

/* At every row of the named scenes, for those columns that they have.  A row
 * is the reference rounded to double: what that rounding, and the rounding of
 * the moments of inertia, can move a value by is added to the bound. */
void observable_along_scenes(const struct observable *o);

/* Lean and heading by libm, and the body, for formulas of terms. */
struct parts {
    double sth, cth, tth, sph, cph; /* absolute values */
    double wX, wY, wZ;              /* absolute values */
    double M, a, g, IX, IZ, m, J, K;
    double dwX; /* terms of d(wX)/dt */
};
struct parts parts_of(const coin_state *s, const coin_params *p);

#endif
