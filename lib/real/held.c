/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "law.h"

/* A contact counts as stopped if it rolls at less than PART tol times the rate
 * of the fall.  Its roll is then left out, which would have turned the coin by
 * at most twice this part, in radians: by 4 tol.  Half of PART costs 6 % more,
 * twice of it 5 % less; the 99th percentile of the errors is then 0.4 tol
 * instead of 0.26 (make tuning).
 *
 * MOST limits this part at tol above 5e-8.  With 1e-5 calls near flat
 * take a quarter of the steps, and none of 100 ends by COIN_ESTEP instead of 8;
 * the 99th percentile of their errors at 1e-4 is 0.51 tol instead of 0.37.  But
 * coins that slip err by up to 180 tol.
 *
 * A coin with so small a roll would pass flat at a least cos theta of
 * about its own cos theta times this part.  It must lie flat by then: the part
 * is at most OF_FLAT times flat/cos theta.  From 0.1 to 5 no motion of make
 * tuning depends on it. */
#define PART 2
#define MOST 1e-7
#define OF_FLAT 0.5

/* The roll speed below which the contact counts as stopped. */
static double least_roll(const double *y, const coin_priv_law *l, double tol)
{
    const double wX = y[COIN_PRIV_WX];
    const double c = coin_priv_larger(y[COIN_PRIV_C], l->flat);
    const double least = coin_priv_lesser(PART * tol, OF_FLAT * l->flat / c);
    return coin_priv_lesser(least, MOST) * sqrt(wX * wX + c / (l->IX + 1));
}

/* (73), but for its third part, which would let a small roll decay.  Of a
 * coin that slips, the losses must hold the contact against the friction of the
 * slip too. */
double coin_priv_hold_margin(const double *y, const coin_priv_law *l, int mode,
                             double tol)
{
    const int slips = mode & COIN_PRIV_SLIPS;
    const double IX = l->IX, IZ = l->IZ, J = l->J[slips], K = l->K[slips];
    const double s = y[COIN_PRIV_S], wX = y[COIN_PRIV_WX];
    const double c = coin_priv_larger(y[COIN_PRIV_C], l->flat);
    const double D = IX * (c * c) + K * (s * s);
    const double turn = c * y[COIN_PRIV_WY] - s * y[COIN_PRIV_WZ];
    const double lift = (K - IX) * c * (turn * turn);
    const double fall = 2 * (1 + (lift > 0 ? lift : 0)) * c / J;
    const double fastest = sqrt(wX * wX + fall);
    const double lever = K / D * (2 * IX - IZ) + c * c * (IZ / D) * (K - IX);
    const double pivot = l->spin * fabs(K - IX) + l->angular * IX * (K - IZ);
    const double small = least_roll(y, l, tol);
    const double need = fabs(turn * lever) * c * fastest +
                        fabs(turn) * pivot / D * (c * c); /* (73) */
    const double friction = small * coin_priv_grip(l, small, c);
    const double pushed = slips ? l->mu_kinetic * IX / IZ * (c * c) : 0;
    return friction - coin_priv_larger(need, pushed);
}

int coin_priv_is_held(const double *y, const coin_priv_law *l, int mode,
                      double tol)
{
    return l->lossy && fabs(coin_priv_roll_speed(y)) <= least_roll(y, l, tol) &&
           coin_priv_hold_margin(y, l, mode, tol) >= 0;
}
