/* SPDX-License-Identifier: MIT */
/* The classical Runge-Kutta method.  The order of its operations is pinned by
 * about/selftest.c, as that of equations.t.h is. */
#include "../motion/equations.h"

#include "../motion/kind.h"

/* The coefficients for a step h: times h/2, h and h/6. */
typedef struct PRIV(rk4_fields) {
    PRIV(field) half, full, sixth;
} PRIV(rk4_fields);

#ifndef COIN_PRIV_ABREAST
COIN_PRIV_INLINE PRIV(rk4_fields)
    PRIV(rk4_fields_of)(const PRIV(body) * b, real dt)
{
    const PRIV(rk4_fields) k = {
        PRIV(field_of)(b, dt / 2),
        PRIV(field_of)(b, dt),
        PRIV(field_of)(b, dt / 6),
    };
    return k;
}
#endif

/* A stage: the start plus a slope, with two exceptions.  1/cos theta is
 * computed by a division, and the pair of the heading is turned.  As the start
 * plus a slope they would have errors of tan^2 theta z^2 and z^3/6 for a turn
 * z, and so would the path. */
COIN_PRIV_INLINE PRIV(variables)
    PRIV(stage)(const PRIV(variables) * y1, const PRIV(variables) * d,
                real turn)
{
    const PRIV(sc) heading = {y1->sph, y1->cph};
    const PRIV(sc) ph = PRIV(turned_a_little)(heading, turn);
    PRIV(variables) y = PRIV(variables_plus)(y1, 1, d);
    y.sph = ph.s;
    y.cph = ph.c;
    y.q = K(1) / y.cth;
    y.tth = y.q * y.sth;
    return y;
}

/* Sine and cosine of the lean after a step from *y that turns it by `turn`.
 *
 * The next step waits for this pair.  So it is turned in two parts.  `early` is
 * most of the turn: h wX after the first stage.  It needs nothing of the other
 * stages, and the pair can be turned by it during them. */
COIN_PRIV_INLINE PRIV(sc)
    PRIV(lean_after)(const PRIV(variables) * y, real early, real turn)
{
    const PRIV(sc) lean = {y->sth, y->cth};
    const real late = turn - early;
    const PRIV(sc) th = PRIV(turned_a_little)(PRIV(turned)(lean, early), late);
    const real size = PRIV(magnitude)(late);
    if (COIN_PRIV_RARELY(!PRIV(every)(size <= K(COIN_PRIV_LITTLE_TURN)))) {
        const whole little = PRIV(truth)(size <= K(COIN_PRIV_LITTLE_TURN));
        const PRIV(sc) at_once = PRIV(turned)(lean, turn);
        const PRIV(sc) either = {
            PRIV(choose)(little, th.s, at_once.s),
            PRIV(choose)(little, th.c, at_once.c),
        };
        return either;
    }
    return th;
}

/* A step from *y1: where it leads, and sine and cosine of the lean there.
 *
 * The slopes are times h/2, h/2, h and h/6, so that the classical sum is
 * (d1 + 2 d2 + d3)/3 + d4, and nothing but the last addition waits for the last
 * slope. */
COIN_PRIV_INLINE PRIV(sc)
    PRIV(rk4_to)(PRIV(step_end) * end, const PRIV(variables) * y1,
                 const PRIV(rk4_fields) * k)
{
    PRIV(variables) sum = PRIV(slopes_at)(&k->half, y1), d;
    PRIV(pose) path = PRIV(pose_slopes)(&k->half, y1), v;
    PRIV(variables) y = PRIV(stage)(y1, &sum, path.phi);
    const real early = k->full.h * y.wX;

    d = PRIV(slopes_at)(&k->half, &y);
    v = PRIV(pose_slopes)(&k->half, &y);
    y = PRIV(stage)(y1, &d, v.phi);
    sum = PRIV(variables_plus)(&sum, 2, &d);
    path = PRIV(pose_plus)(&path, 2, &v);

    d = PRIV(slopes_at)(&k->full, &y);
    v = PRIV(pose_slopes)(&k->full, &y);
    y = PRIV(stage)(y1, &d, v.phi);
    sum = PRIV(variables_plus)(&sum, 1, &d);
    path = PRIV(pose_plus)(&path, 1, &v);

    d = PRIV(slopes_at)(&k->sixth, &y);
    v = PRIV(pose_slopes)(&k->sixth, &y);
    y = PRIV(variables_plus)(y1, K(1.0 / 3), &sum);
    end->wX = y.wX + d.wX;
    end->wY = y.wY + d.wY;
    end->wZ = y.wZ + d.wZ;
    end->adds = PRIV(pose_plus)(&v, K(1.0 / 3), &path);
    return PRIV(lean_after)(y1, early, end->adds.theta);
}

COIN_PRIV_INLINE void PRIV(rk4_step)(PRIV(step_end) * end,
                                     PRIV(variables) * next,
                                     const PRIV(variables) * y,
                                     const void *fields)
{
    const PRIV(sc) heading = {y->sph, y->cph};
    const PRIV(sc) lean =
        PRIV(rk4_to)(end, y, (const PRIV(rk4_fields) *)fields);
    *next = PRIV(variables_at)(end, lean, PRIV(turned)(heading, end->adds.phi));
}
