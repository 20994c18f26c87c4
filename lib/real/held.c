/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "law.h"

/* A contact counts as stopped if it rolls at less than PART tol times the rate
 * of the fall.  Its roll is then left out, which would have turned the coin by
 * at most twice this part, in radians: by 4 tol.
 *
 * MOST limits this part at tol above 5e-8: coins that slip would err.
 *
 * The friction of a slip turns the contact of a thick coin, the more slowly the
 * nearer it is to flat.  To follow that at a small tol would take millions of
 * steps.  So its part is tol/cos theta: leaving out the roll changes the energy
 * by a few tol, and the heading by less than 2 MOST.
 *
 * A coin with so small a roll would pass flat at a least cos theta of
 * about its own cos theta times this part.  It must lie flat by then: the part
 * is at most OF_FLAT times flat/cos theta.  Measured: PART, MOST, OF_FLAT in
 * tables.md. */
#define PART 2
#define MOST 1e-7
#define OF_FLAT 0.5

/* The roll speed below which the contact counts as stopped. */
static double least_roll(const double *y, const coin_priv_law *l, int slips,
                         double tol)
{
    const double wX = y[COIN_PRIV_WX];
    const double c = coin_priv_larger(y[COIN_PRIV_C], l->flat);
    const double part = slips && l->half > 0 ? tol / c : PART * tol;
    const double least = coin_priv_lesser(part, OF_FLAT * l->flat / c);
    return coin_priv_lesser(least, MOST) * sqrt(wX * wX + c / l->J[0]);
}

/* The part of the slip that goes along the rim: only its friction rolls the
 * contact by the lever of the thickness. */
static double along_rim(const double *y)
{
    const double uX = y[COIN_PRIV_UX], uh = y[COIN_PRIV_UH];
    const double u = sqrt(uX * uX + uh * uh);
    return fabs(uX) / (u + DBL_MIN);
}

/* (73), but for its third part, which would let a small roll decay.  Of a
 * coin that slips, the losses must hold the contact against the friction of the
 * slip too; of one that does not, against the pull, wherever it points to when
 * the coin has turned. */
double coin_priv_hold_margin(const double *y, const coin_priv_law *l, int mode,
                             double tol)
{
    const int slips = mode & COIN_PRIV_SLIPS;
    const double IX = l->IX, IZ = l->IZ, J = l->J[slips], K = l->K[slips];
    const double s = y[COIN_PRIV_S], wX = y[COIN_PRIV_WX];
    const double c = coin_priv_larger(y[COIN_PRIV_C], l->flat);
    const double h = slips ? 0 : l->half, hs = h * fabs(s);
    const double pull = slips ? 0 : coin_priv_pull(l);
    const double D = IX * (c * c) + K * (s * s) + h * c * (h * c - 2 * fabs(s));
    const double turn = c * y[COIN_PRIV_WY] - s * y[COIN_PRIV_WZ];
    const double more = h * (s * s - c * c - hs * c);
    const double lift =
        (K - IX) * c * (turn * turn) + more * (turn * turn) + (c + hs) * pull;
    const double fall = 2 * (1 + (lift > 0 ? lift : 0)) * c / J;
    const double fastest = sqrt(wX * wX + fall);
    const double lever = K / D * (2 * IX - IZ) + c * c * (IZ / D) * (K - IX) +
                         IZ / D * (h * h + hs * (hs + 2 * c));
    const double pivot = l->spin * fabs(K - IX) + l->angular * IX * (K - IZ);
    const double thick = l->spin * fabs(more) + l->angular * IZ * h;
    const double small = least_roll(y, l, slips, tol);
    const double need =
        fabs(turn * lever) * c * fastest + fabs(turn) * pivot / D * (c * c) +
        (fabs(turn) * thick + pull * (IX * c + IZ * hs)) / D * c; /* (73) */
    const double friction = small * coin_priv_grip(l, small, c);
    const double arm = slips ? l->half * along_rim(y) * c : 0;
    const double pushed =
        slips ? l->mu_kinetic * IX / IZ * (c * c) + l->mu_kinetic * arm : 0;
    return friction - coin_priv_larger(need, pushed);
}

int coin_priv_is_held(const double *y, const coin_priv_law *l, int mode,
                      double tol)
{
    const int slips = mode & COIN_PRIV_SLIPS;
    const double roll = fabs(coin_priv_roll_speed(y));
    return l->lossy && roll <= least_roll(y, l, slips, tol) &&
           coin_priv_hold_margin(y, l, mode, tol) >= 0;
}
