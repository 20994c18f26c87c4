/* SPDX-License-Identifier: MIT */
/* The equations of motion: the only place that knows them.
 *
 * The sines and cosines of lean and heading are variables of the motion like
 * the rates, so that no stage of a step calls a function or divides; the pose
 * is a quadrature that no equation reads. */
#ifndef ROLLCOIN_MOTION_H
#define ROLLCOIN_MOTION_H

#include "pinned.h"

/* What the equations read. */
typedef struct coin_priv_stage {
    double wX, wY, wZ;
    double sth, cth, q, tth; /* sin theta, cos theta, 1/cos theta, tan theta */
    double sph, cph;         /* sin phi, cos phi: for the path alone */
} coin_priv_stage;

/* What they only add to; x and z are of the point of contact, in radii; t is
 * the time, where it is not what the steps count. */
typedef struct coin_priv_pose {
    double phi, psi, x, z, t;
} coin_priv_pose;

/* What a step reads and writes.  The pairs hold the angles: theta, and phi up
 * to whole turns, which pose.phi counts. */
typedef struct coin_priv_moment {
    coin_priv_stage y;
    coin_priv_pose pose;
    double theta, p, low; /* of the symplectic methods; p = wY cos theta, low
                             what the sum of phi left out */
} coin_priv_moment;

/* The coefficients of the equations of motion, times h but for XJ. */
typedef struct coin_priv_field {
    double h, GJ, KJ, XJ, k1, k2;
} coin_priv_field;

/* h d/dt of a stage.  Factors are grouped so that no product waits for long:
 * a step takes as long as its longest chain of dependences. */
COIN_PRIV_INLINE coin_priv_stage coin_priv_motion(const coin_priv_field *f,
                                                  const coin_priv_stage *y)
{
    const double wX = y->wX, wY = y->wY, wZ = y->wZ;
    const double sth = y->sth, cth = y->cth, q = y->q;
    const double hwX = f->h * wX, hwY = f->h * wY; /* (17): d theta = hwX */
    const double hwYtan = hwY * y->tth;
    const double dph = hwY * q; /* (18) */
    const double none = {0};
    coin_priv_stage d;
    /* clang-format off */
    d.wX = f->GJ * sth - ((f->KJ * wZ) * wY + (f->XJ * wY) * hwYtan); /* (14) */
    d.wY = wX * (hwYtan + f->k1 * wZ);                       /* (15) */
    d.wZ = f->k2 * wX * wY;                                  /* (16) */
    d.sth = cth * hwX;                                       /* (31) */
    d.cth = -(sth * hwX);                                    /* (31) */
    d.q = q * q * (sth * hwX);                               /* (31) */
    d.tth = none; /* q sin theta, no variable of its own */
    d.sph = dph * y->cph;                                    /* (31) */
    d.cph = -(dph * y->sph);                                 /* (31) */
    /* clang-format on */
    return d;
}

/* h d/dt of the pose.  The point of contact moves along the heading, where
 * the centre's path has two terms. */
COIN_PRIV_INLINE coin_priv_pose coin_priv_drift(const coin_priv_field *f,
                                                const coin_priv_stage *y)
{
    const double hwY = f->h * y->wY;
    const double dps = f->h * y->wZ + hwY * y->tth; /* (19) */
    const double none = {0};
    coin_priv_pose d;
    d.phi = hwY * y->q; /* (18) */
    d.psi = dps;
    d.x = -(dps * y->cph); /* (22) */
    d.z = dps * y->sph;    /* (22) */
    d.t = none;
    return d;
}

/* Sundman's form: h d/dtau of a stage, with dt = cos theta dtau.  All of it is
 * the field above times cos theta: a cubic polynomial of variables that the
 * energy bounds, regular down to the table.  q and tan theta have no part. */
COIN_PRIV_INLINE coin_priv_stage coin_priv_sundman(const coin_priv_field *f,
                                                   const coin_priv_stage *y)
{
    const double wX = y->wX, wY = y->wY, wZ = y->wZ;
    const double sth = y->sth, cth = y->cth;
    const double cwX = cth * wX, cwZ = cth * wZ;
    const double hwY = f->h * wY, hcwX = f->h * cwX;
    const double hwYsin = hwY * sth, none = {0};
    coin_priv_stage d;
    /* clang-format off */
    d.wX = (f->GJ * sth) * cth
         - ((f->KJ * wY) * cwZ + (f->XJ * wY) * hwYsin);     /* (32) */
    d.wY = wX * (hwYsin + f->k1 * cwZ);                      /* (32) */
    d.wZ = (f->k2 * wY) * cwX;                               /* (32) */
    d.sth = cth * hcwX;                                      /* (32) */
    d.cth = -(sth * hcwX);                                   /* (32) */
    d.q = none;
    d.tth = none;
    d.sph = hwY * y->cph;                                    /* (32) */
    d.cph = -(hwY * y->sph);                                 /* (32) */
    /* clang-format on */
    return d;
}

/* h d/dtau of the pose and of the time. */
COIN_PRIV_INLINE coin_priv_pose
coin_priv_sundman_drift(const coin_priv_field *f, const coin_priv_stage *y)
{
    const double hwY = f->h * y->wY;
    const double dps = f->h * (y->cth * y->wZ) + hwY * y->sth; /* (32) */
    coin_priv_pose d;
    d.phi = hwY; /* (32) */
    d.psi = dps;
    d.x = -(dps * y->cph); /* (32) */
    d.z = dps * y->sph;    /* (32) */
    d.t = f->h * y->cth;   /* (32) */
    return d;
}

/* Brings the pairs back to the unit circle, and q and tth to theirs, so that
 * the angles alone tell the state, and a run of n steps is n runs of one.  A
 * step leaves e = 1 - s^2 - c^2 = O(h^5); of three terms of (1 - e)^(-1/2)
 * there remains 5/16 e^3, rounding for steps that are not coarse. */
COIN_PRIV_INLINE void coin_priv_renew(coin_priv_stage *y)
{
    const double q = 1 / y->cth;
    const double lean = 1 - (y->sth * y->sth + y->cth * y->cth);
    const double turn = 1 - (y->sph * y->sph + y->cph * y->cph);
    const double longer = 0.5 + 0.375 * lean;
    const double gain = turn * (0.5 + 0.375 * turn);
    y->tth = y->sth * q;
    y->sth += (y->sth * lean) * longer;
    y->cth += (y->cth * lean) * longer;
    y->q = q - (q * lean) * (0.5 + 0.125 * lean);
    y->sph += y->sph * gain;
    y->cph += y->cph * gain;
}

/* The velocity of the centre along x, y, z: a (-wZ e_X + wX e_Z). */
static inline void coin_priv_velocity(double v[3], double a,
                                      const coin_priv_stage *y)
{
    const double g = y->cth * y->wX;
    v[0] = a * (g * y->sph - y->wZ * y->cph); /* (20) */
    v[1] = -a * (y->wX * y->sth);             /* (20) */
    v[2] = a * (g * y->cph + y->wZ * y->sph); /* (20) */
}

/* The square of the fastest rate: of turning, heading and falling. */
COIN_PRIV_INLINE double coin_priv_rate2(double g_a, const coin_priv_stage *y)
{
    const double wX = y->wX, wY = y->wY, wZ = y->wZ;
    return (wX * wX + wY * wY) * (y->q * y->q) + wZ * wZ + g_a; /* (47) */
}

#endif
