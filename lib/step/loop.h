/* SPDX-License-Identifier: MIT */
/* The loop around a step of fixed dt, and its guard. */
#ifndef ROLLCOIN_LOOP_H
#define ROLLCOIN_LOOP_H

#include "../motion/methods.h"
#include "../motion/state.h"

#include "progress.t.h"

/* Steps of a block; blocks are counted from the start of a run, so that its
 * bits do not depend on where it is looked at. */
#define COIN_PRIV_BLOCK 64

/* A run by steps of dt. */
typedef struct coin_priv_run {
    coin_state start;
    coin_priv_body b;
    coin_priv_limits limits;
    double dt;
    coin_priv_progress g;
    uint64_t steps; /* done so far */
} coin_priv_run;

/* A run from *s by steps of dt; r->b is the body. */
void coin_priv_run_from(coin_priv_run *r, const coin_state *s, int32_t method,
                        double dt);

/* A run from *s by steps whose lengths are chosen one by one: r->dt is 0, and W
 * has no limit. */
void coin_priv_run_unlimited(coin_priv_run *r, const coin_state *s);

/* One step from *y by a method's coefficients: where it leads, and the
 * variables there.  end->least_cth is 0 if the step cannot be made. */
typedef void coin_priv_step(coin_priv_step_end *end, coin_priv_variables *next,
                            const coin_priv_variables *y,
                            const void *coefficients);

/* Whether phi and psi, as they will be reported, are in the range of
 * coin_state_check().  NaN is not. */
COIN_PRIV_INLINE int coin_priv_angles_hold(const coin_priv_progress *g,
                                           const coin_priv_pose *added)
{
    return fabs(coin_priv_total(g->phi, added->phi)) <= COIN_PRIV_ANGLE_MAX &&
           fabs(coin_priv_total(g->psi, added->psi)) <= COIN_PRIV_ANGLE_MAX;
}

/* Twice what the 64 steps of a block can turn phi or psi by.  A step turns phi
 * by at most TURN_MAX, and psi by at most sqrt(2) |dt| W: both by less than 2
 * rad. */
#define COIN_PRIV_BLOCK_TURN 256.0

/* Whether phi and psi stay in that range until a block of steps is done, of
 * which some may be done already. */
COIN_PRIV_INLINE int coin_priv_block_holds(const coin_priv_progress *g)
{
    const double most = COIN_PRIV_ANGLE_MAX - COIN_PRIV_BLOCK_TURN;
    return fabs(g->phi.sum) <= most && fabs(g->psi.sum) <= most;
}

/* The cos theta above which W^2, Eq. (47), is below coarse2 whatever the rates,
 * so that most steps need no closer look: the energy bounds wX^2 + wY^2 by
 * 2 E/I_X and wZ^2 by 2 E/K, so that with q = 1/cos theta
 *     W^2 <= 2 E/I_X q^2 + g/a q + 2 E/K.
 * A quarter is added to E for its error until the end of the block: even at the
 * limit the error of a step is below 1e-3 of E.  Returns 2 if there is no such
 * cos theta. */
COIN_PRIV_PER_BLOCK double coin_priv_safe_cosine(const coin_priv_body *b,
                                                 double coarse2,
                                                 const coin_priv_variables *y)
{
    const double wX = y->wX, wY = y->wY, wZ = y->wZ;
    const double T2 = b->J * wX * wX + b->IX * wY * wY + b->K * wZ * wZ;
    const double E2 = 1.25 * (T2 + 2 * b->Mga * y->cth); /* (23) */
    /* A lane that is no longer used may hold a coin below the table, E < 0.
     * Within 1e-6 of the limit the quotients by `spare` might overflow. */
    if (!((E2 > 0) & (E2 < 0.999999 * (b->K * coarse2))))
        return 2;
    const double spare = coarse2 - E2 / b->K;
    const double fall = b->g_a / (2 * spare);
    return fall + sqrt(fall * fall + E2 / spare / b->IX);
}

/* The state that a run from *start has come to. */
COIN_PRIV_INLINE coin_state coin_priv_state_of(const coin_priv_progress *g,
                                               const coin_state *start,
                                               double a)
{
    const coin_priv_pose to = coin_priv_pose_of(g, a);
    const coin_state s = {
        coin_priv_lean_within(to.theta),
        to.phi,
        to.psi,
        start->x + to.x,
        start->z + to.z,
        g->y.wX,
        g->y.wY,
        g->y.wZ,
    };
    return s;
}

/* Up to n steps of a run, n > 0.  It ends early where a step would not be
 * sound, and is then as the last sound step left it.  The inner loop calls no
 * function: each step would have to spill its registers. */
COIN_PRIV_INLINE void coin_priv_steps(coin_priv_run *r, uint64_t n,
                                      coin_priv_step *step,
                                      const void *coefficients)
{
    coin_priv_progress *const g = &r->g;
    coin_priv_variables y = g->y, next;
    coin_priv_pose added = g->added, sum;
    coin_priv_step_end end;
    const double g_a = r->b.g_a;
    if (!coin_priv_admit_rate2(&r->limits, coin_priv_rate2(g_a, &y)))
        return;
    int sound;
    do {
        const uint64_t left = COIN_PRIV_BLOCK - r->steps % COIN_PRIV_BLOCK;
        const uint64_t block = n < left ? n : left;
        /* For one step, W itself is cheaper. */
        const double safe =
            n > 1 ? coin_priv_safe_cosine(&r->b, r->limits.coarse2, &y) : 2;
        const int at_edge = !coin_priv_block_holds(g);
        uint64_t done = 0;
        for (; done < block; ++done) {
            step(&end, &next, &y, coefficients);
            const double least = coin_priv_lesser(end.least_cth, next.cth);
            if (COIN_PRIV_RARELY(!(least > safe)) &&
                !coin_priv_admit_step(&r->limits, g_a, &end, &next))
                break;
            sum = coin_priv_pose_plus(&added, 1, &end.adds);
            if (at_edge && !coin_priv_angles_hold(g, &sum))
                break;
            added = sum;
            y = next;
        }
        sound = done == block;
        r->steps += done;
        n -= done;
        g->y = y;
        g->added = added;
        if (done == left) {
            coin_priv_end_block(g);
            y = g->y;
            added = g->added;
        }
    } while (sound && n > 0);
}

/* Up to n steps by each method. */
typedef void coin_priv_method(coin_priv_run *r, uint64_t n);
coin_priv_method coin_priv_rk4, coin_priv_rk8;
coin_priv_method coin_priv_symplectic2, coin_priv_symplectic4;

#endif
