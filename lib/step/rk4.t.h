/* SPDX-License-Identifier: MIT */
/* The classical Runge-Kutta method.  The order of its operations is pinned by
 * about/selftest.c, as that of equations.t.h is. */
#include "../motion/equations.h"

#include "../motion/kind.h"

/* The coefficients for a step h: times h/2, h and h/6. */
typedef struct coin_priv_rk4_fields {
    coin_priv_field half, full, sixth;
} coin_priv_rk4_fields;

#ifndef COIN_PRIV_ABREAST
COIN_PRIV_INLINE coin_priv_rk4_fields
coin_priv_rk4_fields_of(const coin_priv_constants *b, number dt)
{
    const coin_priv_rk4_fields k = {
        coin_priv_field_of(b, dt / 2),
        coin_priv_field_of(b, dt),
        coin_priv_field_of(b, dt / 6),
    };
    return k;
}
#endif

/* A stage: the start plus a slope, with two exceptions.  1/cos theta is
 * computed by a division, and the pair of the heading is turned.  As the start
 * plus a slope they would have errors of tan^2 theta z^2 and z^3/6 for a turn
 * z, and so would the path. */
COIN_PRIV_INLINE coin_priv_variables coin_priv_stage(
    const coin_priv_variables *y1, const coin_priv_variables *d, number turn)
{
    const coin_priv_sc heading = {y1->sph, y1->cph};
    const coin_priv_sc ph = coin_priv_turned_a_little(heading, turn);
    coin_priv_variables y = coin_priv_variables_plus(y1, 1, d);
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
COIN_PRIV_INLINE coin_priv_sc coin_priv_lean_after(const coin_priv_variables *y,
                                                   number early, number turn)
{
    const coin_priv_sc lean = {y->sth, y->cth};
    const number late = turn - early;
    const coin_priv_sc th =
        coin_priv_turned_a_little(coin_priv_turned(lean, early), late);
    const number size = coin_priv_magnitude(late);
    if (COIN_PRIV_RARELY(!coin_priv_every(size <= K(COIN_PRIV_LITTLE_TURN)))) {
        const integer little =
            coin_priv_truth(size <= K(COIN_PRIV_LITTLE_TURN));
        const coin_priv_sc at_once = coin_priv_turned(lean, turn);
        const coin_priv_sc either = {
            coin_priv_choose(little, th.s, at_once.s),
            coin_priv_choose(little, th.c, at_once.c),
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
COIN_PRIV_INLINE coin_priv_sc coin_priv_rk4_to(coin_priv_step_end *end,
                                               const coin_priv_variables *y1,
                                               const coin_priv_rk4_fields *k)
{
    coin_priv_variables sum = coin_priv_slopes_at(&k->half, y1), d;
    coin_priv_pose path = coin_priv_pose_slopes(&k->half, y1), v;
    coin_priv_variables y = coin_priv_stage(y1, &sum, path.phi);
    const number early = k->full.h * y.wX;

    d = coin_priv_slopes_at(&k->half, &y);
    v = coin_priv_pose_slopes(&k->half, &y);
    y = coin_priv_stage(y1, &d, v.phi);
    sum = coin_priv_variables_plus(&sum, 2, &d);
    path = coin_priv_pose_plus(&path, 2, &v);

    d = coin_priv_slopes_at(&k->full, &y);
    v = coin_priv_pose_slopes(&k->full, &y);
    y = coin_priv_stage(y1, &d, v.phi);
    sum = coin_priv_variables_plus(&sum, 1, &d);
    path = coin_priv_pose_plus(&path, 1, &v);

    d = coin_priv_slopes_at(&k->sixth, &y);
    v = coin_priv_pose_slopes(&k->sixth, &y);
    y = coin_priv_variables_plus(y1, K(1.0 / 3), &sum);
    end->wX = y.wX + d.wX;
    end->wY = y.wY + d.wY;
    end->wZ = y.wZ + d.wZ;
    end->adds = coin_priv_pose_plus(&v, K(1.0 / 3), &path);
    return coin_priv_lean_after(y1, early, end->adds.theta);
}

COIN_PRIV_INLINE void coin_priv_rk4_step(coin_priv_step_end *end,
                                         coin_priv_variables *next,
                                         const coin_priv_variables *y,
                                         const void *fields)
{
    const coin_priv_sc heading = {y->sph, y->cph};
    const coin_priv_sc lean =
        coin_priv_rk4_to(end, y, (const coin_priv_rk4_fields *)fields);
    *next = coin_priv_variables_at(end, lean,
                                   coin_priv_turned(heading, end->adds.phi));
}
