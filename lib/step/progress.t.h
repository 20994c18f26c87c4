/* SPDX-License-Identifier: MIT */
/* How far a run has come. */
#include "../motion/equations.h"

#include "../motion/kind.h"

/* A sum and what its rounding left out. */
typedef struct PRIV(sum) {
    real sum, low;
} PRIV(sum);

/* Where a step leads: the rates, what it adds to the pose, and the least cos
 * theta of its stages. */
typedef struct PRIV(step_end) {
    real wX, wY, wZ;
    PRIV(pose) adds;
    real least_cth;
} PRIV(step_end);

/* A run under way: its variables, the pose where its block of steps began, and
 * what the steps since then have added to it.  A steady motion adds the same
 * again and again, and to one long sum it would always round alike.  x, z are
 * from where it started, in radii.  theta is in `added` alone, one plain sum as
 * wX, wY and wZ are: next to a steady motion all four change by less than their
 * rounding, and if one of them kept what the others lose, it would drift. */
typedef struct PRIV(progress) {
    PRIV(variables) y;
    PRIV(pose) added;
    PRIV(sum) phi, psi, x, z;
} PRIV(progress);

/* a + w b, member by member; the steps count the time. */
COIN_PRIV_INLINE PRIV(pose)
    PRIV(pose_plus)(const PRIV(pose) * a, scalar w, const PRIV(pose) * b)
{
    const PRIV(pose) r = {
        a->theta + w * b->theta, a->phi + w * b->phi, a->psi + w * b->psi,
        a->x + w * b->x,         a->z + w * b->z,     a->t,
    };
    return r;
}

/* Adds a part, by Knuth's exact sum. */
COIN_PRIV_PART void PRIV(add)(PRIV(sum) * to, real part)
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

/* The pair of an angle that a sum holds. */
COIN_PRIV_PART PRIV(sc) PRIV(angle_pair)(PRIV(sum) angle)
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
    /* Near the table the rounding of theta is much of cos theta. */
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

/* The variables at the end of a step, where the pairs are known. */
COIN_PRIV_INLINE PRIV(variables)
    PRIV(variables_at)(const PRIV(step_end) * end, PRIV(sc) th, PRIV(sc) ph)
{
    const real q = 1 / th.c;
    const PRIV(variables) next = {
        end->wX, end->wY, end->wZ, th.s, th.c, q, q * th.s, ph.s, ph.c,
    };
    return next;
}

/* The same, after a step from *y.  The pairs turn by what the step adds to the
 * angles: angles and pairs stay one to rounding, and a run of n steps is n runs
 * of one. */
COIN_PRIV_INLINE PRIV(variables)
    PRIV(variables_after)(const PRIV(variables) * y, const PRIV(step_end) * end)
{
    PRIV(sc) th = {y->sth, y->cth}, ph = {y->sph, y->cph};
    PRIV(turn_both)(&th, &ph, end->adds.theta, end->adds.phi);
    return PRIV(variables_at)(end, th, ph);
}

/* Where a run has come to: angles, and x, z [L] from where it started. */
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
