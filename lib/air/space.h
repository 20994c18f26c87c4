/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_SPACE_H
#define ROLLCOIN_SPACE_H

static inline double coin_priv_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* c = a x b. */
static inline void coin_priv_cross(double c[3], const double a[3],
                                   const double b[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

#endif
