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

/* sin theta and cos theta after the step.  They are valid if |late| is at most
 * COIN_PRIV_LITTLE_TURN; otherwise the caller computes them.
 *
 * The next step waits for this pair.  So it is turned in two parts.  The first
 * is h wX after the first stage, which is most of the turn.  It needs nothing
 * of the other stages, and can be done during them.  `late` is the rest of the
 * turn. */
typedef struct PRIV(rk4_lean) {
    PRIV(sc) th;
    real late;
} PRIV(rk4_lean);

/* The slopes are times h/2, h/2, h and h/6, so that the classical sum is
 * (d1 + 2 d2 + d3)/3 + d4, and nothing but the last addition waits for the last
 * slope. */
COIN_PRIV_INLINE PRIV(step_end)
    PRIV(rk4_end)(PRIV(rk4_lean) * lean_after, const PRIV(variables) * y1,
                  const PRIV(rk4_fields) * k)
{
    PRIV(variables) sum = PRIV(slopes_at)(&k->half, y1), d;
    PRIV(pose) path = PRIV(pose_slopes)(&k->half, y1), v;
    PRIV(variables) y = PRIV(stage)(y1, &sum, path.phi);
    const real early = k->full.h * y.wX;
    real least = y.cth;

    d = PRIV(slopes_at)(&k->half, &y);
    v = PRIV(pose_slopes)(&k->half, &y);
    y = PRIV(stage)(y1, &d, v.phi);
    sum = PRIV(variables_plus)(&sum, 2, &d);
    path = PRIV(pose_plus)(&path, 2, &v);
    least = PRIV(lesser)(least, y.cth);

    d = PRIV(slopes_at)(&k->full, &y);
    v = PRIV(pose_slopes)(&k->full, &y);
    y = PRIV(stage)(y1, &d, v.phi);
    sum = PRIV(variables_plus)(&sum, 1, &d);
    path = PRIV(pose_plus)(&path, 1, &v);
    least = PRIV(lesser)(least, y.cth);

    d = PRIV(slopes_at)(&k->sixth, &y);
    v = PRIV(pose_slopes)(&k->sixth, &y);
    y = PRIV(variables_plus)(y1, K(1.0 / 3), &sum);
    const PRIV(pose) adds = PRIV(pose_plus)(&v, K(1.0 / 3), &path);
    const PRIV(step_end) end = {
        y.wX + d.wX, y.wY + d.wY, y.wZ + d.wZ, adds, least,
    };
    const PRIV(sc) lean = {y1->sth, y1->cth};
    const PRIV(sc) near = PRIV(turned)(lean, early);
    lean_after->late = adds.theta - early;
    lean_after->th = PRIV(turned_a_little)(near, lean_after->late);
    return end;
}

#ifndef COIN_PRIV_ABREAST
/* A step from *y: where it leads, and sine and cosine of the lean there. */
COIN_PRIV_INLINE PRIV(sc)
    PRIV(rk4_to)(PRIV(step_end) * end, const PRIV(variables) * y,
                 const PRIV(rk4_fields) * k)
{
    const PRIV(sc) lean = {y->sth, y->cth};
    PRIV(rk4_lean) after;
    *end = PRIV(rk4_end)(&after, y, k);
    if (COIN_PRIV_RARELY(!(FABS(after.late) <= COIN_PRIV_LITTLE_TURN)))
        return PRIV(turned)(lean, end->adds.theta);
    return after.th;
}
#endif
