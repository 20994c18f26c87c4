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
#include "params.h"

#include "kind.h"

/* The variables that the equations read. */
typedef struct coin_priv_variables {
    number wX, wY, wZ;
    number sth, cth, q, tth; /* sin theta, cos theta, 1/cos theta, tan theta */
    number sph, cph;         /* sin phi, cos phi: for the path alone */
} coin_priv_variables;

/* The variables that the equations change but never read.  x and z are in
 * radii; t is the time, used in Sundman's form alone. */
typedef struct coin_priv_pose {
    number theta, phi, psi, x, z, t;
} coin_priv_pose;

/* The coefficients of the equations of motion, times h but for XJ. */
typedef struct coin_priv_field {
    number h, GJ, KJ, XJ, k1, k2;
} coin_priv_field;

#ifndef COIN_PRIV_ABREAST
/* The variables of a state, inline in the caller.  The reduction of the lean to
 * |theta| <= pi/4 is left out for a lean that is in this range.  Its sine and
 * cosine are then known sooner, and a step cannot begin without them. */
COIN_PRIV_INLINE coin_priv_variables
coin_priv_variables_inline(const coin_state *s)
{
    const coin_priv_sc ph = coin_priv_sine_cosine(s->phi);
    const coin_priv_sc th = FABS(s->theta) <= K(0.5) * COIN_PRIV_HALF_PI
                                ? coin_priv_sine_cosine_reduced(s->theta, 0)
                                : coin_priv_sine_cosine(s->theta);
    const number q = 1 / th.c;
    const coin_priv_variables y = {
        s->wX, s->wY, s->wZ, th.s, th.c, q, q * th.s, ph.s, ph.c,
    };
    return y;
}

COIN_PRIV_INLINE coin_priv_field
coin_priv_field_of(const coin_priv_constants *b, number h)
{
    const coin_priv_field f = {
        h, h * b->GJ, h * b->KJ, b->XJ, h * b->k1, h * b->k2,
    };
    return f;
}
#endif

/* Sets *ds and *dc to the derivatives of the sine s and the cosine c of an
 * angle whose derivative is `rate`. */
COIN_PRIV_INLINE void coin_priv_turn_rates(number *ds, number *dc, number rate,
                                           number s, number c)
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
COIN_PRIV_INLINE coin_priv_variables
coin_priv_slopes_at(const coin_priv_field *f, const coin_priv_variables *y)
{
    const number wX = y->wX, wY = y->wY, wZ = y->wZ;
    const number sth = y->sth, cth = y->cth, q = y->q;
    const number hwX = f->h * wX, hwY = f->h * wY;
    const number hwYtan = hwY * y->tth;
    const number dph = hwY * q;
    const number none = {0};
    coin_priv_variables d;
    /* clang-format off */
    d.wX = f->GJ * sth - ((f->KJ * wZ) * wY + (f->XJ * wY) * hwYtan); /* (14) */
    d.wY = wX * (hwYtan + f->k1 * wZ);                       /* (15) */
    d.wZ = f->k2 * wX * wY;                                  /* (16) */
    d.q = q * q * (sth * hwX);                               /* (31) */
    d.tth = none; /* q sin theta, no variable of its own */
    /* clang-format on */
    coin_priv_turn_rates(&d.sth, &d.cth, hwX, sth, cth);       /* (31) */
    coin_priv_turn_rates(&d.sph, &d.cph, dph, y->sph, y->cph); /* (31) */
    return d;
}

/* The components along x and z of the velocity of the centre, -wZ e_X + wX e_Z
 * in radii.  wXcth is wX cos theta.  If wXcth and wZ are multiplied by h, the
 * velocity is too. */
COIN_PRIV_INLINE void coin_priv_path_rates(number *dx, number *dz, number wXcth,
                                           number wZ,
                                           const coin_priv_variables *y)
{
    const number s = y->sph, c = y->cph;
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
COIN_PRIV_INLINE coin_priv_pose
coin_priv_pose_slopes(const coin_priv_field *f, const coin_priv_variables *y)
{
    const number hwX = f->h * y->wX, hwY = f->h * y->wY, hwZ = f->h * y->wZ;
    const number none = {0};
    coin_priv_pose d;
    d.theta = hwX;              /* (17) */
    d.phi = hwY * y->q;         /* (18) */
    d.psi = hwZ + hwY * y->tth; /* (19) */
    coin_priv_path_rates(&d.x, &d.z, hwX * y->cth, hwZ, y);
    d.t = none;
    return d;
}

/* Normalizes the pairs after a step in tau, and computes q and tth from them.
 * The step leaves e = 1 - s^2 - c^2, of the size of its error.  Three terms of
 * (1 - e)^(-1/2) are taken; the next one, 5/16 e^3, is below rounding. */
COIN_PRIV_INLINE void coin_priv_normalize(coin_priv_variables *y)
{
    const number q = K(1) / y->cth;
    const number lean = K(1) - (y->sth * y->sth + y->cth * y->cth);
    const number turn = K(1) - (y->sph * y->sph + y->cph * y->cph);
    const number longer = K(0.5) + K(0.375) * lean;
    const number gain = turn * (K(0.5) + K(0.375) * turn);
    y->tth = y->sth * q;
    y->sth += (y->sth * lean) * longer;
    y->cth += (y->cth * lean) * longer;
    y->q = q - (q * lean) * (K(0.5) + K(0.125) * lean);
    y->sph += y->sph * gain;
    y->cph += y->cph * gain;
}

/* a + w b: the rates and the pair of the lean.  The other members are a's. */
COIN_PRIV_INLINE coin_priv_variables coin_priv_variables_plus(
    const coin_priv_variables *a, scalar w, const coin_priv_variables *b)
{
    coin_priv_variables r = *a;
    r.wX += w * b->wX;
    r.wY += w * b->wY;
    r.wZ += w * b->wZ;
    r.sth += w * b->sth;
    r.cth += w * b->cth;
    return r;
}

/* a + w b, member by member, but for t: steps in tau add that themselves. */
COIN_PRIV_INLINE coin_priv_pose coin_priv_pose_plus(const coin_priv_pose *a,
                                                    scalar w,
                                                    const coin_priv_pose *b)
{
    const coin_priv_pose r = {
        a->theta + w * b->theta, a->phi + w * b->phi, a->psi + w * b->psi,
        a->x + w * b->x,         a->z + w * b->z,     a->t,
    };
    return r;
}

/* The velocity of the centre along x, y, z: a (-wZ e_X + wX e_Z). */
COIN_PRIV_INLINE void coin_priv_velocity_of(number v[3], number a,
                                            const coin_priv_variables *y)
{
    number dx, dz;
    coin_priv_path_rates(&dx, &dz, y->cth * y->wX, y->wZ, y);
    v[0] = a * dx;
    v[1] = -a * (y->wX * y->sth); /* y = a cos theta */
    v[2] = a * dz;
}

/* W^2, where W measures how fast the coin turns and falls. */
COIN_PRIV_INLINE number coin_priv_rate2(number g_a,
                                        const coin_priv_variables *y)
{
    const number wX = y->wX, wY = y->wY, wZ = y->wZ, q = y->q;
    return (wX * wX + wY * wY) * (q * q) + (wZ * wZ + g_a * q); /* (47) */
}

/* Where a step leads: the rates, and what it adds to the pose. */
typedef struct coin_priv_step_end {
    number wX, wY, wZ;
    coin_priv_pose adds;
} coin_priv_step_end;

/* The variables at the end of a step, where the pairs are known. */
COIN_PRIV_INLINE coin_priv_variables coin_priv_variables_at(
    const coin_priv_step_end *end, coin_priv_sc th, coin_priv_sc ph)
{
    const number q = 1 / th.c;
    const coin_priv_variables next = {
        end->wX, end->wY, end->wZ, th.s, th.c, q, q * th.s, ph.s, ph.c,
    };
    return next;
}

/* The same, after a step from *y.  The pairs turn by what the step adds to the
 * angles.  So, to rounding, angles and pairs agree, and a run of n steps equals
 * n runs of one step. */
COIN_PRIV_INLINE coin_priv_variables coin_priv_variables_after(
    const coin_priv_variables *y, const coin_priv_step_end *end)
{
    coin_priv_sc th = {y->sth, y->cth}, ph = {y->sph, y->cph};
    coin_priv_turn_both(&th, &ph, end->adds.theta, end->adds.phi);
    return coin_priv_variables_at(end, th, ph);
}
