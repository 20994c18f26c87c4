/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "law.h"

/* Only at a smaller cos theta may the contact have stopped. */
#define NEAR_FLAT 0.05

/* A contact counts as stopped if it rolls at less than this part of the rates
 * of the fall.  Its roll is then left out, which would have turned the coin by
 * at most twice this part, in radians: by 4 tol.  MOST limits what is left out
 * at tol above 5e-8.  By a roll of OF_FLAT times `flat` a coin passes at half
 * of `flat` at most, NEAR_FLAT times that part: it lies flat in any case. */
#define PART 2
#define MOST 1e-7
#define OF_FLAT 10

/* (73), but for its third part, which would let a small roll decay.  Friction
 * turns the contact of a coin that slips: it is held only against that too. */
int coin_priv_is_held(const double *y, const coin_priv_law *l, int mode,
                      double tol)
{
    const int slips = mode & COIN_PRIV_SLIPS;
    const double IX = l->IX, IZ = l->IZ, J = l->J[slips], K = l->K[slips];
    const double s = y[COIN_PRIV_S], c = y[COIN_PRIV_C], wX = y[COIN_PRIV_WX];
    const double least = coin_priv_lesser(PART * tol, OF_FLAT * l->flat);
    const double part = coin_priv_lesser(least, MOST);
    const double small2 = part * part * (wX * wX + c / (IX + 1));
    const double u = coin_priv_roll_speed(y);
    if (!(l->lossy && c < NEAR_FLAT && u * u <= small2))
        return 0;
    const double D = IX * (c * c) + K * (s * s), turn = -y[COIN_PRIV_WZ] / s;
    const double lift = (K - IX) * c * (turn * turn);
    const double fall = 2 * (1 + (lift > 0 ? lift : 0)) * c / J;
    const double fastest = sqrt(wX * wX + fall);
    const double lever = K / D * (2 * IX - IZ) + c * c * (IZ / D) * (K - IX);
    const double pivot = l->spin * fabs(K - IX) + l->angular * IX * (K - IZ);
    const double small = sqrt(small2);
    const double need = fabs(turn * lever) * c * fastest +
                        fabs(turn) * pivot / D * (c * c); /* (73) */
    const double hold = small * coin_priv_grip(l, small, c);
    const double pushed = slips ? l->mu_kinetic * IX / IZ * (c * c) : 0;
    return need <= hold && pushed <= hold;
}
