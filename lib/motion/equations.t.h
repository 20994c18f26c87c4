/* SPDX-License-Identifier: MIT */
/* The equations of motion, as slopes.  Some sources need other forms of them,
 * and contain these: step/extrapolation.c, for example, and the sources of
 * power series.  tests/lint/homes.py lists most of them.
 *
 * The sines and cosines of lean and heading are variables like the angular
 * velocity, so that no stage of a step takes a sine of an angle.  The pose is a
 * quadrature: no equation reads it.
 *
 * If COIN_PRIV_TURN_BY_PAIRS is defined, the rates of a sine and a cosine are
 * computed as one vector of two.  In step/rk8.c that is faster, in other
 * sources slower.
 *
 * The order of operations is pinned: about/selftest.c has the hash of what they
 * give. */
#include "angles.h"
#include "body.h"

#include "kind.h"

/* The variables that the equations read. */
typedef struct PRIV(variables) {
    real wX, wY, wZ;
    real sth, cth, q, tth; /* sin theta, cos theta, 1/cos theta, tan theta */
    real sph, cph;         /* sin phi, cos phi: for the path alone */
} PRIV(variables);

/* The variables that the equations change but never read.  x and z are in
 * radii; t is the time, used in Sundman's form alone. */
typedef struct PRIV(pose) {
    real theta, phi, psi, x, z, t;
} PRIV(pose);

/* The coefficients of the equations of motion, times h but for XJ. */
typedef struct PRIV(field) {
    real h, GJ, KJ, XJ, k1, k2;
} PRIV(field);

#ifndef COIN_PRIV_ABREAST
/* The variables of a state, inline in the caller.  The reduction of the lean to
 * |theta| <= pi/4 is left out for a lean that is in this range.  Its sine and
 * cosine are then known sooner, and a step cannot begin without them. */
COIN_PRIV_INLINE PRIV(variables) PRIV(variables_inline)(const COIN(state) * s)
{
    const PRIV(sc) ph = PRIV(sine_cosine)(s->phi);
    const PRIV(sc) th = FABS(s->theta) <= K(0.5) * COIN_PRIV_HALF_PI
                            ? PRIV(sine_cosine_reduced)(s->theta, 0)
                            : PRIV(sine_cosine)(s->theta);
    const real q = 1 / th.c;
    const PRIV(variables) y = {
        s->wX, s->wY, s->wZ, th.s, th.c, q, q * th.s, ph.s, ph.c,
    };
    return y;
}

COIN_PRIV_INLINE PRIV(field) PRIV(field_of)(const PRIV(body) * b, real h)
{
    const PRIV(field) f = {
        h, h * b->GJ, h * b->KJ, b->XJ, h * b->k1, h * b->k2,
    };
    return f;
}
#endif

/* Sets *ds and *dc to the derivatives of the sine s and the cosine c of an
 * angle whose derivative is `rate`. */
COIN_PRIV_INLINE void PRIV(turn_rates)(real *ds, real *dc, real rate, real s,
                                       real c)
{
#ifdef COIN_PRIV_TURN_BY_PAIRS
    const coin_pair d = coin_pair_of(rate, rate) * coin_pair_normal(s, c);
    *dc = d[0];
    *ds = d[1];
#else
    *ds = rate * c;
    *dc = -(rate * s);
#endif
}

/* h d/dt of the variables.  Factors are grouped so that chains of dependent
 * operations are short: a step takes as long as the longest of them. */
COIN_PRIV_INLINE PRIV(variables)
    PRIV(slopes_at)(const PRIV(field) * f, const PRIV(variables) * y)
{
    const real wX = y->wX, wY = y->wY, wZ = y->wZ;
    const real sth = y->sth, cth = y->cth, q = y->q;
    const real hwX = f->h * wX, hwY = f->h * wY;
    const real hwYtan = hwY * y->tth;
    const real dph = hwY * q;
    const real none = {0};
    PRIV(variables) d;
    /* clang-format off */
    d.wX = f->GJ * sth - ((f->KJ * wZ) * wY + (f->XJ * wY) * hwYtan); /* (14) */
    d.wY = wX * (hwYtan + f->k1 * wZ);                       /* (15) */
    d.wZ = f->k2 * wX * wY;                                  /* (16) */
    d.q = q * q * (sth * hwX);                               /* (31) */
    d.tth = none; /* q sin theta, no variable of its own */
    /* clang-format on */
    PRIV(turn_rates)(&d.sth, &d.cth, hwX, sth, cth);       /* (31) */
    PRIV(turn_rates)(&d.sph, &d.cph, dph, y->sph, y->cph); /* (31) */
    return d;
}

/* The components along x and z of the velocity of the centre, -wZ e_X + wX e_Z
 * in radii.  wXcth is wX cos theta.  If wXcth and wZ are multiplied by h, the
 * velocity is too. */
COIN_PRIV_INLINE void PRIV(path_rates)(real *dx, real *dz, real wXcth, real wZ,
                                       const PRIV(variables) * y)
{
    const real s = y->sph, c = y->cph;
#ifdef COIN_PRIV_TURN_BY_PAIRS
    const coin_pair d =
        coin_pair_of(wXcth, wXcth) * coin_pair_of(c, s) -
        coin_pair_of(wZ, wZ) * coin_pair_normal(s, c); /* (20) */
    *dz = d[0];
    *dx = d[1];
#else
    *dx = wXcth * s - wZ * c; /* (20) */
    *dz = wXcth * c + wZ * s; /* (20) */
#endif
}

/* h d/dt of the pose.  The path is that of the centre: the point of contact may
 * move on a circle while the centre rests. */
COIN_PRIV_INLINE PRIV(pose)
    PRIV(pose_slopes)(const PRIV(field) * f, const PRIV(variables) * y)
{
    const real hwX = f->h * y->wX, hwY = f->h * y->wY, hwZ = f->h * y->wZ;
    const real none = {0};
    PRIV(pose) d;
    d.theta = hwX;              /* (17) */
    d.phi = hwY * y->q;         /* (18) */
    d.psi = hwZ + hwY * y->tth; /* (19) */
    PRIV(path_rates)(&d.x, &d.z, hwX * y->cth, hwZ, y);
    d.t = none;
    return d;
}

/* Sundman's form: h d/dtau of the variables, with dt = cos theta dtau.  These
 * are the rates above times cos theta: cubic polynomials of variables that the
 * energy bounds, regular down to the table.  They do not contain q and tan
 * theta. */
COIN_PRIV_INLINE PRIV(variables)
    PRIV(sundman_slopes)(const PRIV(field) * f, const PRIV(variables) * y)
{
    const real wX = y->wX, wY = y->wY, wZ = y->wZ;
    const real sth = y->sth, cth = y->cth;
    const real cwX = cth * wX, cwZ = cth * wZ;
    const real hwY = f->h * wY, hcwX = f->h * cwX;
    const real hwYsin = hwY * sth, none = {0};
    PRIV(variables) d;
    /* clang-format off */
    d.wX = (f->GJ * sth) * cth
         - ((f->KJ * wY) * cwZ + (f->XJ * wY) * hwYsin);     /* (32) */
    d.wY = wX * (hwYsin + f->k1 * cwZ);                      /* (32) */
    d.wZ = (f->k2 * wY) * cwX;                               /* (32) */
    d.q = none;
    d.tth = none;
    /* clang-format on */
    PRIV(turn_rates)(&d.sth, &d.cth, hcwX, sth, cth);      /* (32) */
    PRIV(turn_rates)(&d.sph, &d.cph, hwY, y->sph, y->cph); /* (32) */
    return d;
}

/* h d/dtau of the pose and of the time. */
COIN_PRIV_INLINE PRIV(pose)
    PRIV(sundman_pose_slopes)(const PRIV(field) * f, const PRIV(variables) * y)
{
    const real hwY = f->h * y->wY, hc = f->h * y->cth;
    const real hcwZ = hc * y->wZ, none = {0};
    PRIV(pose) d;
    d.theta = none;              /* its sine and cosine are integrated */
    d.phi = hwY;                 /* (32) */
    d.psi = hcwZ + hwY * y->sth; /* (32) */
    PRIV(path_rates)(&d.x, &d.z, hc * (y->cth * y->wX), hcwZ, y);
    d.t = hc; /* (32) */
    return d;
}

/* Normalizes the pairs after a step in tau, and computes q and tth from them.
 * The step leaves e = 1 - s^2 - c^2, of the size of its error.  Three terms of
 * (1 - e)^(-1/2) are taken; the next one, 5/16 e^3, is below rounding. */
COIN_PRIV_INLINE void PRIV(normalize)(PRIV(variables) * y)
{
    const real q = K(1) / y->cth;
    const real lean = K(1) - (y->sth * y->sth + y->cth * y->cth);
    const real turn = K(1) - (y->sph * y->sph + y->cph * y->cph);
    const real longer = K(0.5) + K(0.375) * lean;
    const real gain = turn * (K(0.5) + K(0.375) * turn);
    y->tth = y->sth * q;
    y->sth += (y->sth * lean) * longer;
    y->cth += (y->cth * lean) * longer;
    y->q = q - (q * lean) * (K(0.5) + K(0.125) * lean);
    y->sph += y->sph * gain;
    y->cph += y->cph * gain;
}

/* a + w b: the rates and the pair of the lean.  The other members are a's. */
COIN_PRIV_INLINE PRIV(variables)
    PRIV(variables_plus)(const PRIV(variables) * a, scalar w,
                         const PRIV(variables) * b)
{
    PRIV(variables) r = *a;
    r.wX += w * b->wX;
    r.wY += w * b->wY;
    r.wZ += w * b->wZ;
    r.sth += w * b->sth;
    r.cth += w * b->cth;
    return r;
}

/* a + w b, member by member, but for t: steps in tau add that themselves. */
COIN_PRIV_INLINE PRIV(pose)
    PRIV(pose_plus)(const PRIV(pose) * a, scalar w, const PRIV(pose) * b)
{
    const PRIV(pose) r = {
        a->theta + w * b->theta, a->phi + w * b->phi, a->psi + w * b->psi,
        a->x + w * b->x,         a->z + w * b->z,     a->t,
    };
    return r;
}

/* The velocity of the centre along x, y, z: a (-wZ e_X + wX e_Z). */
COIN_PRIV_INLINE void PRIV(velocity_of)(real v[3], real a,
                                        const PRIV(variables) * y)
{
    real dx, dz;
    PRIV(path_rates)(&dx, &dz, y->cth * y->wX, y->wZ, y);
    v[0] = a * dx;
    v[1] = -a * (y->wX * y->sth); /* (20) */
    v[2] = a * dz;
}

/* W^2, where W measures how fast the coin turns and falls. */
COIN_PRIV_INLINE real PRIV(rate2)(real g_a, const PRIV(variables) * y)
{
    const real wX = y->wX, wY = y->wY, wZ = y->wZ, q = y->q;
    return (wX * wX + wY * wY) * (q * q) + (wZ * wZ + g_a * q); /* (47) */
}

/* Where a step leads: the rates, and what it adds to the pose. */
typedef struct PRIV(step_end) {
    real wX, wY, wZ;
    PRIV(pose) adds;
} PRIV(step_end);

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
 * angles.  So, to rounding, angles and pairs agree, and a run of n steps equals
 * n runs of one step. */
COIN_PRIV_INLINE PRIV(variables)
    PRIV(variables_after)(const PRIV(variables) * y, const PRIV(step_end) * end)
{
    PRIV(sc) th = {y->sth, y->cth}, ph = {y->sph, y->cph};
    PRIV(turn_both)(&th, &ph, end->adds.theta, end->adds.phi);
    return PRIV(variables_at)(end, th, ph);
}
