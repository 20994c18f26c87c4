/* SPDX-License-Identifier: MIT */
#include "pinned.h"

#include "legendre.h"
#include "march.h"

/* The two halves of the motion that can each be solved exactly: a kick changes
 * wX alone, a drift everything else with wX held.  Along a drift (p, wZ)
 * follow theta by the linear pair, Eq. (33), so that K_Y and K_Z are kept, and
 * on their level set kick and drift are the exact flows of V(theta) and
 * P^2/(2J), Eq. (48): the composition is symplectic there. */

/* d(wX)/dt, the same expression as in Eq. (14). */
COIN_PRIV_INLINE double fall(const coin_priv_body *b, const coin_priv_stage *y)
{
    const double wYtan = y->wY * y->tth;
    return b->GJ * y->sth - y->wY * (b->KJ * y->wZ + b->XJ * wYtan); /* (14) */
}

/* d(wY)/d(theta) along a drift: Eq. (15) over wX. */
COIN_PRIV_INLINE double slope_wY(const coin_priv_body *b,
                                 const coin_priv_stage *y)
{
    return y->wY * y->tth + b->k1 * y->wZ; /* (15) */
}

COIN_PRIV_INLINE void kick(coin_priv_moment *c, const coin_priv_body *b,
                           double h)
{
    c->y.wX += h * fall(b, &c->y); /* (50) */
}

/* Chin's kick: F + h^2/24 F dF/dtheta instead of F, over 2/3 h. */
COIN_PRIV_INLINE void modified_kick(coin_priv_moment *c,
                                    const coin_priv_body *b, double h)
{
    const coin_priv_stage *y = &c->y;
    const double wY = y->wY, wZ = y->wZ, tth = y->tth;
    const double dwY = slope_wY(b, y), dwZ = b->k2 * wY;
    const double F = fall(b, y);
    const double dF = b->GJ * y->cth - b->KJ * (dwY * wZ + wY * dwZ) -
                      b->XJ * wY * (2 * dwY * tth + wY * (1 + tth * tth));
    c->y.wX += 2.0 / 3 * h * F * (1 + h * h / 24 * dF); /* (50) */
}

/* Rates of the pose and, along a drift, the rates of these. */
struct rates {
    double phi, psi, ddphi, ddpsi;
};

COIN_PRIV_INLINE struct rates rates_of(const coin_priv_body *b,
                                       const coin_priv_stage *y)
{
    const double wX = y->wX, wY = y->wY, tth = y->tth;
    const double dwY = slope_wY(b, y);
    const struct rates r = {
        wY * y->q,        /* (18) */
        y->wZ + wY * tth, /* (19) */
        wX * y->q * (dwY + wY * tth),
        wX * (b->k2 * wY + dwY * tth + wY * (1 + tth * tth)),
    };
    return r;
}

/* The integral of f over h from values and slopes at both ends: Hermite's
 * rule, symmetric and of order 4. */
COIN_PRIV_INLINE double hermite(double h, double f0, double f1, double df0,
                                double df1)
{
    return h / 2 * (f0 + f1) + h * h / 12 * (df0 - df1);
}

/* Moves *c by a drift of h; 0 if that leads to the table, or so near that the
 * pair's series does not reach. */
COIN_PRIV_INLINE int drift(coin_priv_moment *c, const coin_priv_body *b,
                           double h)
{
    const coin_priv_stage y0 = c->y;
    const struct rates r0 = rates_of(b, &y0);
    const double theta = c->theta + h * y0.wX; /* (17) */
    if (!(fabs(theta) < COIN_PRIV_HALF_PI))
        return 0;
    const coin_priv_sc th = coin_priv_sincos(theta);
    const double e = th.s - y0.sth, c2 = y0.cth * y0.cth;
    if (!(fabs(e) * (1 + fabs(y0.sth)) <= COIN_PRIV_SERIES_REACH * c2))
        return 0;
    coin_priv_stage y = y0;
    c->theta = theta;
    y.sth = th.s;
    y.cth = th.c;
    y.q = 1 / th.c;
    y.tth = th.s / th.c;
    coin_priv_legendre_shift(&c->p, &y.wZ, b->k1, b->k2, y0.sth, c2,
                             e); /* (49) */
    y.wY = c->p * y.q;
    const struct rates r1 = rates_of(b, &y);
    coin_priv_sum phi = {c->pose.phi, c->low};
    coin_priv_add(&phi, hermite(h, r0.phi, r1.phi, r0.ddphi, r1.ddphi));
    c->pose.phi = phi.sum;
    c->low = phi.low;
    c->pose.psi += hermite(h, r0.psi, r1.psi, r0.ddpsi, r1.ddpsi);
    const coin_priv_sc ph = coin_priv_sincos(c->pose.phi);
    y.sph = ph.s;
    y.cph = ph.c;
    c->pose.x += hermite(h, -r0.psi * y0.cph, -r1.psi * y.cph, /* (22) */
                         r0.psi * r0.phi * y0.sph - r0.ddpsi * y0.cph,
                         r1.psi * r1.phi * y.sph - r1.ddpsi * y.cph);
    c->pose.z += hermite(h, r0.psi * y0.sph, r1.psi * y.sph, /* (22) */
                         r0.psi * r0.phi * y0.cph + r0.ddpsi * y0.sph,
                         r1.psi * r1.phi * y.cph + r1.ddpsi * y.sph);
    c->y = y;
    return 1;
}

/* What a step needs: the body and h. */
struct split {
    const coin_priv_body *b;
    double h;
};

/* Stoermer-Verlet: V/2 T V/2. */
COIN_PRIV_INLINE double verlet_step(coin_priv_moment *next,
                                    const coin_priv_moment *c,
                                    const void *coefficients)
{
    const struct split *k = (const struct split *)coefficients;
    coin_priv_copy(next, c, sizeof *c);
    kick(next, k->b, k->h / 2);
    if (!drift(next, k->b, k->h))
        return 0;
    kick(next, k->b, k->h / 2);
    return next->y.cth;
}

/* Chin's 4A: V/6 T/2 2V'/3 T/2 V/6, all steps forward. */
COIN_PRIV_INLINE double chin_step(coin_priv_moment *next,
                                  const coin_priv_moment *c,
                                  const void *coefficients)
{
    const struct split *k = (const struct split *)coefficients;
    coin_priv_copy(next, c, sizeof *c);
    kick(next, k->b, k->h / 6);
    if (!drift(next, k->b, k->h / 2))
        return 0;
    modified_kick(next, k->b, k->h);
    if (!drift(next, k->b, k->h / 2))
        return 0;
    kick(next, k->b, k->h / 6);
    return next->y.cth;
}

void coin_priv_symplectic2(coin_priv_carry *c, const coin_priv_body *b,
                           coin_priv_limits *limits, double dt, uint64_t n)
{
    const struct split k = {b, dt};
    coin_priv_march(c, b, limits, n, verlet_step, &k);
}

void coin_priv_symplectic4(coin_priv_carry *c, const coin_priv_body *b,
                           coin_priv_limits *limits, double dt, uint64_t n)
{
    const struct split k = {b, dt};
    coin_priv_march(c, b, limits, n, chin_step, &k);
}
