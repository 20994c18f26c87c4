/* SPDX-License-Identifier: MIT */
/* Polynomials on [0, 1] in Bernstein's form: sums of b_k C(n, k) x^k (1 -
 * x)^(n - k).  A polynomial lies between the least and the largest of its
 * numbers b, and has at most as many zeros as these change sign (Descartes). */
#ifndef ROLLCOIN_BERNSTEIN_H
#define ROLLCOIN_BERNSTEIN_H

#include "force.h"

/* COIN_PRIV_DEGREE: the degree of the polynomial that joins two series of so
 * many terms.  COIN_PRIV_JOINED: that for series of all terms.
 * COIN_PRIV_SQUARED: the degree of the square of that polynomial. */
#define COIN_PRIV_DEGREE(terms) (2 * (terms)-1)
#define COIN_PRIV_JOINED COIN_PRIV_DEGREE(COIN_PRIV_FORCE_TERMS)
#define COIN_PRIV_SQUARED (2 * COIN_PRIV_JOINED)

/* `scale` times the polynomial of x that has so many terms of these series, one
 * about x = 0 and one about x = 1 (Hermite).  The series are in powers of h x
 * and of h (x - 1). */
void coin_priv_join(double *b, const coin_priv_ends *ends, double h,
                    double scale, int terms);

/* Cuts at 1/2 (de Casteljau): `first` becomes the first half, and b the second.
 * coin_priv_halve_joined() is faster, for a polynomial that joins two series.
 */
void coin_priv_halve(double *first, double *b, int degree);
void coin_priv_halve_joined(double *first, double *b, int terms);

/* x^2 + y^2 - z^2, of degree COIN_PRIV_SQUARED, of three of degree
 * COIN_PRIV_JOINED. */
void coin_priv_cone_polynomial(double *b, const double *x, const double *y,
                               const double *z);

double coin_priv_bernstein_value(const double *b, int degree, double x);

/* The first place beyond `from` where the polynomial becomes positive; 2 if
 * there is none.  It may miss a place where the polynomial is positive between
 * two zeros that are nearer to each other than 2^-13. */
double coin_priv_first_positive(const double *b, int degree, double from);

#endif
