/* SPDX-License-Identifier: MIT */
/* How far a run has come, and the loop around its steps. */
#include "../motion/methods.h"

#include "../motion/kind.h"

/* A run under way: its variables, its pose at the beginning of a block of
 * steps, and what the steps of the block have added to it.  A steady motion
 * adds the same in every step, and one long plain sum would round it the same
 * way each time.  x and z are from the start of the run, in radii.
 *
 * added.theta is the lean itself, one plain sum as wX, wY and wZ are.  Next to
 * a steady motion these four change by less than their rounding.  If only one
 * of them kept what rounding leaves out, it would drift.
 *
 * All members are of type number: lanes.c reads them as an array. */
typedef struct coin_priv_progress {
    coin_priv_variables y;
    coin_priv_pose added;
    coin_priv_sum phi, psi, x, z;
} coin_priv_progress;

/* Starts a run where the variables are *y.  Number by number: the wider moves
 * that an assignment of a struct is made of would wait for each other. */
COIN_PRIV_INLINE void coin_priv_progress_begin(coin_priv_progress *g,
                                               const coin_priv_variables *y,
                                               number theta, number phi,
                                               number psi)
{
    const number none = {0};
    g->y.wX = y->wX;
    g->y.wY = y->wY;
    g->y.wZ = y->wZ;
    g->y.sth = y->sth;
    g->y.cth = y->cth;
    g->y.q = y->q;
    g->y.tth = y->tth;
    g->y.sph = y->sph;
    g->y.cph = y->cph;
    g->added.theta = theta;
    g->added.phi = g->added.psi = none;
    g->added.x = g->added.z = g->added.t = none;
    g->phi.sum = phi;
    g->psi.sum = psi;
    g->x.sum = g->z.sum = none;
    g->phi.low = g->psi.low = g->x.low = g->z.low = none;
}

/* Sine and cosine of an angle that a sum holds. */
COIN_PRIV_INLINE_UNLESS_SMALL coin_priv_sc
coin_priv_angle_pair(coin_priv_sum angle)
{
    const coin_priv_sc pair = coin_priv_sine_cosine(angle.sum);
    const coin_priv_sc r = {
        pair.s + pair.c * angle.low,
        pair.c - pair.s * angle.low,
    };
    return r;
}

/* Adds to the sums what the steps of a block have added. */
COIN_PRIV_INLINE void coin_priv_add_block(coin_priv_progress *g)
{
    coin_priv_pose *const added = &g->added;
    const number none = {0};
    coin_priv_add(&g->phi, added->phi);
    coin_priv_add(&g->psi, added->psi);
    coin_priv_add(&g->x, added->x);
    coin_priv_add(&g->z, added->z);
    added->phi = added->psi = added->x = added->z = none;
}

/* Ends a block, and takes the pairs anew from the angles. */
COIN_PRIV_INLINE void coin_priv_end_block(coin_priv_progress *g)
{
    coin_priv_add_block(g);
    coin_priv_variables *const y = &g->y;
    const coin_priv_sc at = coin_priv_sine_cosine(g->added.theta);
    /* The rounding of theta is a part 1e-16/cos theta of cos theta: too much
     * near the table.  There the sine and cosine that the steps have turned are
     * kept, which part from theta by their own rounding.  The limit is 2^-7
     * (measured: coin_priv_end_block() in tests/studies/tables.md). */
    const integer near = coin_priv_truth(y->cth < K(0.0078125));
    const coin_priv_sc th = {
        coin_priv_choose(near, y->sth, at.s),
        coin_priv_choose(near, y->cth, at.c),
    };
    const coin_priv_sc ph = coin_priv_angle_pair(g->phi);
    y->sth = th.s;
    y->cth = th.c;
    y->q = 1 / th.c;
    y->tth = th.s * y->q;
    y->sph = ph.s;
    y->cph = ph.c;
}

/* The pose of a run: its angles, and x, z [L] from where it started. */
COIN_PRIV_INLINE coin_priv_pose coin_priv_pose_of(const coin_priv_progress *g,
                                                  number a)
{
    const coin_priv_pose *const added = &g->added;
    const coin_priv_pose r = {
        added->theta,
        coin_priv_total(g->phi, added->phi),
        coin_priv_total(g->psi, added->psi),
        a * coin_priv_total(g->x, added->x),
        a * coin_priv_total(g->z, added->z),
        added->t,
    };
    return r;
}

/* One step from *y by a method's coefficients: where it leads, and the
 * variables there. */
typedef void coin_priv_step(coin_priv_step_end *end, coin_priv_variables *next,
                            const coin_priv_variables *y,
                            const void *coefficients);

/* Whether phi, psi, x and z, as they will be reported, are in the range of
 * coin_state_check().  NaN is not. */
COIN_PRIV_INLINE integer coin_priv_pose_in_range(const coin_priv_progress *g,
                                                 const coin_priv_limits *limits,
                                                 const coin_priv_pose *added)
{
    const number a = limits->a, far = COIN_PRIV_PLACE_MAX * a;
    const number phi = coin_priv_total(g->phi, added->phi);
    const number psi = coin_priv_total(g->psi, added->psi);
    const number x = limits->x + a * coin_priv_total(g->x, added->x);
    const number z = limits->z + a * coin_priv_total(g->z, added->z);
    return coin_priv_truth(coin_priv_magnitude(phi) <= COIN_PRIV_ANGLE_MAX) &
           coin_priv_truth(coin_priv_magnitude(psi) <= COIN_PRIV_ANGLE_MAX) &
           coin_priv_truth(coin_priv_magnitude(x) <= far) &
           coin_priv_truth(coin_priv_magnitude(z) <= far);
}

/* Whether they stay in that range until a block of steps is done, of which some
 * may be done already. */
COIN_PRIV_INLINE integer coin_priv_block_in_range(
    const coin_priv_progress *g, const coin_priv_limits *limits)
{
    const scalar turn = COIN_PRIV_ANGLE_MAX - COIN_PRIV_BLOCK_MOVES;
    const scalar place = COIN_PRIV_PLACE_MAX - COIN_PRIV_BLOCK_MOVES;
    const number a = limits->a, far = place * a;
    const number x = limits->x + a * g->x.sum, z = limits->z + a * g->z.sum;
    return coin_priv_truth(coin_priv_magnitude(g->phi.sum) <= turn) &
           coin_priv_truth(coin_priv_magnitude(g->psi.sum) <= turn) &
           coin_priv_truth(coin_priv_magnitude(x) <= far) &
           coin_priv_truth(coin_priv_magnitude(z) <= far);
}

/* Up to n more steps of a run that has done *steps, to the end of a block at
 * most.  Ends before a step that is refused, and is then as the last step left
 * it.  Returns for which coins no step was refused.  The loop calls no
 * function: each step would have to spill its registers. */
COIN_PRIV_INLINE integer coin_priv_block(coin_priv_progress *g,
                                         coin_priv_limits *limits,
                                         uint64_t *steps, uint64_t n,
                                         coin_priv_step *step,
                                         const void *coefficients)
{
    const uint64_t left = COIN_PRIV_BLOCK - *steps % COIN_PRIV_BLOCK;
    const int at_edge =
        !coin_priv_every(coin_priv_block_in_range(g, limits) != 0);
    const uint64_t most = at_edge ? 1 : n < left ? n : left;
    const integer none = {0};
    coin_priv_variables y = g->y, next;
    coin_priv_pose added = g->added;
    coin_priv_step_end end;
    uint64_t done = 0;
    for (; done < most; ++done) {
        step(&end, &next, &y, coefficients);
        const int made = coin_priv_admit_each(limits, &end, &next);
        const coin_priv_pose sum = coin_priv_pose_plus(&added, 1, &end.adds);
        if (COIN_PRIV_RARELY(!made))
            break;
        added = sum;
        y = next;
    }
    const integer in_range =
        at_edge ? coin_priv_pose_in_range(g, limits, &added) : ~none;
    if (!coin_priv_every(in_range != 0))
        return in_range;
    g->y = y;
    g->added = added;
    *steps += done;
    if (done == left)
        coin_priv_end_block(g);
    return done < most ? coin_priv_admit_step(limits, &end, &next) : ~none;
}
