/* SPDX-License-Identifier: MIT */
#ifndef ROLLCOIN_RK4_H
#define ROLLCOIN_RK4_H

#include "motion.h"
#include "number.h"

/* a + w b, member by member. */
COIN_PRIV_INLINE coin_priv_stage coin_priv_stage_plus(const coin_priv_stage *a,
                                                      coin_priv_shared w,
                                                      const coin_priv_stage *b)
{
    const double sth = a->sth + w * b->sth, q = a->q + w * b->q;
    const coin_priv_stage r = {
        a->wX + w * b->wX,
        a->wY + w * b->wY,
        a->wZ + w * b->wZ,
        sth,
        a->cth + w * b->cth,
        q,
        q * sth,
        a->sph + w * b->sph,
        a->cph + w * b->cph,
    };
    return r;
}

/* The same for a pose; t stays 0, the steps count it. */
COIN_PRIV_INLINE coin_priv_pose coin_priv_pose_plus(const coin_priv_pose *a,
                                                    coin_priv_shared w,
                                                    const coin_priv_pose *b)
{
    const coin_priv_pose r = {
        a->phi + w * b->phi,
        a->psi + w * b->psi,
        a->x + w * b->x,
        a->z + w * b->z,
        a->t,
    };
    return r;
}

/* The coefficients for a step h. */
typedef struct coin_priv_rk4_slopes {
    coin_priv_field half, full, sixth;
} coin_priv_rk4_slopes;

/* One classical Runge-Kutta step.  The slopes are times h/2, h/2, h and h/6, so
 * that the classical sum is (d1 + 2 d2 + d3)/3 + d4, and nothing but the last
 * addition waits for the last slope. */
COIN_PRIV_INLINE double coin_priv_rk4_step(coin_priv_moment *next,
                                           const coin_priv_moment *c,
                                           const void *coefficients)
{
    const coin_priv_rk4_slopes *k = (const coin_priv_rk4_slopes *)coefficients;
    const coin_priv_stage y1 = c->y;
    coin_priv_stage sum = coin_priv_motion(&k->half, &y1);
    coin_priv_pose path = coin_priv_drift(&k->half, &y1);
    const coin_priv_stage y2 = coin_priv_stage_plus(&y1, 1, &sum);

    const coin_priv_stage d2 = coin_priv_motion(&k->half, &y2);
    const coin_priv_pose v2 = coin_priv_drift(&k->half, &y2);
    const coin_priv_stage y3 = coin_priv_stage_plus(&y1, 1, &d2);
    sum = coin_priv_stage_plus(&sum, 2, &d2);
    path = coin_priv_pose_plus(&path, 2, &v2);

    const coin_priv_stage d3 = coin_priv_motion(&k->full, &y3);
    const coin_priv_pose v3 = coin_priv_drift(&k->full, &y3);
    const coin_priv_stage y4 = coin_priv_stage_plus(&y1, 1, &d3);
    sum = coin_priv_stage_plus(&sum, 1, &d3);
    path = coin_priv_pose_plus(&path, 1, &v3);

    const coin_priv_stage d4 = coin_priv_motion(&k->sixth, &y4);
    const coin_priv_pose v4 = coin_priv_drift(&k->sixth, &y4);
    const coin_priv_stage y = coin_priv_stage_plus(&y1, 1.0 / 3, &sum);
    const coin_priv_pose pose = coin_priv_pose_plus(&c->pose, 1.0 / 3, &path);
    next->y = coin_priv_stage_plus(&y, 1, &d4);
    coin_priv_renew(&next->y);
    next->pose = coin_priv_pose_plus(&pose, 1, &v4);
    return coin_priv_lesser(coin_priv_lesser(y2.cth, y3.cth), y4.cth);
}

#endif
