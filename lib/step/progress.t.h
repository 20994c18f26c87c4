/* SPDX-License-Identifier: MIT */
/* How far a run has come, and the loop around its steps. */
#include "../motion/methods.h"

#include "../motion/kind.h"

/* A sum and what its rounding left out. */
typedef struct PRIV(sum) {
    real sum, low;
} PRIV(sum);

/* A run under way: its variables, its pose at the beginning of a block of
 * steps, and what the steps of the block have added to it.  A steady motion
 * adds the same in every step, and one long plain sum would round it the same
 * way each time.  x and z are from the start of the run, in radii.
 *
 * added.theta is the lean itself, one plain sum as wX, wY and wZ are.  Next to
 * a steady motion these four change by less than their rounding.  If only one
 * of them kept what rounding leaves out, it would drift.
 *
 * All members are of type real: lanes.c reads them as an array. */
typedef struct PRIV(progress) {
    PRIV(variables) y;
    PRIV(pose) added;
    PRIV(sum) phi, psi, x, z;
} PRIV(progress);

/* Adds a part, by Knuth's exact sum. */
COIN_PRIV_INLINE_UNLESS_SMALL void PRIV(add)(PRIV(sum) * to, real part)
{
    const real y = part + to->low, sum = to->sum + y;
    const real of_y = sum - to->sum;
    to->low = (to->sum - (sum - of_y)) + (y - of_y);
    to->sum = sum;
}

/* A sum with a part that is not in it yet. */
COIN_PRIV_INLINE real PRIV(total)(PRIV(sum) so_far, real part)
{
    PRIV(add)(&so_far, part);
    return so_far.sum;
}

/* Starts a run where the variables are *y.  Number by number: the wider moves
 * that an assignment of a struct is made of would wait for each other. */
COIN_PRIV_INLINE void PRIV(progress_begin)(PRIV(progress) * g,
                                           const PRIV(variables) * y,
                                           real theta, real phi, real psi)
{
    const real none = {0};
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
COIN_PRIV_INLINE_UNLESS_SMALL PRIV(sc) PRIV(angle_pair)(PRIV(sum) angle)
{
    const PRIV(sc) of = PRIV(sine_cosine)(angle.sum);
    const PRIV(sc) r = {
        of.s + of.c * angle.low,
        of.c - of.s * angle.low,
    };
    return r;
}

/* Adds to the sums what the steps of a block have added. */
COIN_PRIV_INLINE void PRIV(add_block)(PRIV(progress) * g)
{
    PRIV(pose) *const added = &g->added;
    const real none = {0};
    PRIV(add)(&g->phi, added->phi);
    PRIV(add)(&g->psi, added->psi);
    PRIV(add)(&g->x, added->x);
    PRIV(add)(&g->z, added->z);
    added->phi = added->psi = added->x = added->z = none;
}

/* Ends a block, and takes the pairs anew from the angles. */
COIN_PRIV_INLINE void PRIV(end_block)(PRIV(progress) * g)
{
    PRIV(add_block)(g);
    PRIV(variables) *const y = &g->y;
    const PRIV(sc) at = PRIV(sine_cosine)(g->added.theta);
    /* The rounding of theta is a part 1e-16/cos theta of cos theta: too much
     * near the table.  There the sine and cosine that the steps have turned are
     * kept, which part from theta by their own rounding.  Any limit from 2^-8
     * to 2^-5 is as good.  With 0 the rates spoil, and with 2^-3 the sines part
     * too far (test_progress). */
    const whole near = PRIV(truth)(y->cth < K(0.0078125));
    const PRIV(sc) th = {
        PRIV(choose)(near, y->sth, at.s),
        PRIV(choose)(near, y->cth, at.c),
    };
    const PRIV(sc) ph = PRIV(angle_pair)(g->phi);
    y->sth = th.s;
    y->cth = th.c;
    y->q = 1 / th.c;
    y->tth = th.s * y->q;
    y->sph = ph.s;
    y->cph = ph.c;
}

/* The pose of a run: its angles, and x, z [L] from where it started. */
COIN_PRIV_INLINE PRIV(pose) PRIV(pose_of)(const PRIV(progress) * g, real a)
{
    const PRIV(pose) *const added = &g->added;
    const PRIV(pose) r = {
        added->theta,
        PRIV(total)(g->phi, added->phi),
        PRIV(total)(g->psi, added->psi),
        a * PRIV(total)(g->x, added->x),
        a * PRIV(total)(g->z, added->z),
        added->t,
    };
    return r;
}

/* One step from *y by a method's coefficients: where it leads, and the
 * variables there. */
typedef void PRIV(step)(PRIV(step_end) * end, PRIV(variables) * next,
                        const PRIV(variables) * y, const void *coefficients);

/* Whether phi, psi, x and z, as they will be reported, are in the range of
 * coin_state_check().  NaN is not. */
COIN_PRIV_INLINE whole PRIV(pose_holds)(const PRIV(progress) * g,
                                        const PRIV(limits) * limits,
                                        const PRIV(pose) * added)
{
    const real a = limits->a, far = COIN_PRIV_PLACE_MAX * a;
    const real phi = PRIV(total)(g->phi, added->phi);
    const real psi = PRIV(total)(g->psi, added->psi);
    const real x = limits->x + a * PRIV(total)(g->x, added->x);
    const real z = limits->z + a * PRIV(total)(g->z, added->z);
    return PRIV(truth)(PRIV(magnitude)(phi) <= COIN_PRIV_ANGLE_MAX) &
           PRIV(truth)(PRIV(magnitude)(psi) <= COIN_PRIV_ANGLE_MAX) &
           PRIV(truth)(PRIV(magnitude)(x) <= far) &
           PRIV(truth)(PRIV(magnitude)(z) <= far);
}

/* Whether they stay in that range until a block of steps is done, of which some
 * may be done already. */
COIN_PRIV_INLINE whole PRIV(block_holds)(const PRIV(progress) * g,
                                         const PRIV(limits) * limits)
{
    const scalar turn = COIN_PRIV_ANGLE_MAX - COIN_PRIV_BLOCK_MOVES;
    const scalar place = COIN_PRIV_PLACE_MAX - COIN_PRIV_BLOCK_MOVES;
    const real a = limits->a, far = place * a;
    const real x = limits->x + a * g->x.sum, z = limits->z + a * g->z.sum;
    return PRIV(truth)(PRIV(magnitude)(g->phi.sum) <= turn) &
           PRIV(truth)(PRIV(magnitude)(g->psi.sum) <= turn) &
           PRIV(truth)(PRIV(magnitude)(x) <= far) &
           PRIV(truth)(PRIV(magnitude)(z) <= far);
}

/* Up to n more steps of a run that has done *steps, to the end of a block at
 * most.  Ends before a step that is refused, and is then as the last step left
 * it.  Returns for which coins no step was refused.  The loop calls no
 * function: each step would have to spill its registers. */
COIN_PRIV_INLINE whole PRIV(block)(PRIV(progress) * g, PRIV(limits) * limits,
                                   uint64_t *steps, uint64_t n,
                                   PRIV(step) * step, const void *coefficients)
{
    const uint64_t left = COIN_PRIV_BLOCK - *steps % COIN_PRIV_BLOCK;
    const int at_edge = !PRIV(every)(PRIV(block_holds)(g, limits) != 0);
    const uint64_t most = at_edge ? 1 : n < left ? n : left;
    const whole none = {0};
    PRIV(variables) y = g->y, next;
    PRIV(pose) added = g->added;
    PRIV(step_end) end;
    uint64_t done = 0;
    for (; done < most; ++done) {
        step(&end, &next, &y, coefficients);
        const int made = PRIV(admit_each)(limits, &end, &next);
        const PRIV(pose) sum = PRIV(pose_plus)(&added, 1, &end.adds);
        if (COIN_PRIV_RARELY(!made))
            break;
        added = sum;
        y = next;
    }
    const whole in_range =
        at_edge ? PRIV(pose_holds)(g, limits, &added) : ~none;
    if (!PRIV(every)(in_range != 0))
        return in_range;
    g->y = y;
    g->added = added;
    *steps += done;
    if (done == left)
        PRIV(end_block)(g);
    return done < most ? PRIV(admit_step)(limits, &end, &next) : ~none;
}
