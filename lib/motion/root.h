/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_ROOT_H
#define ROLLCOIN_ROOT_H

/* A function of x, and its value at one. */
typedef double coin_priv_function(const void *of, double x);
typedef struct coin_priv_place {
    double x, at;
} coin_priv_place;

/* An x within `width` after the root of a function, which is not negative at a
 * and negative at b > a. */
double coin_priv_root(coin_priv_function *f, const void *of, coin_priv_place a,
                      coin_priv_place b, double width);

#endif
