/* SPDX-License-Identifier: MIT */
/* How far a run has come. */
#include "../motion/equations.h"

#include "../motion/kind.h"

/* A function that runs once per block of steps. */
#ifdef COIN_PRIV_BLOCKS_APART
#define COIN_PRIV_PER_BLOCK COIN_PRIV_NOINLINE
#else
#define COIN_PRIV_PER_BLOCK COIN_PRIV_INLINE
#endif

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
COIN_PRIV_PER_BLOCK void PRIV(end_block)(PRIV(progress) * g)
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
