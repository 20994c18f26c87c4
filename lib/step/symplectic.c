/* SPDX-License-Identifier: MIT */
#include "../motion/pinned.h"

#include "../motion/legendre.h"

#include "symplectic.h"

/* The two parts of the motion that can each be solved exactly: a kick changes
 * wX alone, a drift everything else with wX held.  Along a drift wY cos theta
 * and wZ follow theta by the linear pair, Eq. (33), so that K_Y and K_Z are
 * kept, and on their level set kick and drift are the exact flows of V(theta)
 * and P^2/(2J), Eq. (48): the composition is symplectic there. */

/* A step under way: the variables, what was added to the pose, and whether
 * every drift so far could be done. */
struct substep {
    coin_priv_variables y;
    coin_priv_pose adds;
    int sound;
};

/* What a step needs: the constants, and the equations for h = 1. */
struct split {
    const coin_priv_constants *b;
    coin_priv_field f;
    double h;
};

COIN_PRIV_INLINE void kick(struct substep *c, const struct split *k, double h)
{
    c->y.wX += h * coin_priv_slopes_at(&k->f, &c->y).wX; /* (50) */
}

/* Chin's kick: F + h^2/24 F dF/dtheta instead of F, over 2/3 h. */
COIN_PRIV_INLINE void modified_kick(struct substep *c, const struct split *k)
{
    const coin_priv_variables *y = &c->y;
    const coin_priv_constants *b = k->b;
    const double h = k->h, F = coin_priv_slopes_at(&k->f, y).wX;
    const double dF = coin_priv_fall_slope(b, y);
    c->y.wX += 2.0 / 3 * h * F * (1 + h * h / 24 * dF); /* (50) */
}

/* The integral of f over h from values and slopes at both ends: Hermite's
 * rule, symmetric and of order 4. */
COIN_PRIV_INLINE double hermite(double h, double f0, double f1, double df0,
                                double df1)
{
    return h / 2 * (f0 + f1) + h * h / 12 * (df0 - df1);
}

/* Computes wY and wZ at the lean of *y from those at that of *y0; the pair of
 * *y is that of *y0 plus `by`.  0 if that is beyond the series' reach. */
COIN_PRIV_INLINE int shift(coin_priv_variables *y,
                           const coin_priv_variables *y0, coin_priv_sc by,
                           const coin_priv_constants *b)
{
    const double c2 = y0->cth * y0->cth;
    double dp, dwZ;
    if (!(fabs(by.s) * (1 + fabs(y0->sth)) <= COIN_PRIV_SERIES_REACH * c2))
        return 0;
    coin_priv_legendre_change(&dp, &dwZ, y0->wY * y0->cth, y0->wZ, b->k1, b->k2,
                              y0->sth, c2, by.s); /* (49) */
    /* Where the lean does not change, wY does not either, to the bit: this form
     * of (49) adds 0 to it. */
    y->wY = y0->wY + (dp - y0->wY * by.c) * y->q;
    y->wZ = y0->wZ + dwZ;
    return 1;
}

/* d/dt of the velocity of the centre, Eq. (20), along a drift, in radii: along
 * e_X and along the horizontal e_h = (sin phi, 0, cos phi). */
struct acceleration {
    double X, h;
};

COIN_PRIV_INLINE struct acceleration acceleration_of(
    const coin_priv_constants *b, const coin_priv_variables *y, double dphi)
{
    const struct acceleration r = {
        y->wX * y->wY * (1 - b->k2),
        y->wZ * dphi - y->sth * (y->wX * y->wX),
    };
    return r;
}

/* Moves *c by a drift of h.  A function, whose code both methods share. */
COIN_PRIV_NOINLINE void drift(struct substep *c, const struct split *k,
                              double h)
{
    const coin_priv_variables y0 = c->y;
    const double turn = h * y0.wX; /* wX is constant */
    coin_priv_variables *const y = &c->y;
    const coin_priv_sc lean = {y0.sth, y0.cth}, heading = {y0.sph, y0.cph};
    const coin_priv_sc by = coin_priv_turn_adds(lean, turn);
    y->sth = y0.sth + by.s;
    y->cth = y0.cth + by.c;
    y->q = 1 / y->cth;
    y->tth = y->sth * y->q;
    c->sound &= fabs(turn) <= COIN_PRIV_TURN_MAX && y->cth > 0 &&
                shift(y, &y0, by, k->b);
    const coin_priv_pose v0 = coin_priv_pose_slopes(&k->f, &y0);
    coin_priv_pose v1 = coin_priv_pose_slopes(&k->f, y);
    const coin_priv_drift_slopes s0 = coin_priv_drift_slopes_of(k->b, &y0);
    const coin_priv_drift_slopes s1 = coin_priv_drift_slopes_of(k->b, y);
    const double dph = hermite(h, v0.phi, v1.phi, s0.phi, s1.phi);
    const coin_priv_sc ph = coin_priv_turned(heading, dph);
    y->sph = ph.s;
    y->cph = ph.c;
    v1 = coin_priv_pose_slopes(&k->f, y);
    c->adds.theta += turn;
    c->adds.phi += dph;
    c->adds.psi += hermite(h, v0.psi, v1.psi, s0.psi, s1.psi);
    const struct acceleration t0 = acceleration_of(k->b, &y0, v0.phi);
    const struct acceleration t1 = acceleration_of(k->b, y, v1.phi);
    c->adds.x += hermite(h, v0.x, v1.x, t0.h * y0.sph + t0.X * y0.cph,
                         t1.h * y->sph + t1.X * y->cph);
    c->adds.z += hermite(h, v0.z, v1.z, t0.h * y0.cph - t0.X * y0.sph,
                         t1.h * y->cph - t1.X * y->sph);
}

COIN_PRIV_INLINE struct substep begin(const coin_priv_variables *y)
{
    const struct substep c = {*y, {0, 0, 0, 0, 0, 0}, 1};
    return c;
}

COIN_PRIV_INLINE void end_at(coin_priv_step_end *end, coin_priv_variables *next,
                             const struct substep *c)
{
    *next = c->y;
    if (!c->sound)
        next->wZ = (double)INFINITY; /* so that the step is refused */
    end->wX = c->y.wX;
    end->wY = c->y.wY;
    end->wZ = c->y.wZ;
    end->adds = c->adds;
}

/* Stoermer-Verlet: V/2 T V/2. */
COIN_PRIV_INLINE void verlet(coin_priv_step_end *end, coin_priv_variables *next,
                             const coin_priv_variables *y, const void *split)
{
    const struct split *k = (const struct split *)split;
    struct substep c = begin(y);
    kick(&c, k, k->h / 2);
    drift(&c, k, k->h);
    kick(&c, k, k->h / 2);
    end_at(end, next, &c);
}

/* Chin's 4A: V/6 T/2 2V'/3 T/2 V/6, all steps forward. */
COIN_PRIV_INLINE void chin(coin_priv_step_end *end, coin_priv_variables *next,
                           const coin_priv_variables *y, const void *split)
{
    const struct split *k = (const struct split *)split;
    struct substep c = begin(y);
    kick(&c, k, k->h / 6);
    drift(&c, k, k->h / 2);
    modified_kick(&c, k);
    drift(&c, k, k->h / 2);
    kick(&c, k, k->h / 6);
    end_at(end, next, &c);
}

static struct split split_of(const coin_priv_run *r)
{
    const struct split k = {&r->b, coin_priv_field_of(&r->b, 1), r->dt};
    return k;
}

void coin_priv_symplectic2(coin_priv_run *r, uint64_t n)
{
    const struct split k = split_of(r);
    coin_priv_steps(r, n, verlet, &k);
}

void coin_priv_symplectic4(coin_priv_run *r, uint64_t n)
{
    const struct split k = split_of(r);
    coin_priv_steps(r, n, chin, &k);
}
