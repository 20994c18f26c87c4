/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_PARAMS_H
#define ROLLCOIN_PARAMS_H

#include <coin.h>

/* What the formulas read of a body, in the letters of docs/physics.md:
 * m = M a^2, J = I_X + m, K = I_Z + m. */
typedef struct coin_priv_body {
    double M, a, IX, IZ;
    double m, J, K;
    double Mg, Mga;
    double g_a;    /* g/a: 1 over the natural unit of time squared */
    double KJ, XJ; /* K/J, I_X/J */
    double GJ;     /* M g a/J */
    double k1, k2; /* I_Z/I_X, m/K */
    double w2_max; /* largest omega^2 with which nothing overflows */
} coin_priv_body;

/* COIN_OK and *b, or COIN_EPARAMS.  p is not null. */
int32_t coin_priv_body_of(coin_priv_body *b, const coin_params *p);

#endif
