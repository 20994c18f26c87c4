/* SPDX-License-Identifier: MIT */
/* What depends on the width of a number: this is for doubles, and
 * lib/float/precision.h for floats. */
#ifndef ROLLCOIN_PRECISION_H
#define ROLLCOIN_PRECISION_H

/* ---------------------------------------------------------------- angles -- */

/* Beyond this an angle's own rounding (2^-22) is a visible turn. */
#define COIN_PRIV_ANGLE_MAX 2147483648.0

/* The double nearest to pi/2, which lies 6.1e-17 below it, and the rest. */
#define COIN_PRIV_HALF_PI 1.5707963267948966
#define COIN_PRIV_HALF_PI_LOW 6.123233995736766e-17

/* pi/2 = P1 + P2 + P3 + P4: three parts of 22 bits, so that n times a part is
 * exact for |n| < 2^31, and a rest. */
#define COIN_PRIV_P1 1.570796012878418
#define COIN_PRIV_P2 3.139164164167596e-07
#define COIN_PRIV_P3 6.223371969669989e-14
#define COIN_PRIV_P4 2.0222662487959506e-21

/* Adding and subtracting 1.5 2^52 rounds to the nearest integer. */
#define COIN_PRIV_ROUNDER 6755399441055744.0

/* (sin(x)/x - 1)/z with z = x^2 and |x| <= pi/4: the Taylor polynomial to
 * x^17, whose next term is 1e-19. */
#define COIN_PRIV_SINE(z)                                                      \
    (-1.0 / 6 +                                                                \
     z * (1.0 / 120 +                                                          \
          z * (-1.0 / 5040 +                                                   \
               z * (1.0 / 362880 +                                             \
                    z * (-1.0 / 39916800 +                                     \
                         z * (1.0 / 6227020800.0 +                             \
                              z * (-1.0 / 1307674368000.0 +                    \
                                   z * (1.0 / 355687428096000.0))))))))

/* (cos(x) - 1 + z/2)/z^2, likewise to x^16. */
#define COIN_PRIV_COSINE(z)                                                    \
    (1.0 / 24 +                                                                \
     z * (-1.0 / 720 +                                                         \
          z * (1.0 / 40320 + z * (-1.0 / 3628800 +                             \
                                  z * (1.0 / 479001600 +                       \
                                       z * (-1.0 / 87178291200.0 +             \
                                            z * (1.0 / 20922789888000.0)))))))

/* ---------------------------------------------------------------- limits -- */

/* Numbers in here can be multiplied by each other's ratios, and by the 1/cos
 * of the flattest lean, and stay normal: 1e-300 and 1e300 leave 2^26. */
#define COIN_PRIV_LEAST 1e-300
#define COIN_PRIV_MOST 1e300

/* That over the largest 1/cos^2 theta: below 1e32 for every |theta| < pi/2
 * that a double holds. */
#define COIN_PRIV_W2_MAX (COIN_PRIV_MOST / 1e32)

/* I_Z may be this part larger than 2 I_X, for the rounding of both. */
#define COIN_PRIV_INERTIA_SLACK 1e-12

/* Whether the remainders that a state keeps are in range: a double's keeps
 * none. */
#define COIN_PRIV_LOW_HOLDS(s) 1

/* What a state's initializer ends with: the remainders of exact members. */
#define COIN_PRIV_NO_LOW

/* ---------------------------------------------------------------- series -- */

/* Terms below this part of their sum no longer change it. */
#define COIN_PRIV_NEGLIGIBLE 1e-17

/* Terms that the drift's series takes: its ratio is at most 0.18. */
#define COIN_PRIV_SERIES_TERMS 22

#endif
