/* SPDX-License-Identifier: MIT */
/* The loop around a Runge-Kutta step, and its guard. */
#ifndef ROLLCOIN_MARCH_H
#define ROLLCOIN_MARCH_H

#include "number.h"
#include "stepper.h"

/* Whether phi and psi are in the range of coin_state_check(), and so far within
 * it as room; psi is the run's sum so far.  NaN is not. */
COIN_PRIV_INLINE int coin_priv_angles_hold(const coin_priv_moment *at,
                                           double psi, double room)
{
    return fabs(at->pose.phi) <= COIN_PRIV_ANGLE_MAX - room &&
           fabs(psi + at->pose.psi) <= COIN_PRIV_ANGLE_MAX - room;
}

/* Several times what a block of steps can turn phi or psi by, 2 rad each. */
#define COIN_PRIV_ROOM 256.0

/* Whether W is within the limit where a step begins or ends; notes if it is
 * beyond that of full accuracy.  NaN is not. */
COIN_PRIV_INLINE int coin_priv_within(coin_priv_limits *limits, double g_a,
                                      const coin_priv_stage *y)
{
    const double rate2 = coin_priv_rate2(g_a, y);
    if (rate2 <= limits->coarse2)
        return 1;
    limits->warnings = COIN_COARSE;
    return rate2 <= limits->most2;
}

/* The cos theta above which W^2 is below coarse2 whatever the rates, so that
 * most steps need no closer look: the energy bounds wX^2 + wY^2 by 2 E/I_X and
 * wZ^2 by 2 E/K.  A quarter is added to it for what the energy may err until
 * the next settling; at the limit a step errs by less than 1e-3 of it. */
COIN_PRIV_INLINE double coin_priv_high(const coin_priv_body *b, double coarse2,
                                       const coin_priv_stage *y)
{
    const double wX = y->wX, wY = y->wY, wZ = y->wZ;
    const double T2 = b->J * wX * wX + b->IX * wY * wY + b->K * wZ * wZ;
    const double E2 = 1.25 * (T2 + 2 * b->Mga * y->cth); /* (23) */
    const double room = coarse2 - E2 / b->K - b->g_a;
    return room > 0 ? sqrt(E2 / b->IX / room) : 2;
}

/* One step from *now to *next; returns the least cos theta of its stages. */
typedef double coin_priv_step(coin_priv_moment *next,
                              const coin_priv_moment *now,
                              const void *coefficients);

/* A step without what it did to heading and pose, and so, since nothing else
 * reads that, without all that computes it. */
COIN_PRIV_INLINE double coin_priv_pathless(coin_priv_step *step,
                                           coin_priv_moment *next,
                                           const coin_priv_moment *now,
                                           const void *coefficients)
{
    const double sph = now->y.sph, cph = now->y.cph;
    const coin_priv_pose pose = now->pose;
    const double lowest = step(next, now, coefficients);
    next->y.sph = sph;
    next->y.cph = cph;
    next->pose = pose;
    return lowest;
}

/* Up to n steps, as coin_priv_stepper says.  The inner loop calls nothing: a
 * call would cost every step its registers. */
COIN_PRIV_INLINE void coin_priv_march(coin_priv_carry *c,
                                      const coin_priv_body *b,
                                      coin_priv_limits *limits, uint64_t n,
                                      coin_priv_step *step,
                                      const void *coefficients)
{
    coin_priv_moment one, other, *now = &one, *next = &other;
    coin_priv_copy(now, &c->at, sizeof one);
    coin_priv_copy(next, &c->at, sizeof one);
    const double g_a = b->g_a;
    int sound = n == 0 || coin_priv_within(limits, g_a, &now->y);
    while (sound && n > 0) {
        const uint64_t room = COIN_PRIV_SETTLE - c->steps % COIN_PRIV_SETTLE;
        const uint64_t block = n < room ? n : room;
        const double high = coin_priv_high(b, limits->coarse2, &now->y);
        const int at_edge =
            !coin_priv_angles_hold(now, c->psi.sum, COIN_PRIV_ROOM);
        uint64_t done = 0;
        for (; done < block; ++done) {
            const double lowest = step(next, now, coefficients);
            const double low = coin_priv_lesser(lowest, next->y.cth);
            if (COIN_PRIV_RARELY(!(low > high)) &&
                !(low > 0 && coin_priv_within(limits, g_a, &next->y)))
                break;
            if (at_edge && !coin_priv_angles_hold(next, c->psi.sum, 0))
                break;
            coin_priv_moment *const swapped = now;
            now = next;
            next = swapped;
        }
        sound = done == block;
        c->steps += done;
        n -= done;
        if (done == room)
            coin_priv_settle(c, now);
    }
    coin_priv_copy(&c->at, now, sizeof one);
}

#endif
